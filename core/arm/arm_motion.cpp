#include "core/arm/arm_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {

ArmMotion::ArmMotion(std::span<const ArmJoint> joints, const ArmSolverParams& params)
    : m_solver(joints, params)
    , m_stepsPerTick(params.stepsPerTick)
    , m_leadsSolver(params.kind == ArmSolverKind::Transpose)
    , m_angles(m_solver.angles().begin(), m_solver.angles().end())
    , m_before(m_angles)
{
    for (const ArmJoint& joint : joints)
        for (const ArmAngle& angle : {joint.phi, joint.theta}) {
            m_mostTurn.push_back(angle.mostSpeed > 0.0 ? angle.mostSpeed * armTickSeconds
                                                       : std::numeric_limits<double>::infinity());
            m_turnsRound.push_back(angle.limited ? 0 : 1);
        }
}

void ArmMotion::setTarget(const glm::dvec3& target)
{
    if (m_solver.target() == target)
        return;
    m_solver.setTarget(target);
    m_still = false;
}

void ArmMotion::tick()
{
    ++m_ticks;
    m_before = m_angles;
    if (m_still)
        return;
    bool more = false;
    for (std::int64_t i = 0; i < m_stepsPerTick || (i == 0 && !m_leadsSolver); ++i)
        more = m_solver.step();
    double over = 1.0, most = 0.0;
    std::vector<double> turns(m_angles.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const double way = m_solver.angles()[i] - m_angles[i];
        turns[i] = m_turnsRound[i] ? wrappedAngle(way) : way;
        over = std::max(over, std::abs(turns[i]) / m_mostTurn[i]);
        most = std::max(most, std::abs(turns[i]));
    }
    const bool arrives = over <= 1.0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        if (arrives)
            m_angles[i] = m_solver.angles()[i];
        else
            m_angles[i] =
                m_turnsRound[i] ? wrappedAngle(m_angles[i] + turns[i] / over) : m_angles[i] + turns[i] / over;
    }
    // A slowed transpose goes on from where the arm has come to.
    if (m_leadsSolver && !arrives) {
        m_solver.continueFrom(m_angles);
        more = true;
    }
    m_still = !more && arrives;
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
