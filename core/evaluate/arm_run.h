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
    /// What moves from now on; the run goes on where its joints, target and tracks are the same as before.
    /// \pre checkArm
    void set(const NodeParams& params, const NodeAnimation& animation);
    /// \pre set() was called; likewise of the next.
    Expected<ArmMoment> momentAt(double seconds, const TimelineSettings& timeline, const Progress& progress);
    Expected<NodeMotion> motionAt(double seconds, const TimelineSettings& timeline,
                                  const Progress& progress) override;

private:
    NodeParams m_params;
    NodeAnimation m_animation;
    std::optional<ArmDriver> m_driver;
};

/// Which of \p angles lie on a limit of their joints.
std::vector<ArmLimit> armLimits(std::span<const ArmJoint> joints, std::span<const double> angles);

/// An arm with these joints.
NodeMotion armMotion(const NodeParams& params, std::span<const ArmJoint> joints);

} // namespace ramure
