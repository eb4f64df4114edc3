/// \file
/// Leaves that stand for their neighbours: where few are left, each covers what a cluster of the tree's
/// leaves covered, about their middle. R. L. Cook, J. Halstead, M. Planck, D. Ryu: Stochastic simplification
/// of aggregate detail, SIGGRAPH 2007.
#pragma once

#include "core/levels/level_leaves.h"

namespace ramure {

/// A leaf of a level and the leaves of the tree that it stands for, itself among them.
struct LeafCluster
{
    Index leaf = noIndex;
    std::vector<Index> members; ///< numbers in the tree's foliage
};

/// Each leaf by itself.
std::vector<LeafCluster> singleClusters(std::span<const Index> leaves);

/// Puts neighbours together until \p count are left, halving along the longest side by the number of
/// clusters. Of those that are put together the leaf stays that is nearest to their middle; one whose twig
/// has gone only where there is no other. Ascending by leaf. Leaves are where their surface is, not where
/// they are attached: those left of a frond's rachis do not stand for those on its right. \param branchOf
/// PrunedTree::branchOf. \param middle of the surface of a leaf of size 1.
std::vector<LeafCluster> joinedClusters(std::span<const FoliageItem> items, std::vector<LeafCluster> clusters,
                                        std::span<const Index> branchOf, const glm::dvec3& middle,
                                        std::size_t count);

/// The leaf of a cluster as the level has it: turned as it was, of the area of all members, its middle in
/// theirs. One that stands for itself alone stays in its place. \param whole as the tree has it. \param shape
/// as the level has it.
FoliageItem leafOfCluster(std::span<const FoliageItem> items, const LeafCluster& cluster,
                          const LeafShapeOfLevel& whole, const LeafShapeOfLevel& shape);

} // namespace ramure
