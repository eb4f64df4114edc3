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
    for (std::size_t c = 0; c < m_history.cuts.size(); ++c)
        if (const GrowthCut& cut = m_history.cuts[c]; cut.age == age) {
            const bool wasMade = cut.within ? prune(cut, isCut) : cutAxis(cut, isCut);
            m_history.isMade[c] = wasMade;
        }
    if (isCut)
        for (Index i = 0; i < living(); ++i)
            m_nodes[i].cut =
                m_nodes[i].cut || (m_nodes[i].parent != noIndex && m_nodes[m_nodes[i].parent].cut);
    m_wasCut = m_wasCut || isCut;
    return isCut;
}

/// noIndex: there is none of that address.
Index GrowingTree::axisOf(std::uint64_t address) const
{
    const auto found = std::ranges::find(m_history.axisAddress, address);
    return found == m_history.axisAddress.end() ? noIndex : Index(found - m_history.axisAddress.begin());
}

/// \return whether the axis stands
bool GrowingTree::cutAxis(const GrowthCut& cut, bool& isCut)
{
    const Index axis = axisOf(cut.axis);
    double whole = 0.0;
    for (Index i = 0; i < living(); ++i)
        if (m_nodes[i].axis == axis)
            whole += double(m_poses[i].length);
    double below = 0.0;
    for (Index i = 0; i < living(); ++i) {
        if (m_nodes[i].axis != axis)
            continue;
        const double above = below + double(m_poses[i].length);
        // A cut leaves what is more below it than above.
        if (m_nodes[i].parent != noIndex && 0.5 * (below + above) >= cut.share * whole) {
            m_nodes[i].cut = isCut = true;
            m_axes[axis].tipLives = false;
            break;
        }
        below = above;
    }
    return whole > 0.0;
}

/// \return whether anything stands out
bool GrowingTree::prune(const GrowthCut& cut, bool& isCut)
{
    const Index limb = axisOf(cut.axis);
    bool any = false;
    std::vector<bool> isMeant(m_nodes.size(), cut.axis == 0), entered(m_nodes.size(), false);
    for (Index i = 0; i < living(); ++i) {
        Node& node = m_nodes[i];
        const bool isRoot = node.parent == noIndex;
        isMeant[i] =
            isMeant[i] || (limb != noIndex && node.axis == limb) || (!isRoot && isMeant[node.parent]);
        const bool isIn = (*cut.within)(m_poses[i].at);
        const bool mayEnter = node.order == 0 && (isRoot || !entered[node.parent]);
        entered[i] = isIn || (!isRoot && entered[node.parent]);
        if (isRoot || !isMeant[i] || isIn || mayEnter)
            continue;
        if (m_nodes[node.parent].axis == node.axis)
            m_axes[node.axis].tipLives = false;
        node.cut = any = isCut = true;
    }
    return any;
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
