// Cuts, and how the tree answers them.
#include "core/generators/growth/growing_tree.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure::growth {

bool GrowingTree::cut(int age)
{
    bool isCut = false;
    for (std::size_t c = 0; c < m_history.cuts.size(); ++c) {
        const GrowthCut& cut = m_history.cuts[c];
        if (cut.age != age)
            continue;
        const auto found = std::ranges::find(m_history.axisAddress, cut.axis);
        if (found == m_history.axisAddress.end())
            continue;
        const auto axis = Index(found - m_history.axisAddress.begin());
        double whole = 0.0;
        for (Index i = 0; i < living(); ++i)
            if (m_nodes[i].axis == axis)
                whole += double(m_poses[i].length);
        m_history.isMade[c] = whole > 0.0;
        double below = 0.0;
        for (Index i = 0; i < living(); ++i) {
            if (m_nodes[i].axis != axis)
                continue;
            const double above = below + double(m_poses[i].length);
            // A cut leaves what is more below it than above.
            if (m_nodes[i].parent != noIndex && 0.5 * (below + above) >= cut.share * whole) {
                m_nodes[i].cut = m_wasCut = isCut = true;
                m_axes[axis].tipLives = false;
                break;
            }
            below = above;
        }
    }
    if (isCut)
        for (Index i = 0; i < living(); ++i)
            m_nodes[i].cut =
                m_nodes[i].cut || (m_nodes[i].parent != noIndex && m_nodes[m_nodes[i].parent].cut);
    return isCut;
}

std::uint64_t GrowingTree::cellOf(const glm::dvec3& at) const
{
    const glm::dvec3 cell = glm::floor(at / std::max(2.0 * m_params.internode, m_params.height / 50.0)) + 1e6;
    return (std::uint64_t(cell.x) << 42) ^ (std::uint64_t(cell.y) << 21) ^ std::uint64_t(cell.z);
}

/// Light falls in where wood was and below.
void GrowingTree::opened(const glm::dvec3& at)
{
    const double cell = std::max(2.0 * m_params.internode, m_params.height / 50.0);
    m_opened.insert(cellOf(at));
    m_opened.insert(cellOf(at - glm::dvec3(0.0, cell, 0.0)));
}

void GrowingTree::follow(const GrowthHistory& uncut)
{
    if (m_uncut == nullptr)
        for (Node& node : m_nodes)
            node.twin = node.metamer;
    m_uncut = &uncut;
    // Chains by birth, the last child first.
    const auto known = Index(m_nextTwin.size());
    m_firstTwin.resize(uncut.size(), noIndex);
    m_nextTwin.resize(uncut.size(), noIndex);
    for (Index c = known; c < uncut.size(); ++c)
        if (const Index parent = uncut.parent[c]; parent != noIndex) {
            m_nextTwin[c] = m_firstTwin[parent];
            m_firstTwin[parent] = c;
        }
}

/// What stands in new light lives its own life.
void GrowingTree::noteTwins()
{
    for (Index i = 0; i < living(); ++i)
        if (Node& node = m_nodes[i];
            node.woken || (node.twin != noIndex && m_opened.contains(cellOf(m_poses[i].at))))
            node.twin = noIndex;
}

Index GrowingTree::twinOnAxis(Index twin, int year) const
{
    for (Index c = m_firstTwin[twin]; c != noIndex; c = m_nextTwin[c])
        if (int(m_uncut->birth[c]) == year && m_uncut->axis[c] == m_uncut->axis[twin])
            return c;
    return noIndex;
}

/// The shoots that its twin grew, on the wood as it is bent here.
void GrowingTree::growAsTwin(Index metamer, const YearFactors& factors)
{
    const Index twin = m_nodes[metamer].twin;
    std::vector<Index> first;
    for (Index c = m_firstTwin[twin]; c != noIndex; c = m_nextTwin[c])
        if (int(m_uncut->birth[c]) == factors.year)
            first.push_back(c);
    std::ranges::sort(first);
    for (const Index c : first) {
        int nodes = 0;
        for (Index k = c; k != noIndex; k = twinOnAxis(k, factors.year))
            ++nodes;
        const Pose pose = m_poses[metamer]; // the arrays move
        const Node& node = m_nodes[metamer];
        const bool isNew = m_uncut->axis[c] != m_uncut->axis[twin];
        const glm::dvec3 side = pose.frame * glm::dvec3(node.side);
        const glm::dvec3 across = glm::cross(pose.direction, side);
        Index axis = node.axis;
        if (isNew) {
            m_nodes[metamer].buds = 0;
            axis = newAxis(metamer, 0, node.order + 1u, false, factors.year);
            m_history.axisAddress[axis] = m_uncut->axisAddress[m_uncut->axis[c]];
        }
        const glm::dvec3 next = nextCosine(node.order) * side + nextSine(node.order) * across;
        grow({metamer, axis, pose.at, pose.direction, isNew ? across : next, isNew, c}, nodes, 1.0, factors);
    }
}

/// Buds sleep around the foot of every limb, and those along the stump wake too.
/// \param below the node that carried what was cut
void GrowingTree::wake(Index below)
{
    constexpr int nodes = 10, most = 4;
    m_nodes[below].dormant |= 3u;
    int woken = 0;
    for (int k = 0; k < nodes && below != noIndex && woken < most; ++k) {
        Node& node = m_nodes[below];
        if (node.dormant != 0 || node.buds != 0) {
            node.dormant |= node.buds;
            node.buds = 0;
            node.woken = true;
            ++woken;
        }
        below = node.parent;
    }
}

void GrowingTree::sprout(Index metamer, const YearFactors& factors)
{
    constexpr double share = 0.4; // of the longest shoot
    const unsigned buds = m_nodes[metamer].dormant;
    const double light = double(m_nodes[metamer].light);
    m_nodes[metamer].woken = false;
    m_nodes[metamer].dormant = 0;
    const unsigned order = m_nodes[metamer].order + 1u;
    if (order >= unsigned(m_params.orders))
        return;
    const int all = std::popcount(buds);
    for (int k = 0; k < all; ++k) {
        const Pose pose = m_poses[metamer]; // the arrays move
        const Index child = newAxis(metamer, 8u + unsigned(k), order, false, factors.year);
        const std::uint64_t address = m_history.axisAddress[child];
        const double turn = 2.0 * std::numbers::pi * (double(k) / double(all) + 0.3 * chance(address, 5));
        const auto [sine, cosine] = maths::sincos(turn);
        const glm::dvec3 first = pose.frame * glm::dvec3(m_nodes[metamer].side);
        const glm::dvec3 side = cosine * first + sine * glm::cross(pose.direction, first);
        const glm::dvec3 up(0.0, 0.6, 0.0);
        const glm::dvec3 direction = glm::normalize(side + 0.3 * pose.direction + up);
        const glm::dvec3 across = glm::cross(
            direction, std::abs(direction.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
        const int nodes = std::max(1, int(share * light * factors.sideLongest[order]));
        grow({metamer, child, pose.at, direction, glm::normalize(across), true}, std::min(nodes, 250), 1.0,
             factors);
    }
}

} // namespace ramure::growth
