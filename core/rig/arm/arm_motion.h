/// \file
/// How an arm moves towards its target as time goes by.
///
/// Time goes in ticks of one sixtieth of a second whatever the frame rate; between two ticks the angles are
/// mixed, so that every frame rate sees the same path. A tick's turn is slowed as a whole until no angle
/// breaks its speed limit: the path keeps its direction. LeastSquares looks for the goal, a step a tick, and
/// the arm turns towards it; a target that is near, as one that glides away, is followed with as many steps
/// as that needs. Transpose walks its own way, stepsPerTick steps a tick.
#pragma once

#include "core/rig/arm/arm_solver.h"

namespace ramure {

inline constexpr double armTickSeconds = 1.0 / 60.0;

/// Copies are snapshots from which it goes on the same way.
class ArmMotion
{
public:
    /// Stands at the joints' angles. \pre checkArm
    ArmMotion(std::span<const ArmJoint> joints, const ArmSolverParams& params);

    /// Sets the joints from the next tick on. Their angles stay those of the arm. Angles that are \p pinned
    /// are taken from \p joints, and the solver leaves them alone. Setting the same joints again changes
    /// nothing. \pre checkArm; as many as before
    void setJoints(std::span<const ArmJoint> joints, std::span<const unsigned char> pinned);
    /// Counts from the next tick on. The same target again changes nothing. In the arm's own space.
    void setTarget(const glm::dvec3& target);
    void tick();

    [[nodiscard]] std::int64_t ticks() const { return m_ticks; }
    /// After the last tick, and before it.
    [[nodiscard]] std::span<const double> angles() const { return m_angles; }
    [[nodiscard]] std::span<const double> anglesBefore() const { return m_before; }
    /// Between the last two ticks, \p part from 0 to 1.
    [[nodiscard]] std::vector<double> anglesBetween(double part) const;
    /// Returns the solver. With LeastSquares it is ahead of the arm.
    [[nodiscard]] const ArmSolver& solver() const { return m_solver; }
    /// Neither the solver nor the arm has anything more to do for this target.
    [[nodiscard]] bool isStill() const { return m_still; }

private:
    void takeRules();
    void solveOneTick();

    std::vector<ArmJoint> m_joints;
    std::vector<unsigned char> m_pinned; ///< by angle
    ArmSolver m_solver;
    std::int64_t m_stepsPerTick;
    bool m_leadsSolver;                      ///< Transpose: the arm is where the solver is
    std::vector<double> m_mostTurn;          ///< by angle, rad a tick; infinity = any
    std::vector<unsigned char> m_turnsRound; ///< by angle: goes the shorter way round
    std::vector<double> m_angles, m_before;
    std::int64_t m_ticks = 0;
    bool m_still = true;
    bool m_more = false; ///< the solver has something to do
};

} // namespace ramure
