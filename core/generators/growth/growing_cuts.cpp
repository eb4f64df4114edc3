// Cuts, and how the tree answers them.
#include "core/generators/growth/growing_tree.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure::growth {

void GrowingTree::cut(const GrowthCuts& cuts, int age)
{
    for (const GrowthCut& cut : cuts) {
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
        double below = 0.0;
        for (Index i = 0; i < living(); ++i) {
            if (m_nodes[i].axis != axis)
                continue;
            const double above = below + double(m_poses[i].length);
            // A cut leaves what is more below it than above.
            if (m_nodes[i].parent != noIndex && 0.5 * (below + above) >= cut.share * whole) {
                m_nodes[i].cut = m_wasCut = true;
                m_axes[axis].tipLives = false;
                break;
            }
            below = above;
        }
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
