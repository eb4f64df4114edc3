/// \file
/// Measures of a skeleton as foresters take them.
#pragma once

#include "core/presets/tree_measures.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Trunks that part below 1.3 m count together; limbs and leaves count for nothing there. The crown is that
/// of the branches.
TreeMeasures measuresOf(const Skeleton& skeleton);

/// Number of branches of an order over that of the next, by Strahler: the mean ratio, from the slope of the
/// logarithms. The trunk of a spruce is the only one of its order: a handful of branches has no mean. 0 where
/// fewer than three orders are left.
double hortonRatio(const Skeleton& skeleton);

} // namespace ramure
