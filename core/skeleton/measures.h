/// \file
/// Measures of a skeleton as foresters take them.
#pragma once

#include "core/presets/tree_measures.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Trunks that part below 1.3 m count together; limbs and leaves count for nothing there. The crown is that
/// of the branches.
TreeMeasures measuresOf(const Skeleton& skeleton);

} // namespace ramure
