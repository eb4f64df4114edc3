/// \file
/// Inverse kinematics as a driver: the arm starts at its own angles at 0 s and follows a target that may
/// move.
#pragma once

#include "core/arm/arm_motion.h"
#include "core/pose/driver.h"
#include <functional>

namespace ramure {

/// The arm at one time.
struct ArmMoment
{
    std::vector<double> angles;
    ArmFigures figures;    ///< of the solver at the tick before
    double residual = 0.0; ///< m, from the arm's own tip, not the solver's, to the target
};

class ArmDriver : public PoseDriver
{
public:
    /// The target at a time, in the arm's own space; the same time always gives the same.
    using Target = std::function<glm::dvec3(double timeSeconds)>;
    /// \p target empty: the arm stands still. \pre checkArm
    ArmDriver(std::span<const ArmJoint> joints, const ArmSolverParams& params, Target target);

    [[nodiscard]] std::size_t boneCount() const override { return m_joints.size(); }
    Expected<void> poseAt(double timeSeconds, Pose& out, const Progress& progress) override;
    /// Errors as poseAt. Times beyond a day are an error too.
    Expected<ArmMoment> momentAt(double timeSeconds, const Progress& progress);

private:
    Expected<void> goTo(std::int64_t tick, const Progress& progress);

    std::vector<ArmJoint> m_joints;
    Target m_target;
    ArmMotion m_motion;
    std::vector<ArmMotion> m_snapshots; ///< every snapshotTicks, from tick 0 on
};

} // namespace ramure
