#include "core/rig/arm/arm_solver.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/rig/arm/damped_step.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double drawnIn = 0.999;
constexpr double firstDamping = 0.05; ///< of the reach
constexpr double leastDamping = 1e-7, mostDamping = 10.0;
constexpr double mostTurn = 1.5;  ///< rad that the largest angle of one step turns
constexpr double slowGain = 0.98; ///< residual after / before, over which a step hardly helped
constexpr int mostSlow = 6;
constexpr int descentSteps = 20, furtherStarts = 16, startSteps = 40, polishSteps = 10;
constexpr double smallBend = 0.1; ///< rad
constexpr double stillRad = 1e-9; ///< an arm whose angles move less stands still

} // namespace

ArmSolver::ArmSolver(std::span<const ArmJoint> joints, const ArmSolverParams& params)
    : m_params(params)
    , m_chain(joints)
    , m_trial(joints)
    , m_columns(2 * joints.size())
    , m_move(2 * joints.size())
    , m_tried(2 * joints.size())
    , m_held(2 * joints.size())
{
    takeRules(joints);
    setAngles(armAngles(joints));
}

void ArmSolver::takeRules(std::span<const ArmJoint> joints)
{
    m_rules.clear();
    m_rules.reserve(2 * joints.size());
    for (const ArmJoint& joint : joints) {
        m_rules.push_back(joint.phi);
        m_rules.push_back(joint.theta);
    }
}

void ArmSolver::setJoints(std::span<const ArmJoint> joints)
{
    takeRules(joints);
    m_chain = ArmChain(joints);
    m_trial = m_chain;
    setAngles(std::vector<double>(m_angles));
}

double ArmSolver::clamped(double angleRad, std::size_t angle) const
{
    const ArmAngle& rule = m_rules[angle];
    return rule.limited ? std::clamp(angleRad, rule.minRad, rule.maxRad) : wrappedAngle(angleRad);
}

ArmLimit ArmSolver::limit(std::size_t angle) const
{
    const ArmAngle& rule = m_rules[angle];
    if (!rule.limited)
        return ArmLimit::Free;
    if (m_angles[angle] >= rule.maxRad)
        return ArmLimit::Upper;
    return m_angles[angle] <= rule.minRad ? ArmLimit::Lower : ArmLimit::Free;
}

void ArmSolver::setAngles(std::span<const double> angles)
{
    m_angles.assign(angles.begin(), angles.end());
    for (std::size_t i = 0; i < m_angles.size(); ++i)
        m_angles[i] = clamped(m_angles[i], i);
    m_chain.setAngles(m_angles);
    if (m_target)
        setTarget(*m_target);
}

void ArmSolver::continueFrom(std::span<const double> angles)
{
    for (std::size_t i = 0; i < m_angles.size(); ++i)
        m_angles[i] = clamped(angles[i], i);
    m_chain.setAngles(m_angles);
    if (!m_target)
        return;
    m_figures.residual = glm::distance(m_chain.tip(), *m_target);
    m_figures.status = ArmStatus::Moving;
    m_phase = Phase::Descend;
    m_polish = 0;
    begin(m_main, m_angles);
}

void ArmSolver::setTarget(const glm::dvec3& target)
{
    m_figures = {};
    m_phase = Phase::Done;
    m_target.reset();
    const double distance = glm::length(target);
    if (!std::isfinite(distance)) {
        m_figures.status = ArmStatus::Settled;
        return;
    }
    m_target = target;
    m_aim = target;
    const glm::dvec3 outwards = distance > 0.0 ? target / distance : glm::dvec3(0.0, 0.0, 1.0);
    if (distance > m_chain.reach() * (1.0 - 1e-9))
        m_aim = outwards * (drawnIn * m_chain.reach());
    else if (distance < m_chain.leastReach())
        m_aim = outwards * (m_chain.leastReach() + (1.0 - drawnIn) * m_chain.reach());
    m_figures.residual = glm::distance(m_chain.tip(), target);
    m_figures.residuals.push_back(static_cast<float>(m_figures.residual));
    m_phase = Phase::Descend;
    m_polish = 0;
    begin(m_main, m_angles);
    if (m_figures.residual <= tolerance())
        conclude();
}

ArmStatus ArmSolver::solve(int most)
{
    for (int i = 0; i < most && step(); ++i) {
    }
    return m_figures.status;
}

bool ArmSolver::step()
{
    if (m_phase == Phase::Done)
        return false;
    if (m_params.kind == ArmSolverKind::Transpose)
        transposeStep();
    else
        leastSquaresStep();
    m_figures.residual = glm::distance(m_chain.tip(), *m_target);
    if (m_figures.residuals.size() < mostResiduals)
        m_figures.residuals.push_back(static_cast<float>(m_figures.residual));
    if (m_figures.residual <= tolerance())
        m_phase = Phase::Done;
    if (m_phase == Phase::Done)
        conclude();
    return m_phase != Phase::Done;
}

void ArmSolver::conclude()
{
    m_phase = Phase::Done;
    m_figures.status = m_figures.residual <= tolerance() ? ArmStatus::Reached : ArmStatus::Settled;
}

void ArmSolver::transposeStep()
{
    ++m_figures.steps;
    m_chain.jacobian(m_columns);
    const glm::dvec3 error = *m_target - m_chain.tip();
    double most = 0.0;
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
        // Only a gain or a distance beyond all sense makes a step of more than a few turns.
        const double turn = std::clamp(m_params.gain * glm::dot(m_columns[i], error), -100.0, 100.0);
        const double angle = clamped(m_angles[i] + turn, i);
        most = std::max(most, std::abs(wrappedAngle(angle - m_angles[i])));
        m_angles[i] = angle;
    }
    m_chain.setAngles(m_angles);
    if (most <= 1e-3 * stillRad)
        m_phase = Phase::Done;
}

void ArmSolver::leastSquaresStep()
{
    switch (m_phase) {
    case Phase::Descend:
    case Phase::Polish:
        iterate(m_main);
        adopt(m_main);
        ++m_polish;
        if (m_main.over || m_polish >= (m_phase == Phase::Descend ? descentSteps : polishSteps)) {
            // A target out of reach is as near as it gets; but the descent may have stopped short of its aim.
            m_phase =
                m_main.residual <= tolerance() || m_phase == Phase::Polish ? Phase::Done : Phase::Search;
            m_polish = 0;
        }
        break;
    case Phase::Search:
        furtherStart();
        if (m_main.residual <= tolerance())
            m_phase = Phase::Done;
        else if (m_figures.starts >= furtherStarts) {
            m_phase = Phase::Polish;
            m_main.over = false;
            m_main.slow = 0;
        }
        break;
    case Phase::Done:
        break;
    }
}

void ArmSolver::begin(Attempt& attempt, std::span<const double> angles)
{
    attempt.angles.assign(angles.begin(), angles.end());
    m_trial.setAngles(attempt.angles);
    attempt.residual = glm::distance(m_trial.tip(), m_aim);
    attempt.damping = firstDamping * m_chain.reach();
    attempt.slow = 0;
    attempt.over = attempt.residual <= tolerance() * 0.5;
}

/// The way to targets that only an almost straight arm reaches; bent to and fro, since a straight one knows
/// no direction but its own.
void ArmSolver::stretchTowardsAim()
{
    const double aside = maths::hypot(m_aim.x, m_aim.y);
    std::fill(m_tried.begin(), m_tried.end(), 0.0);
    m_tried[0] = aside > 0.0 ? maths::atan2(m_aim.y, m_aim.x) : 0.0;
    m_tried[1] = maths::atan2(aside, m_aim.z);
    for (std::size_t j = 1; j < m_chain.jointCount(); ++j)
        m_tried[2 * j + 1] = j % 2 == 1 ? smallBend : -smallBend;
    for (std::size_t i = 0; i < m_tried.size(); ++i)
        m_tried[i] = clamped(m_tried[i], i);
}

void ArmSolver::drawAngles()
{
    Random random(1, RandomStream::ArmStart, static_cast<std::uint64_t>(m_figures.starts));
    for (std::size_t i = 0; i < m_tried.size(); ++i) {
        const ArmAngle& rule = m_rules[i];
        m_tried[i] = rule.limited ? random.range(rule.minRad, rule.maxRad) : random.range(-pi, pi);
    }
}

void ArmSolver::furtherStart()
{
    if (m_figures.starts == 0)
        stretchTowardsAim();
    else
        drawAngles();
    ++m_figures.starts;
    begin(m_other, m_tried);
    for (int i = 0; i < startSteps && !m_other.over; ++i)
        iterate(m_other);
    if (m_other.residual < 0.999 * m_main.residual) {
        std::swap(m_main, m_other);
        adopt(m_main);
    }
}

void ArmSolver::adopt(const Attempt& attempt)
{
    m_angles = attempt.angles;
    m_chain.setAngles(m_angles);
}

/// \return the length of what moves by m_move, rad, largest angle
double ArmSolver::dampedMove(const Attempt& attempt)
{
    m_trial.jacobian(m_columns);
    std::fill(m_held.begin(), m_held.end(), static_cast<unsigned char>(0));
    const glm::dvec3 error = m_aim - m_trial.tip();
    for (std::size_t pass = 0; pass <= m_move.size(); ++pass) {
        solveFree(error, attempt.damping);
        if (!holdAtLimits(attempt.angles))
            break;
    }
    double most = 0.0;
    for (const double move : m_move)
        most = std::max(most, std::abs(move));
    if (most > mostTurn)
        for (double& move : m_move)
            move *= mostTurn / most;
    return std::min(most, mostTurn);
}

/// The damped step of the angles that are not held, given what the held ones do.
void ArmSolver::solveFree(const glm::dvec3& error, double damping)
{
    glm::dmat3 normal(damping * damping);
    glm::dvec3 left = error;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const glm::dvec3& c = m_columns[i];
        if (m_held[i])
            left -= m_move[i] * c;
        else
            normal += glm::dmat3(c * c.x, c * c.y, c * c.z);
    }
    const glm::dvec3 pull = solvedSymmetric(normal, left);
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        if (!m_held[i])
            m_move[i] = glm::dot(m_columns[i], pull);
}

bool ArmSolver::holdAtLimits(std::span<const double> angles)
{
    bool any = false;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const ArmAngle& rule = m_rules[i];
        if (m_held[i] || !rule.limited)
            continue;
        const double to = std::clamp(angles[i] + m_move[i], rule.minRad, rule.maxRad);
        if (to == angles[i] + m_move[i])
            continue;
        m_move[i] = to - angles[i];
        m_held[i] = 1;
        any = true;
    }
    return any;
}

/// \pre m_trial stands at the attempt's angles or anywhere
void ArmSolver::iterate(Attempt& attempt)
{
    ++m_figures.steps;
    m_trial.setAngles(attempt.angles);
    const double most = dampedMove(attempt);
    for (std::size_t i = 0; i < m_tried.size(); ++i)
        m_tried[i] = clamped(attempt.angles[i] + m_move[i], i);
    m_trial.setAngles(m_tried);
    const double residual = glm::distance(m_trial.tip(), m_aim);
    const bool better = residual < attempt.residual;
    attempt.slow = better && residual < slowGain * attempt.residual ? 0 : attempt.slow + 1;
    if (better) {
        attempt.angles = m_tried;
        attempt.residual = residual;
    }
    const double reach = m_chain.reach();
    attempt.damping = std::clamp(better ? attempt.damping / 3.0 : attempt.damping * 4.0, leastDamping * reach,
                                 mostDamping * reach);
    attempt.over = attempt.residual <= 0.5 * tolerance() || attempt.slow >= mostSlow || most <= stillRad;
}

} // namespace ramure
