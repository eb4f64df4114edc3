/// \file
/// What stays in the bark of the life of a tree that grows by years: scars of limbs that were shed or cut,
/// hollows that some of them have rotted into, and burrs.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/skeleton/skeleton.h"

namespace ramure::growth {

/// Adds them to \p tree as organs (OrganKind::Scar, Hollow, Burr), keyed by the addresses of axes: what is
/// there at one age is at the same place at the next, and heals. Scars are of limbs over 2 cm, and are there
/// until the wood has grown over them by three of their radii. Adds nothing where growth.scars and
/// growth.burrs are 0. \param age whole years \param ends by branch of the tree: the metamer at its end
void markBark(const GrowthHistory& history, int age, std::span<const Index> ends, Skeleton& tree);

} // namespace ramure::growth
