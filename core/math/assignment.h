/// \file
/// Pairs rows with columns so that all costs together are least.
#pragma once

#include "core/base/index.h"
#include <span>
#include <vector>

namespace ramure {

/// A pair that may be made. cost >= 0.
struct AssignmentEdge
{
    Index row, column;
    double cost;
};

/// By row its column, each column at most once; noIndex where no edge is worth it: a row that stays alone
/// costs \p aloneCost. Shortest augmenting paths with potentials, O(rows * edges * log).
std::vector<Index> leastCostAssignment(Index rows, Index columns, std::span<const AssignmentEdge> edges,
                                       double aloneCost);

} // namespace ramure
