/// \file
/// One arm's motion: its driver, with the end of a seamless loop blended into its beginning. For the player
/// and for files alike.
#pragma once

#include "core/evaluate/node_motion.h"
#include "core/rig/arm/arm_driver.h"
#include <optional>
#include <span>

namespace ramure {

class ArmRun final : public NodeRun
{
public:
    /// Sets the arm that moves from now on. The run goes on if joints, target and tracks are the same as
    /// before. \pre checkArm(params) has no error
    void set(const NodeParams& params, const NodeAnimation& animation);
    /// Returns the state of the arm at a time. \pre set() was called; this holds for the next function too.
    Expected<ArmMoment> momentAt(double seconds, const TimelineSettings& timeline, const Progress& progress);
    Expected<NodeMotion> motionAt(double seconds, const TimelineSettings& timeline,
                                  const Progress& progress) override;

private:
    NodeParams m_params;
    NodeAnimation m_animation;
    std::optional<ArmDriver> m_driver;
};

/// Tells which of \p angles lie on a limit of their joints.
std::vector<ArmLimit> armLimits(std::span<const ArmJoint> joints, std::span<const double> angles);

/// Returns the meshes of an arm with these joints.
NodeMotion armMotion(const NodeParams& params, std::span<const ArmJoint> joints);

} // namespace ramure
