/// \file
/// Leaves, fruit and flowers that a grammar puts in their places. Internal to place_foliage.cpp.
#pragma once

#include "core/base/error.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

/// Adds the skeleton's organs to what grows by itself: as the tree's leaves and fruit are, but each as large
/// as the grammar says, where its branch is now. An organ without a size is as large as the others. Errors:
/// Limit (more than maxLeaves or maxApples; path = grammar.iterations).
Expected<void> placeOrgans(const Skeleton& skeleton, const LeafParams& leaf, double alpha, Foliage& foliage);

} // namespace ramure
