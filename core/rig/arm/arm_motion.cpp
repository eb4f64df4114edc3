#include "core/rig/arm/arm_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

constexpr double nearPart = 0.05; ///< of the reach
constexpr int mostNearSteps = 10;

} // namespace

ArmMotion::ArmMotion(std::span<const ArmJoint> joints, const ArmSolverParams& params)
    : m_joints(joints.begin(), joints.end())
    , m_pinned(2 * joints.size(), 0)
    , m_solver(joints, params)
    , m_stepsPerTick(params.stepsPerTick)
    , m_leadsSolver(params.kind == ArmSolverKind::Transpose)
    , m_angles(m_solver.angles().begin(), m_solver.angles().end())
    , m_before(m_angles)
{
    for (ArmJoint& joint : m_joints)
        joint.phi.angleRad = joint.theta.angleRad = 0.0; // m_angles has them
    takeRules();
}

void ArmMotion::takeRules()
{
    m_mostTurn.clear();
    m_turnsRound.clear();
    for (const ArmJoint& joint : m_joints)
        for (const ArmAngle& angle : {joint.phi, joint.theta}) {
            m_mostTurn.push_back(angle.mostSpeed > 0.0 ? angle.mostSpeed * armTickSeconds
                                                       : std::numeric_limits<double>::infinity());
            m_turnsRound.push_back(angle.limited ? 0 : 1);
        }
}

/// A pinned angle is one whose limits leave it nothing.
void ArmMotion::setJoints(std::span<const ArmJoint> joints, std::span<const unsigned char> pinned)
{
    std::vector<ArmJoint> next(joints.begin(), joints.end());
    for (std::size_t i = 0; i < 2 * next.size(); ++i) {
        ArmAngle& angle = i % 2 == 0 ? next[i / 2].phi : next[i / 2].theta;
        if (pinned[i]) {
            angle.limited = true;
            angle.minRad = angle.maxRad = angle.angleRad;
        } else
            angle.angleRad = 0.0; // where the arm is counts
    }
    if (next == m_joints)
        return;
    m_joints = std::move(next);
    m_pinned.assign(pinned.begin(), pinned.end());
    takeRules();
    m_solver.setJoints(m_joints);
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
        const ArmAngle& rule = i % 2 == 0 ? m_joints[i / 2].phi : m_joints[i / 2].theta;
        if (rule.limited && !m_pinned[i])
            m_angles[i] = std::clamp(m_angles[i], rule.minRad, rule.maxRad);
    }
    if (m_leadsSolver)
        m_solver.continueFrom(m_angles);
    m_still = false;
    m_more = m_solver.target().has_value();
}

void ArmMotion::setTarget(const glm::dvec3& target)
{
    if (m_solver.target() == target)
        return;
    m_solver.setTarget(target);
    m_more = true;
    m_still = false;
}

void ArmMotion::solveOneTick()
{
    if (m_leadsSolver) {
        for (std::int64_t i = 0; i < m_stepsPerTick && m_more; ++i)
            m_more = m_solver.step();
        return;
    }
    const double near = nearPart * m_solver.chain().reach();
    for (int i = 0; i == 0 || (i < mostNearSteps && m_more && m_solver.figures().starts == 0 &&
                               m_solver.figures().residual < near);
         ++i)
        m_more = m_solver.step();
}

void ArmMotion::tick()
{
    ++m_ticks;
    m_before = m_angles;
    if (m_still)
        return;
    solveOneTick();
    double over = 1.0;
    std::vector<double> turns(m_angles.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const double way = m_solver.angles()[i] - m_angles[i];
        turns[i] = m_turnsRound[i] ? wrappedAngle(way) : way;
        if (!m_pinned[i])
            over = std::max(over, std::abs(turns[i]) / m_mostTurn[i]);
    }
    const bool arrives = over <= 1.0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        if (arrives || m_pinned[i])
            m_angles[i] = m_solver.angles()[i];
        else
            m_angles[i] =
                m_turnsRound[i] ? wrappedAngle(m_angles[i] + turns[i] / over) : m_angles[i] + turns[i] / over;
    }
    // A slowed transpose goes on from where the arm has come to.
    if (m_leadsSolver && !arrives) {
        m_solver.continueFrom(m_angles);
        m_more = true;
    }
    m_still = !m_more && arrives;
}

std::vector<double> ArmMotion::anglesBetween(double part) const
{
    std::vector<double> angles(m_angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double way = m_angles[i] - m_before[i];
        angles[i] =
            m_turnsRound[i] ? wrappedAngle(m_before[i] + part * wrappedAngle(way)) : m_before[i] + part * way;
    }
    return angles;
}

} // namespace ramure
