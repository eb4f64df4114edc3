/// \file
/// Leaves that stand for their neighbours: where few are left, each covers what a cluster of the tree's
/// leaves covered, about their middle. R. L. Cook, J. Halstead, M. Planck, D. Ryu: Stochastic simplification
/// of aggregate detail, SIGGRAPH 2007.
#pragma once

#include "core/lod/level_leaves.h"

namespace ramure {

/// A leaf of a level and the leaves of the tree that it stands for, itself among them.
struct LeafCluster
{
    Index leaf = noIndex;
    std::vector<Index> members; ///< numbers in the tree's foliage
};

/// Each leaf by itself.
std::vector<LeafCluster> singleClusters(std::span<const Index> leaves);

/// Puts neighbours together until \p count are left, halving across the longest direction by the number of
/// clusters. Of those that are put together the leaf stays that is nearest to their middle; one whose twig
/// has gone only where there is no other. Ascending by leaf. Leaves are where their surface is, not where
/// they are attached: those left of a frond's rachis do not stand for those on its right. \param branchOf
/// PrunedTree::branchOf. \param middle of the surface of a leaf of size 1.
std::vector<LeafCluster> joinedClusters(std::span<const FoliageItem> items, std::vector<LeafCluster> clusters,
                                        std::span<const Index> branchOf, const glm::dvec3& middle,
                                        std::size_t count);

/// The mean place of the surface of leaves, and how far it spreads from there.
struct LeafSpread
{
    double squares = 0.0; ///< the sum of their sizes' squares
    glm::dvec3 middle{0.0};
    glm::dmat3 spread{0.0}; ///< m²: mean outer product of the ways from the middle to the surface
};
/// \param whole a leaf as the tree has it.
LeafSpread spreadOf(std::span<const FoliageItem> items, const LeafCluster& cluster,
                    const LeafShapeOfLevel& whole);
/// m: the edge of a cube that is spread as far as the leaves of a cluster, the root of the mean square over
/// all leaves.
double extentOf(std::span<const FoliageItem> items, std::span<const LeafCluster> clusters,
                const LeafShapeOfLevel& whole);

/// The leaf of a cluster as the level has it: facing where it faced, as long as it is along the cluster, of
/// the area of all members, its middle in theirs. Where it reaches further out of the crown than they did,
/// it goes so much inwards. One that stands for itself alone stays as it is. \param whole as the tree has it.
/// \param shape as the level has it. \param crown its middle.
FoliageItem leafOfCluster(std::span<const FoliageItem> items, const LeafCluster& cluster,
                          const LeafShapeOfLevel& whole, const LeafShapeOfLevel& shape,
                          const glm::dvec3& crown);

} // namespace ramure
