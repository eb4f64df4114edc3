/// \file
/// The axes of a skeleton: stems from their feet to their tips, as an artist sees them. A grammar continues
/// an axis outside of brackets and starts a new one inside.
#pragma once

#include "core/skeleton/skeleton.h"
#include <span>
#include <vector>

namespace ramure {

struct Axis
{
    /// Hash of the parent's address, the rank of the fork and the rank within it. It does not depend on the
    /// pieces, their lengths and the branches above.
    std::uint64_t address = 0;
    Index parent = noIndex;         ///< an axis before this one; noIndex: a root
    Index order = 0;                ///< 0: a root
    Index fork = 0;                 ///< rank of its fork along the parent, from the base
    Index mate = 0;                 ///< rank within the fork; of a root, among the roots
    Index forks = 0;                ///< forks on the axis itself
    Index mates = 0;                ///< axes that start where it does, itself counted
    double s = 0.0;                 ///< m from the parent's foot
    double share = 0.0;             ///< the same of the parent's length
    double downAngle = 0.0;         ///< rad against the parent's direction there; of a root against +Y
    double azimuth = 0.0;           ///< rad about it, in the frame carried without twist from the root
    double length = 0.0;            ///< m
    double radius = 0.0;            ///< m at the foot
    Index firstNode = 0, nodes = 0; ///< range of its branches in TreeAxes::nodes
};

struct TreeAxes
{
    std::vector<Axis> axes;        ///< parents before children; the children of one as they start along it
    std::vector<Index> nodes;      ///< branches, axis by axis, each from foot to tip
    std::vector<Index> axisOf;     ///< by branch
    std::vector<Index> forksBelow; ///< by branch: forks of its axis up to its start
    std::vector<double> start;     ///< by branch: m from the foot of its axis to its own

    [[nodiscard]] std::span<const Index> nodesOf(Index axis) const
    {
        return {nodes.data() + axes[axis].firstNode, axes[axis].nodes};
    }
};

/// The first child at its parent's level continues the axis. \p skeleton should be as the turtle drew it:
/// merging (simplify.h) hides where an axis starts.
TreeAxes axesOf(const Skeleton& skeleton);

/// Address of the axis that starts at a fork.
std::uint64_t axisAddress(std::uint64_t parent, Index fork, Index mate);
/// In place of the parent's address, of roots.
inline constexpr std::uint64_t noAxisAddress = 0x52616D757265ull;

} // namespace ramure
