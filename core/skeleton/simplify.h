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
};

/// m per m by which a branch gets thinner; 0 if it has no length.
double taperOf(const Skeleton& skeleton, Index branch);

/// Removes every branch that has exactly one child which turns by less than \p rotationThresholdRad against
/// the direction of the branch merged so far. Never merges across a fork, nor where a roll begins. Level and
/// key are those of the first.
SimplifiedSkeleton simplify(const Skeleton& skeleton, double rotationThresholdRad);

/// Further limits to merging.
struct OutlineLimits
{
    /// m per m: a branch whose radius changes by so much more or less than that of the branch merged so far.
    double taper = std::numeric_limits<double>::infinity();
    /// m: one that would take the run too far beside its new axis, as if it were an arc of a circle: so far
    /// that this, times how thick the run is, is the square of this length or more.
    double aside = std::numeric_limits<double>::infinity();
};
/// The same, for millions of branches. Error: Cancelled.
Expected<SimplifiedSkeleton> simplify(const Skeleton& skeleton, double rotationThresholdRad,
                                      const Progress& progress, const OutlineLimits& limits = {});

} // namespace ramure
