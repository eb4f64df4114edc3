/// \file
/// Texture coordinates of leaves and apples: one picture each.
#pragma once

#include "core/surface/foliage/fruit_shapes.h"
#include "core/surface/foliage/leaf_shapes.h"

namespace ramure {

/// \param leaves as buildLeaves makes them (FoliageModel::Fine): the picture's lower edge is the first side
/// of a faithful leaf, the foot of a plant's; one entry per vertex.
void addLeafTexture(TriangleMesh& leaves, const LeafForm& form = {});
/// \param apples as buildApples makes them (FoliageModel::Fine): u once around the vertical axis of each
/// apple, v from its lowest point to its highest. The seam and the poles are split among the corners.
void addAppleTexture(TriangleMesh& apples, const FruitForm& form = {});

} // namespace ramure
