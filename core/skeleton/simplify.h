/// \file
/// Merging of nearly straight runs (SPEC A2).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"
#include <limits>

namespace ramure {

struct SimplifiedSkeleton
{
    Skeleton skeleton;             ///< source[i] = first branch (of the input) merged into branch i
    std::vector<Index> mergedInto; ///< per branch of the input: its branch in the result
    /// Names of the edits that found their branches by likeness, ascending (edit_places.h).
    std::vector<std::uint64_t> matched{};
};

/// m per m, that a branch gets thinner; 0 where it has no length.
double taperOf(const Skeleton& skeleton, Index branch);

/// Removes every branch that has exactly one child which turns by less than \p rotationThresholdRad against
/// the direction of the branch merged so far. Never merges across a fork. Level and key are those of the
/// first.
SimplifiedSkeleton simplify(const Skeleton& skeleton, double rotationThresholdRad);
/// The same, for millions of branches. \param taperThreshold nor is a branch merged whose radius changes by
/// so much more or less for each metre than that of the branch merged so far. Error: Cancelled.
Expected<SimplifiedSkeleton> simplify(const Skeleton& skeleton, double rotationThresholdRad,
                                      const Progress& progress,
                                      double taperThreshold = std::numeric_limits<double>::infinity());

} // namespace ramure
