/// \file
/// Growth that goes on from a tree that stands already, whatever made it.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/skeleton/axes.h"

namespace ramure {

/// Lets a tree that stands grow on for some years. Its wood keeps its place and the addresses of its axes,
/// and becomes no thinner. Its organs, leaves and fruit are gone. Buds stand at the ends of axes and all
/// along those that carry nothing, so a trunk that was drawn gets limbs.
///
/// Wood without leaves (Skeleton::bare) stays without. A limb that is bare to all its ends is dead: it does
/// not grow, and breaks off from its ends, twigs after three years and a limb of 10 cm after thirteen.
///
/// The tree counts as old as a tree of its height would be by \p params. If it is higher than the height in
/// \p params, that height is raised. The shape of the crown is ignored.
/// \param years may be fractional; params.age is ignored \param axes the axes of \p tree
/// Errors: those of growHistory(); Invalid: nothing stands, or it died in the shade.
Expected<Skeleton> growOn(const Skeleton& tree, const TreeAxes& axes, GrowthParams params, double years,
                          std::uint64_t seed, const Progress& progress = {});

} // namespace ramure
