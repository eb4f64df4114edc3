/// \file
/// The tree of any age, cut out of its history.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Living wood at an age in years, whole or not: within a year its shoots lengthen and thicken steadily.
/// Empty before the first shoot and after the death. The same bytes as those of a history that was grown just
/// so long. Axes keep their addresses at all ages. \pre age <= history.params.age, or the tree has died.
///
/// Nodes closer to the one before than the wood is thick are left out, and thick wood is smoothed, as its
/// rings do it.
Skeleton skeletonAtAge(const GrowthHistory& history, double age);

} // namespace ramure
