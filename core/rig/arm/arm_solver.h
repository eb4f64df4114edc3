/// \file
/// Inverse kinematics of an arm, one step at a time, so that the approach can be shown and stepped through.
///
/// Transpose: angles += gain * transposed J * (target - tip), then clamped to the limits (SPEC C2).
/// LeastSquares: Levenberg-Marquardt. An angle that a step would push through a limit is put on the limit,
/// and the others are solved again (an active set). If the solver is stuck (a straight arm, a minimum behind
/// a limit), it tries further starts: from the arm stretched towards the target and from random angles (the
/// same ones every time). The arm only follows starts that come nearer. Targets out of reach are drawn in to
/// 0.999 of the reach, else the stretched arm would thrash.
#pragma once

#include "core/rig/arm/arm_chain.h"
#include <optional>

namespace ramure {

enum class ArmStatus : std::uint8_t {
    Moving,
    Reached, ///< the residual is within the tolerance
    Settled, ///< it is not, but no step brings the tip nearer
};

enum class ArmLimit : std::int8_t { Lower = -1, Free = 0, Upper = 1 };

/// ArmFigures keeps no more residuals than this.
inline constexpr std::size_t mostResiduals = 4096;

/// Figures since the target was set.
struct ArmFigures
{
    ArmStatus status = ArmStatus::Moving;
    double residual = 0.0;  ///< m, from the tip to the target
    std::int64_t steps = 0; ///< all iterations, including further starts
    int starts = 0;         ///< further starts from random angles
    std::vector<float>
        residuals; ///< m, before the first call of step() and after each; at most mostResiduals

    /// m short of a target that is not reached; 0 if it is reached, or if this is not known yet.
    [[nodiscard]] double shortBy() const { return status == ArmStatus::Settled ? residual : 0.0; }
};

/// Never gives an angle outside its limits nor a number that is not finite.
class ArmSolver
{
public:
    /// The angles of \p joints are clamped to their limits. \pre checkArm
    ArmSolver(std::span<const ArmJoint> joints, const ArmSolverParams& params);

    /// Other lengths, limits and speeds, from the present angles (clamped) on; starts counting anew.
    /// \pre checkArm; as many as before
    void setJoints(std::span<const ArmJoint> joints);
    /// Starts from these angles (clamped); the target stays. \pre two per joint, finite
    void setAngles(std::span<const double> angles);
    /// Goes on from these angles without counting anew: something slowed the step down. \pre as above
    void continueFrom(std::span<const double> angles);
    /// Sets the target in the arm's own space and starts counting anew. A target that is not finite counts as
    /// none.
    void setTarget(const glm::dvec3& target);
    /// One iteration, or one whole further start. \return whether there is more to do
    bool step();
    /// Steps until the end or \p most calls of step().
    ArmStatus solve(int most = 1000);

    [[nodiscard]] std::span<const double> angles() const { return m_angles; }
    [[nodiscard]] const ArmChain& chain() const { return m_chain; } ///< at angles()
    [[nodiscard]] const std::optional<glm::dvec3>& target() const { return m_target; }
    [[nodiscard]] const ArmFigures& figures() const { return m_figures; }
    /// Angles that lie on a limit.
    [[nodiscard]] ArmLimit limit(std::size_t angle) const;

private:
    /// Data and state of one iteration.
    struct Attempt
    {
        std::vector<double> angles;
        double damping = 0.0;
        double residual = 0.0; ///< m to the aim
        int slow = 0;          ///< iterations in a row that hardly helped
        bool over = false;
    };
    enum class Phase : std::uint8_t { Descend, Search, Polish, Done };

    void takeRules(std::span<const ArmJoint> joints);
    void transposeStep();
    void leastSquaresStep();
    void begin(Attempt& attempt, std::span<const double> angles);
    void iterate(Attempt& attempt);
    [[nodiscard]] double dampedMove(const Attempt& attempt);
    void solveFree(const glm::dvec3& error, double damping);
    bool holdAtLimits(std::span<const double> angles);
    void stretchTowardsAim();
    void drawAngles();
    void furtherStart();
    void adopt(const Attempt& attempt);
    void conclude();
    [[nodiscard]] double clamped(double angleRad, std::size_t angle) const;
    [[nodiscard]] double tolerance() const { return m_params.tolerance; }

    std::vector<ArmAngle> m_rules; ///< by angle
    ArmSolverParams m_params;
    ArmChain m_chain; ///< at m_angles
    ArmChain m_trial; ///< at angles that are tried
    std::vector<double> m_angles;
    std::optional<glm::dvec3> m_target;
    glm::dvec3 m_aim{0.0}; ///< the target, drawn in if it is out of reach
    ArmFigures m_figures;
    Phase m_phase = Phase::Done;
    int m_polish = 0;
    Attempt m_main, m_other;
    std::vector<glm::dvec3> m_columns; ///< J
    std::vector<double> m_move, m_tried;
    std::vector<unsigned char> m_held; ///< by angle: on its limit in this step
};

} // namespace ramure
