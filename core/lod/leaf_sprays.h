/// \file
/// Cards with pictures of twigs, in the place of the leaves of a level: each card stands for a cluster of
/// leaves and shows a few of the tree's own clusters, so that leaves keep their size and outline where they
/// are few. A spray is two crossed cards, one seen from above and one from the side.
#pragma once

#include "core/lod/leaf_clusters.h"
#include <array>
#include <cstdint>
#include <memory>

namespace ramure {

/// Some twigs of a tree, as their pictures are drawn: their leaves in the space of the card, m.
struct SprayAtlas
{
    static constexpr int across = 2, count = across * across; ///< twigs along a side of the picture, in all
    LeafForm form;                                            ///< of the leaves
    std::array<TriangleMesh, count> twigs; ///< with normals, colours (tones) and coordinates on the leaf
    std::uint64_t hash = 0;                ///< of all that the pictures hang on
};

/// Where on the card space a picture of a twig lies: half its sides, m, about its middle.
struct SprayFrame
{
    glm::dvec3 middle{0.0}, half{0.0};
};
SprayFrame sprayFrame(const TriangleMesh& twig);

/// The cards of a twig: two rectangles of two triangles each, with normals, white colours and coordinates on
/// the atlas. The first lies across Z and has the left half of the twig's cell, the second lies across X.
TriangleMesh sprayCards(const SprayFrame& frame, int twig);

/// Sprays for the leaves of a level.
struct LeafSprays
{
    std::shared_ptr<const SprayAtlas> atlas;
    std::vector<FoliageItem> items; ///< one for each cluster, in their order
    std::vector<std::uint8_t> twig; ///< the picture that each of them shows
    double area = 0.0;              ///< m²: of the leaves that their pictures show
};

/// Returns a spray for each cluster: its picture is spread as far as its leaves are, along and across, and
/// has their mean colour. Together they show as much leaf as the tree has. \param whole the leaf as the tree
/// has it, of a plant \pre there is at least one cluster
LeafSprays leafSprays(const Foliage& foliage, std::span<const LeafCluster> clusters,
                      const LeafShapeOfLevel& whole);

/// The cards of all sprays as one mesh, in their order. \param skeleton that the items stand on
TriangleMesh buildSprays(const Skeleton& skeleton, const LeafSprays& sprays);

} // namespace ramure
