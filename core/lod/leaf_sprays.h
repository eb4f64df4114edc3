/// \file
/// Cards with pictures of twigs, in the place of the leaves of a level: each card stands for a cluster of
/// leaves, so that leaves keep their size and outline where they are few. A spray is two crossed cards, one
/// seen from above and one from the side. Where there are few clusters each has its own picture, else they
/// share those of some.
#pragma once

#include "core/lod/card_atlas.h"
#include "core/lod/leaf_clusters.h"
#include <cstdint>
#include <memory>

namespace ramure {

/// Up to so many clusters have each its own picture.
inline constexpr std::size_t mostOwnTwigs = 400;
/// So many pictures are shared where there are more.
inline constexpr std::size_t sharedTwigs = 4;

/// Sprays for the leaves of a level.
struct LeafSprays
{
    std::shared_ptr<const CardAtlas> atlas; ///< twigs: a surface and two cards each, in the space of a spray
    std::vector<FoliageItem> items;         ///< one for each cluster, in their order
    std::vector<std::uint16_t> twig;        ///< the twig that each of them shows
    double area = 0.0;                      ///< m²: of the leaves that their pictures show
};

/// Returns a spray for each cluster: its picture is spread as far as its leaves are, along and across, and
/// has their mean colour. Together they show as much leaf as the tree has. \param whole the leaf as the tree
/// has it, of a plant \pre there is at least one cluster
LeafSprays leafSprays(const Foliage& foliage, std::span<const LeafCluster> clusters,
                      const LeafShapeOfLevel& whole);

/// The cards of all sprays as one mesh, in their order. \param skeleton that the items stand on
TriangleMesh buildSprays(const Skeleton& skeleton, const LeafSprays& sprays);

/// Of one spray.
inline constexpr Index facesOfSpray = 4;

} // namespace ramure
