/// \file
/// Finds the branches that edits were made for in a tree that has changed since. A branch is found by address
/// if the branch there resembles the edited one, else by likeness. A poor match is never forced.
#pragma once

#include "core/params/branch_place.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/simplify.h"
#include <span>
#include <vector>

namespace ramure {

/// One number for all that places hold of a tree.
std::uint64_t treeMark(const TreeAxes& tree);
/// \param branch of the skeleton that \p tree was made of; \param mark of the tree.
BranchPlace placeOf(const TreeAxes& tree, Index branch, std::uint64_t mark);

struct FoundPlace
{
    Index branch = noIndex; ///< branch of the skeleton that the axes belong to; noIndex: not found
    bool byAddress = false;
};
/// Finds places by likeness. From the roots up, axis by axis: a child at the same rank of the same fork comes
/// first, if the numbers of the parent's forks and of the fork's axes are unchanged. The rest of a parent's
/// children are matched by the least cost of their differences (leastCostAssignment), if it is not too high.
/// An edit of an axis is found only on the axis that its parent became.
std::vector<FoundPlace> findPlaces(const TreeAxes& tree, std::span<const BranchPlace* const> places);

/// By place, of \p simplified; noIndex: nowhere.
/// \param drawn the skeleton it was made of.
std::vector<Index> findBranches(const Skeleton& drawn, const SimplifiedSkeleton& simplified,
                                std::span<const BranchPlace> places);
/// Finds branches of one tree in another, so that a selection survives a change. Branches are the same
/// where the same keys grow there; otherwise they are matched by place.
std::vector<Index> followBranches(const Skeleton& drawn, const SimplifiedSkeleton& simplified,
                                  std::span<const Index> branches, const Skeleton& otherDrawn,
                                  const SimplifiedSkeleton& other);

} // namespace ramure
