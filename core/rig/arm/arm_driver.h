/// \file
/// Inverse kinematics as a driver: the arm starts at its own angles at 0 s and follows a target that may
/// move, with joints that may change meanwhile.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/rig/arm/arm_motion.h"
#include "core/rig/tracks/node_animation.h"
#include <functional>

namespace ramure {

/// The inputs of an arm at one time.
struct ArmGiven
{
    std::vector<ArmJoint> joints;
    std::optional<glm::dvec3> target;  ///< its own space; nothing: the joints' angles alone decide
    std::vector<unsigned char> pinned; ///< by angle: it is the joint's, whatever the target
};

/// The arm at one time.
struct ArmMoment
{
    std::vector<ArmJoint> joints; ///< at that time, with its angles
    std::vector<double> angles;
    std::optional<glm::dvec3> target;
    ArmFigures figures;           ///< the solver's figures at the tick before
    double residual = 0.0;        ///< m, from the arm's own tip, not the solver's, to the target
    std::vector<float> residuals; ///< m, the same by ticks up to this one; the last 4096 at most
};

class ArmDriver
{
public:
    /// The target at a time, in the arm's own space; the same time always gives the same.
    using Target = std::function<glm::dvec3(double timeSeconds)>;
    /// All of it; likewise. Always as many joints, all with a target or none. \pre checkArm
    using Source = std::function<ArmGiven(double timeSeconds)>;
    /// \p target empty: the arm stands still. \pre checkArm
    ArmDriver(std::span<const ArmJoint> joints, const ArmSolverParams& params, Target target);
    ArmDriver(Source source, const ArmSolverParams& params);

    /// The same for any order of times; those before 0 give that at 0. Errors: Invalid (not a finite time, or
    /// beyond a day), Cancelled.
    Expected<ArmMoment> momentAt(double timeSeconds, const Progress& progress);

private:
    Expected<void> goTo(std::int64_t tick, const Progress& progress);
    void keepSnapshot();
    [[nodiscard]] double residualNow(const ArmGiven& given) const;

    Source m_source;
    ArmMotion m_motion;
    std::vector<ArmMotion> m_snapshots; ///< every m_snapshotTicks, from tick 0 on
    std::int64_t m_snapshotTicks;
    std::vector<float> m_residuals; ///< m, after each tick that was ever made
};

/// A node's joints and target as their tracks have them at a time. Angles with tracks are pinned, and there
/// is a target where the arm follows it. \pre checkArm of the joints
ArmDriver::Source armSource(const NodeParams& params, const NodeAnimation& animation);
/// The arm of a node, driven by armSource(). \pre checkArm of the joints
ArmDriver armDriver(const NodeParams& params, const NodeAnimation& animation);

} // namespace ramure
