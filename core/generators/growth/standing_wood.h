/// \file
/// Growth that goes on from a tree that stands already, whatever made it.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/skeleton/axes.h"

namespace ramure {

/// The tree so many years later. What stands keeps its place, its thickness at least and the addresses of its
/// axes; its organs are gone, as leaves and fruit are. Buds stand at the ends of axes, and all along those
/// that carry nothing, so that a trunk that was drawn gets limbs.
///
/// It is as old as a tree of its height would be by \p params, whose height is raised to that of the tree
/// where it is lower; the shape of the crown counts for nothing.
/// \param years params.age counts for nothing \param axes of \p tree
/// Errors: those of growHistory(); Invalid: nothing stands, or it died in the shade.
Expected<Skeleton> growOn(const Skeleton& tree, const TreeAxes& axes, GrowthParams params, double years,
                          std::uint64_t seed, const Progress& progress = {});

} // namespace ramure
