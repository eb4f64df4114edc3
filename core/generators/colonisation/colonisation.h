/// \file
/// A tree that reaches for points: Runions, Lane, Prusinkiewicz, "Modeling trees with a space colonization
/// algorithm" (Eurographics Workshop on Natural Phenomena 2007).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/colonisation_params.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// The trunk rises from the origin until it sees a point; from then on every node of the tree grows towards
/// the points to which it is the nearest. Radii add up as r^n from tips to trunk. Beyond the paper: nothing
/// grows into the ground; short twigs and those that end inside the wood that carries them are left out;
/// nodes that are closer than the wood is thick are one; axes are smoothed. At a fork the child that carries
/// most goes on.
///
/// Errors, path = the parameter's key: those of crownPoints(); Invalid (the trunk sees no point on its way
/// up), Limit (more than maxBranches), Cancelled. \pre checkParams.
Expected<Skeleton> growColonisation(const ColonisationParams& params, std::uint64_t seed,
                                    const Progress& progress = {});

} // namespace ramure
