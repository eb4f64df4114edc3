/// \file
/// The season's effect on the leaves and fruit of a plant: they turn, and fall.
#pragma once

#include "core/surface/foliage/foliage.h"

namespace ramure {

/// Gives each leaf its tint and takes the fallen away. When a leaf turns and falls depends on its address and
/// on how high it stands in the crown: a later season sheds those of an earlier one and more; at 1 none is
/// left. Evergreens stay. \pre leaves of a plant, as they were placed.
void turnLeaves(const Skeleton& skeleton, double season, Foliage& foliage);

/// Takes the fallen fruit away, in an order of their addresses as leaves: blossom goes first, fruit before
/// the leaves are down, and from the middle of autumn on none is left. Cones stay, and all that an evergreen
/// has. \pre fruit of a plant, as they were placed.
void dropFruit(const Skeleton& skeleton, double season, Foliage& foliage);

/// Returns the colour (sRGB, 0..255) of an average leaf that turns neither early nor late, does not wither
/// and keeps no green. If the season is 0 or the plant is evergreen, this is the colour of summer.
glm::vec3 seasonColour(LeafShape shape, double season);

} // namespace ramure
