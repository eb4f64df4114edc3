/// \file
/// One row per number of an arm's joint: all that the program knows about it. The panel of joints, the
/// project file, tracks and the command line are made from these rows.
#pragma once

#include "core/params/param_def.h"
#include <optional>
#include <span>
#include <string_view>

namespace ramure {

struct JointDef
{
    const char* key;     ///< "phi.angle": project file and, behind "joints[2].", tracks
    const char* label;   ///< English, context "core"
    const char* tooltip; ///< one sentence, English, context "core"; with its unit
    ParamUnit unit;
    double hardMin, hardMax; ///< limits for editors and tracks; files may hold more
    double softMin, softMax; ///< the slider's range
    double step;
    int decimals;
    ArmAngle ArmJoint::*angle; ///< null: the length
    double ArmAngle::*member;  ///< null: the length

    [[nodiscard]] double& of(ArmJoint& joint) const { return angle ? (joint.*angle).*member : joint.length; }
    [[nodiscard]] double of(const ArmJoint& joint) const
    {
        return angle ? (joint.*angle).*member : joint.length;
    }
};

/// Length; angle, lower and upper limit and speed of phi; the same of theta.
std::span<const JointDef> jointTable();
/// The number of the row with this key, or nothing.
std::optional<std::size_t> jointNumber(std::string_view key);
/// The number of the row of the angle itself.
std::size_t jointAngleNumber(bool phi);

/// Repairs an angle after edits and tracks: an upper limit below the lower one is lifted to it, and a limited
/// angle is clamped to its limits.
void settleAngle(ArmAngle& angle);

} // namespace ramure
