/// \file
/// What the season does to the leaves of a plant: they turn, and fall.
#pragma once

#include "core/surface/foliage/foliage.h"

namespace ramure {

/// Gives each leaf its tint and takes the fallen away. When a leaf turns and falls depends on its address and
/// on how high it stands in the crown: a later season sheds those of an earlier one and more; at 1 none is
/// left. Evergreens stay. \pre leaves of a plant, as they were placed.
void turnLeaves(const Skeleton& skeleton, double season, Foliage& foliage);

/// sRGB, 0..255: of a leaf that turns neither early nor late, does not wither and keeps no green. That of
/// summer where the season is 0 or the plant evergreen.
glm::vec3 seasonColour(LeafShape shape, double season);

} // namespace ramure
