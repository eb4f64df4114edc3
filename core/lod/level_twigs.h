/// \file
/// The wood of a level: which twigs of a tree stay, and what their branches become.
#pragma once

#include "core/skeleton/simplify.h"
#include <span>

namespace ramure {

/// What is left of a tree's skeleton. Its branches are runs of those of the tree.
struct PrunedTree
{
    Skeleton skeleton;
    std::vector<Index> firstMember; ///< per branch of the skeleton, and one more: where its run begins
    std::vector<Index> members;     ///< branches of the tree, run by run, from foot to tip
    std::vector<Index> branchOf;    ///< per branch of the tree that of the skeleton; noIndex: it has gone

    [[nodiscard]] std::span<const Index> run(Index branch) const
    {
        return {members.data() + firstMember[branch], members.data() + firstMember[branch + 1]};
    }
};

/// The order in which the twigs of a tree go: axes, with all that grows on them. Small ones go first, as far
/// as chance does not mix the sizes: of many alike an even part stays, wherever one looks. Chance is a hash
/// of the axis' address, so that the same twigs go whatever is done elsewhere, and fewer triangles never
/// bring one back.
class TwigOrder
{
public:
    /// \param grown before runs were merged: axes have their addresses there. \param tree made of it.
    TwigOrder(const Skeleton& grown, const SimplifiedSkeleton& tree);

    [[nodiscard]] Index axes() const { return static_cast<Index>(m_order.size()); }
    /// Roots, which never go.
    [[nodiscard]] Index leastAxes() const { return m_roots; }
    /// The most axes that meshes of so many triangles have room for, if they are built coarsely.
    [[nodiscard]] Index axesFor(double triangles, double mergeRad) const;
    /// The tree with the axes that stay longest. \param count in [leastAxes(), axes()]. \param mergeRad as in
    /// simplify(); 0: runs are not merged any further.
    [[nodiscard]] PrunedTree pruned(Index count, double mergeRad) const;
    /// m: the thickest that any axis is which goes when so many stay; 0: none goes.
    [[nodiscard]] double thickestGone(Index count) const;

private:
    void findAreas(std::vector<double>& area);
    void sort(const std::vector<std::uint64_t>& addresses, const std::vector<double>& area);

    const Skeleton& m_tree;
    std::vector<Index> m_axisOf;  ///< per branch of the tree
    std::vector<Index> m_parent;  ///< per axis
    std::vector<double> m_radius; ///< m, per axis at its foot
    std::vector<double> m_turn;   ///< rad, per axis: all its bends together
    std::vector<Index> m_order;   ///< axes, what stays longest first
    std::vector<Index> m_rank;    ///< per axis its place there
    Index m_roots = 0;
    double m_height = 0.0; ///< m
};

} // namespace ramure
