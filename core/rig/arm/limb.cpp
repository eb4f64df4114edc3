#include "core/rig/arm/limb.h"

#include "core/math/reproducible.h"
#include "core/rig/arm/damped_step.h"
#include "core/skeleton/bend.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int mostSteps = 60;
constexpr double limbDrawnIn = 0.999;
constexpr double near = 1e-7;         ///< of the reach
constexpr double limbDamping = 0.05;  ///< of the reach
constexpr double mostTurnAStep = 0.5; ///< rad a step
constexpr double atStop = 1e-9;       ///< rad
constexpr double thickest = 2.0;      ///< times the grabbed branch

glm::dvec3 bendOf(const Limb::Bends& bends, std::uint64_t key)
{
    const auto found = bends.find(key);
    return found == bends.end() ? glm::dvec3(0.0) : found->second;
}

double radiusOf(const Skeleton& skeleton, Index branch)
{
    return 0.5 * (skeleton.a0[branch] + skeleton.a1[branch]);
}

} // namespace

std::size_t limbLength(const Skeleton& skeleton, Index branch)
{
    const double most = thickest * radiusOf(skeleton, branch);
    std::size_t length = 0;
    for (Index b = branch; skeleton.parent[b] != noIndex && radiusOf(skeleton, b) <= most;
         b = skeleton.parent[b])
        ++length;
    return length;
}

Limb::Limb(const Skeleton& skeleton, const Bends& bendRad, Index branch, const LimbOptions& options)
    : m_mostTurn(options.mostTurnRad)
{
    std::vector<Index> way; // from the branch to the root
    for (Index b = branch; b != noIndex; b = skeleton.parent[b])
        way.push_back(b);
    const std::size_t count = std::min(options.branches, way.size());
    for (std::size_t i = way.size(); i-- > count;)
        m_carried = glm::normalize(m_carried * bendRotation(bendOf(bendRad, skeleton.key[way[i]])));
    m_foot = count == 0 ? skeleton.p1[branch] : skeleton.p0[way[count - 1]];
    glm::dquat turn = m_carried;
    double most = 0.0;
    for (std::size_t i = count; i-- > 0;) {
        const Index b = way[i];
        Link link;
        link.key = skeleton.key[b];
        link.bend = bendRotation(bendOf(bendRad, link.key));
        turn = glm::normalize(turn * link.bend);
        link.along = glm::conjugate(turn) * (skeleton.p1[b] - skeleton.p0[b]);
        const double length = glm::length(link.along), radius = radiusOf(skeleton, b);
        link.give = std::max(length, 1e-9) / maths::pow(std::max(radius, 1e-9), options.stiffness);
        most = std::max(most, link.give);
        m_reach += length;
        m_links.push_back(link);
    }
    for (Link& link : m_links)
        link.give /= most;
    m_atGrab = m_links;
    place(m_links);
}

glm::dvec3 Limb::tip() const
{
    return m_points.back();
}

void Limb::place(const Chain& chain)
{
    m_points.assign(1, m_foot);
    m_before.clear();
    glm::dquat turn = m_carried;
    for (const Link& link : chain) {
        m_before.push_back(turn);
        turn = glm::normalize(turn * link.bend);
        m_points.push_back(m_points.back() + turn * link.along);
    }
}

/// Where a link has turned as far as it may: the axis about which it must not turn on, in the space of the
/// tree; else zero.
glm::dvec3 Limb::stopOf(const Chain& from, std::size_t link) const
{
    const glm::dvec3 turn = bendVector(from[link].bend * glm::conjugate(m_atGrab[link].bend));
    const double angle = glm::length(turn);
    return angle < m_mostTurn - atStop ? glm::dvec3(0.0) : m_before[link] * (turn / angle);
}

/// How each link turns in one damped step, none of them about its stop.
std::vector<glm::dvec3> Limb::turnsFor(const Chain& from, const std::vector<glm::dvec3>& stops,
                                       const glm::dvec3& error, double damping) const
{
    glm::dmat3 normal(damping * damping);
    for (std::size_t j = 0; j < from.size(); ++j) {
        const glm::dvec3 r = tip() - m_points[j], stopped = glm::cross(stops[j], r);
        const double square = glm::dot(r, r);
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 3; ++k)
                normal[c][k] +=
                    from[j].give * ((c == k ? square : 0.0) - r[c] * r[k] - stopped[c] * stopped[k]);
    }
    const glm::dvec3 pull = solvedSymmetric(normal, error);
    std::vector<glm::dvec3> turns;
    for (std::size_t j = 0; j < from.size(); ++j) {
        const glm::dvec3 turn = from[j].give * glm::cross(tip() - m_points[j], pull);
        turns.push_back(turn - glm::dot(turn, stops[j]) * stops[j]);
    }
    return turns;
}

/// One damped step. \pre place(from). \return whether anything turns
bool Limb::turned(const Chain& from, const glm::dvec3& error, double damping, Chain& to) const
{
    std::vector<glm::dvec3> stops(from.size(), glm::dvec3(0.0));
    std::vector<glm::dvec3> turns = turnsFor(from, stops, error, damping);
    // Links that would turn on beyond their stops do not: the others are asked again.
    for (bool more = true; more;) {
        more = false;
        for (std::size_t j = 0; j < from.size(); ++j) {
            if (stops[j] != glm::dvec3(0.0))
                continue;
            const glm::dvec3 stop = stopOf(from, j);
            if (glm::dot(stop, turns[j]) > 0.0) {
                stops[j] = stop;
                more = true;
            }
        }
        if (more)
            turns = turnsFor(from, stops, error, damping);
    }
    double most = 0.0;
    for (const glm::dvec3& turn : turns)
        most = std::max(most, glm::length(turn));
    if (!(most > 0.0) || !std::isfinite(most))
        return false;
    const double scale = std::min(1.0, mostTurnAStep / most);
    to = from;
    for (std::size_t j = 0; j < from.size(); ++j) {
        const glm::dquat bend = bendRotation(glm::conjugate(m_before[j]) * (scale * turns[j])) * from[j].bend;
        glm::dvec3 whole = bendVector(bend * glm::conjugate(m_atGrab[j].bend));
        const double angle = glm::length(whole);
        if (angle > m_mostTurn)
            whole *= m_mostTurn / angle;
        to[j].bend = glm::normalize(angle > m_mostTurn ? bendRotation(whole) * m_atGrab[j].bend : bend);
    }
    return true;
}

double Limb::pullTo(const glm::dvec3& target)
{
    const double distance = glm::distance(target, m_foot);
    if (!std::isfinite(distance))
        return 0.0;
    if (m_atGrab.empty())
        return distance;
    glm::dvec3 aim = target;
    if (distance > limbDrawnIn * m_reach)
        aim = m_foot + (target - m_foot) * (limbDrawnIn * m_reach / distance);
    Chain best = m_atGrab, trial;
    place(best);
    double residual = glm::distance(tip(), aim), damping = limbDamping * m_reach;
    for (int step = 0; step < mostSteps && residual > near * m_reach; ++step) {
        if (!turned(best, aim - tip(), damping, trial))
            break;
        place(trial);
        const double now = glm::distance(tip(), aim);
        const bool better = now < residual;
        damping = std::clamp(better ? damping / 3.0 : damping * 4.0, 1e-6 * m_reach, 1e3 * m_reach);
        if (better) {
            best = trial;
            residual = now;
        } else
            place(best);
    }
    m_links = std::move(best);
    place(m_links);
    return glm::distance(tip(), target);
}

Limb::Bends Limb::bends() const
{
    Bends bends;
    for (const Link& link : m_links)
        bends[link.key] = bendVector(link.bend);
    return bends;
}

} // namespace ramure
