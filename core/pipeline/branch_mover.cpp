#include "core/pipeline/branch_mover.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {
namespace {

/// Steps from a branch towards the root that may be turned in its place.
constexpr std::size_t mostSteps = 4;
/// What the tubes of a fork may gain in overlap when one of its branches is turned: the mesh has the last
/// word about forks.
constexpr double forkSlack = 0.25;

bool overlap(const glm::dvec3& lowA, const glm::dvec3& highA, const glm::dvec3& lowB, const glm::dvec3& highB)
{
    return glm::all(glm::lessThanEqual(lowA, highB)) && glm::all(glm::lessThanEqual(lowB, highA));
}

glm::dvec3 anyAcross(const glm::dvec3& v)
{
    const glm::dvec3 axis = std::abs(v.x) < std::abs(v.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(v, axis));
}

/// Eight ways across the lever, that away from the other branch first.
std::array<glm::dvec3, 8> waysAcross(const glm::dvec3& lever, const glm::dvec3& away)
{
    const glm::dvec3 along = glm::normalize(lever);
    const glm::dvec3 across = away - along * glm::dot(along, away);
    const double length = glm::length(across);
    const glm::dvec3 first = length > 1e-9 * glm::length(away) ? across / length : anyAcross(along);
    const glm::dvec3 second = glm::cross(along, first);
    std::array<glm::dvec3, 8> ways;
    constexpr int order[] = {0, 1, -1, 2, -2, 3, -3, 4};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const auto [sine, cosine] = maths::sincos(order[i] * std::numbers::pi / 4.0);
        ways[i] = cosine * first + sine * second;
    }
    return ways;
}

} // namespace

BranchMover::BranchMover(Skeleton skeleton, std::vector<Index> parent, const Limits& limits)
    : m_skeleton(std::move(skeleton))
    , m_parent(std::move(parent))
    , m_limits(limits)
    , m_children(childLists(m_skeleton))
{
    for (Index i = 0; i < m_skeleton.size(); ++i) {
        m_tubes.push_back(tubeOf(i));
        m_bounds.push_back(boundsOf(m_tubes.back()));
    }
}

BranchTube BranchMover::tubeOf(Index branch) const
{
    return branchTube(branchCurve(m_skeleton, branch), m_skeleton.a0[branch], m_skeleton.a1[branch]);
}

BranchMover::Bounds BranchMover::boundsOf(const BranchTube& tube)
{
    Bounds bounds{tube.points[0], tube.points[0]};
    double thick = 0.0;
    for (std::size_t i = 0; i <= BranchTube::pieces; ++i) {
        bounds.low = glm::min(bounds.low, tube.points[i]);
        bounds.high = glm::max(bounds.high, tube.points[i]);
        thick = std::max(thick, tube.radii[i]);
    }
    return {bounds.low - thick, bounds.high + thick};
}

std::vector<Index> BranchMover::subtree(Index branch) const
{
    std::vector<Index> found{branch};
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const Index child : m_children.of(found[i]))
            found.push_back(child);
    return found;
}

bool BranchMover::isFar(Index a, Index b) const
{
    const bool siblings = m_parent[a] == m_parent[b] && m_parent[a] != noIndex;
    return a != b && !siblings && m_parent[a] != b && m_parent[b] != a;
}

double BranchMover::wantedDepth(const TubeContact& contact) const
{
    return -m_limits.clearance * (contact.radiusFirst + contact.radiusSecond);
}

bool BranchMover::areClose(Index first, Index second) const
{
    const TubeContact contact = tubeContact(m_tubes[first], m_tubes[second]);
    return contact.depth > 0.5 * wantedDepth(contact);
}

/// The branches that move one of the two and not the other: both and their ancestors up to the one that
/// carries both. The thinner one and its ancestors stand before the other and its own.
std::vector<Index> BranchMover::movers(Index first, Index second) const
{
    const auto wayUp = [&](Index from) {
        std::vector<Index> way;
        for (Index at = from; at != noIndex; at = m_skeleton.parent[at])
            way.push_back(at);
        return way;
    };
    std::vector<Index> thin = wayUp(first), thick = wayUp(second);
    if (m_skeleton.a0[first] > m_skeleton.a0[second])
        thin.swap(thick);
    while (!thin.empty() && !thick.empty() && thin.back() == thick.back()) {
        thin.pop_back();
        thick.pop_back();
    }
    std::vector<Index> list;
    for (std::size_t i = 0; i < mostSteps; ++i)
        for (const std::vector<Index>* way : {&thin, &thick})
            if (i < way->size() && m_skeleton.parent[(*way)[i]] != noIndex) // roots stand where they are
                list.push_back((*way)[i]);
    return list;
}

std::optional<BranchMover::Turn> BranchMover::partingTurn(Index first, Index second,
                                                          const std::vector<bool>& isBanned) const
{
    for (const Index mover : movers(first, second)) {
        if (isBanned[mover])
            continue;
        const std::vector<Index> branches = subtree(mover);
        const bool carriesFirst = std::find(branches.begin(), branches.end(), first) != branches.end();
        const auto turn = turnOf(mover, carriesFirst ? first : second, carriesFirst ? second : first);
        if (turn)
            return turn;
    }
    return std::nullopt;
}

std::optional<BranchMover::Turn> BranchMover::turnOf(Index mover, Index moving, Index resting) const
{
    const TubeContact contact = tubeContact(m_tubes[moving], m_tubes[resting]);
    const double radii = contact.radiusFirst + contact.radiusSecond;
    const glm::dvec3 pivot = m_skeleton.p0[mover], lever = contact.onFirst - pivot;
    const double reach = glm::length(lever);
    // So close to the start, no turn moves it away.
    if (!(reach > 0.5 * radii))
        return std::nullopt;
    const double shift = std::max(contact.depth, 0.1 * radii) - wantedDepth(contact);
    const glm::dvec3 apart = contact.onFirst - contact.onSecond;
    const glm::dvec3 away = glm::length(apart) > 1e-6 * radii ? apart : anyAcross(lever);
    const auto ways = waysAcross(lever, away);
    const std::vector<Index> branches = subtree(mover);
    std::vector<bool> moves(m_skeleton.size(), false);
    for (const Index branch : branches)
        moves[branch] = true;
    for (const double more : {1.0, 1.5, 2.2, 3.3, 5.0}) {
        const double angle = more * shift / reach;
        if (angle > m_limits.mostTurnRad)
            break;
        for (const glm::dvec3& way : ways) {
            const glm::dvec3 axis = glm::normalize(glm::cross(lever, way));
            const Turn turn{mover, glm::normalize(maths::angleAxis(angle, axis))};
            if (isFree(moved(branches, turn), moves, moving, resting))
                return turn;
        }
    }
    return std::nullopt;
}

/// \param branches the turned one first.
BranchMover::Moved BranchMover::moved(const std::vector<Index>& branches, const Turn& turn) const
{
    const glm::dvec3 pivot = m_skeleton.p0[turn.branch];
    Moved result{branches, {}};
    result.tubes.reserve(branches.size());
    // Its own curve leaves its parent in the old direction; everything on it moves as one body.
    BranchCurve curve = branchCurve(m_skeleton, turn.branch);
    curve.h1 = pivot + turn.rotation * (curve.h1 - pivot);
    curve.v1 = turn.rotation * curve.v1;
    if (m_skeleton.parent[turn.branch] == noIndex)
        curve.v0 = turn.rotation * curve.v0;
    result.tubes.push_back(branchTube(curve, m_skeleton.a0[turn.branch], m_skeleton.a1[turn.branch]));
    for (std::size_t i = 1; i < branches.size(); ++i) {
        BranchTube tube = m_tubes[branches[i]];
        for (glm::dvec3& point : tube.points)
            point = pivot + turn.rotation * (point - pivot);
        result.tubes.push_back(tube);
    }
    return result;
}

bool BranchMover::isFree(const Moved& turned, const std::vector<bool>& moves, Index moving,
                         Index resting) const
{
    std::vector<Bounds> bounds;
    Bounds all = boundsOf(turned.tubes[0]);
    for (const BranchTube& tube : turned.tubes) {
        bounds.push_back(boundsOf(tube));
        all.low = glm::min(all.low, bounds.back().low);
        all.high = glm::max(all.high, bounds.back().high);
    }
    for (Index other = 0; other < m_skeleton.size(); ++other) {
        if (moves[other] || !overlap(all.low, all.high, m_bounds[other].low, m_bounds[other].high))
            continue;
        for (std::size_t i = 0; i < turned.branches.size(); ++i) {
            const Index branch = turned.branches[i];
            const bool isTarget = branch == moving && other == resting;
            if (!isTarget &&
                (!overlap(bounds[i].low, bounds[i].high, m_bounds[other].low, m_bounds[other].high) ||
                 !isFar(branch, other)))
                continue;
            const TubeContact after = tubeContact(turned.tubes[i], m_tubes[other]);
            if (isTarget && after.depth > 0.9 * wantedDepth(after))
                return false;
            if (isTarget || after.depth <= 0.5 * wantedDepth(after))
                continue;
            const TubeContact before = tubeContact(m_tubes[branch], m_tubes[other]);
            const double slack =
                before.depth > 0.0 ? forkSlack * std::min(after.radiusFirst, after.radiusSecond) : 0.0;
            if (after.depth > before.depth + slack)
                return false;
        }
    }
    return true;
}

void BranchMover::apply(const Turn& turn)
{
    const std::vector<Index> branches = subtree(turn.branch);
    const glm::dvec3 pivot = m_skeleton.p0[turn.branch];
    for (const Index branch : branches) {
        if (branch != turn.branch)
            m_skeleton.p0[branch] = pivot + turn.rotation * (m_skeleton.p0[branch] - pivot);
        m_skeleton.p1[branch] = pivot + turn.rotation * (m_skeleton.p1[branch] - pivot);
    }
    for (const Index branch : branches) {
        m_tubes[branch] = tubeOf(branch);
        m_bounds[branch] = boundsOf(m_tubes[branch]);
    }
}

} // namespace ramure
