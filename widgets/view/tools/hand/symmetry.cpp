#include "widgets/view/tools/hand/symmetry.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace ramure {
namespace {

/// How far foot, middle and tip may be away together, in lengths of the limb.
constexpr double farthestAway = 1.1;
constexpr double mostLonger = 1.8; ///< one than the other

} // namespace

Symmetry::Symmetry(const TreeAxes& axes, const Skeleton& drawn, const HandOptions& options,
                   const glm::dvec3& sight)
    : m_axes(&axes)
    , m_drawn(&drawn)
    , m_copies(std::max(1, options.symmetryCopies))
    , m_mirrored(options.symmetryMirrored)
    , m_sight(sight)
{
}

glm::dvec3 Symmetry::foot(Index axis) const
{
    return m_drawn->p0[m_axes->nodesOf(axis).front()];
}

glm::dvec3 Symmetry::tip(Index axis) const
{
    return m_drawn->p1[m_axes->nodesOf(axis).back()];
}

glm::dvec3 Symmetry::middle(Index axis) const
{
    const auto nodes = m_axes->nodesOf(axis);
    const double half = 0.5 * m_axes->axes[axis].length;
    for (const Index node : nodes) {
        const double length = m_drawn->length(node), start = m_axes->start[node];
        if (start + length >= half && length > 0.0)
            return m_drawn->p0[node] + (half - start) / length * (m_drawn->p1[node] - m_drawn->p0[node]);
    }
    return tip(axis);
}

/// About the line from the foot of the trunk that the limb grows on to its tip.
std::vector<SymmetryMap> Symmetry::maps(Index axis) const
{
    Index trunk = axis;
    while (m_axes->axes[trunk].parent != noIndex)
        trunk = m_axes->axes[trunk].parent;
    glm::dvec3 up = tip(trunk) - foot(trunk);
    up = glm::length(up) > 0.0 ? glm::normalize(up) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 across = glm::cross(up, m_sight);
    const bool canMirror = m_mirrored && glm::length(across) > 1e-9;
    std::vector<SymmetryMap> all;
    for (int copy = 0; copy < m_copies; ++copy)
        for (int side = 0; side < (canMirror ? 2 : 1); ++side) {
            if (copy + side == 0)
                continue; // the limb itself
            SymmetryMap map;
            map.about = foot(trunk);
            map.mirrors = side == 1;
            map.turn = glm::mat3_cast(glm::angleAxis(2.0 * std::numbers::pi * copy / m_copies, up));
            if (map.mirrors) {
                const glm::dvec3 n = glm::normalize(across);
                map.turn = map.turn * (glm::dmat3(1.0) - 2.0 * glm::outerProduct(n, n));
            }
            all.push_back(map);
        }
    return all;
}

/// noIndex: there is none like it.
Index Symmetry::nearest(Index axis, const SymmetryMap& map) const
{
    const Axis& own = m_axes->axes[axis];
    const glm::dvec3 start = map.point(foot(axis)), half = map.point(middle(axis)),
                     end = map.point(tip(axis));
    Index best = noIndex;
    double least = farthestAway * own.length;
    for (Index other = 0; other < m_axes->axes.size(); ++other) {
        const Axis& axisThere = m_axes->axes[other];
        if (axisThere.order != own.order || axisThere.length > mostLonger * own.length ||
            own.length > mostLonger * axisThere.length)
            continue;
        double away = glm::length(foot(other) - start);
        if (away >= least)
            continue;
        away += glm::length(tip(other) - end);
        if (away >= least)
            continue;
        away += glm::length(middle(other) - half);
        if (away < least) {
            least = away;
            best = other;
        }
    }
    return best;
}

std::vector<LimbTwin> Symmetry::twins(Index axis)
{
    std::vector<LimbTwin> found;
    if (!isOn() || axis >= m_axes->axes.size())
        return found;
    for (const SymmetryMap& map : maps(axis)) {
        const Index there = nearest(axis, map);
        if (there == noIndex)
            ++m_missing;
        else if (there != axis && std::ranges::count(found, there, &LimbTwin::axis) == 0)
            found.push_back({there, m_axes->axes[there].address, map});
    }
    return found;
}

} // namespace ramure
