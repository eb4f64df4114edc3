/// \file
/// Levels of detail: how many meshes of one tree, and how many triangles each may have.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <vector>

namespace ramure {

inline constexpr std::int64_t mostLevels = 8, leastBudget = 50, mostBudget = 20'000'000;
/// How far a level is from its budget at most, as a share of it.
inline constexpr double levelSlack = 0.02;
/// Of a level without a budget, of the triangles of the one before it.
inline constexpr double levelStep = 0.25;
/// And of the bark's alone, at most.
inline constexpr double levelBarkStep = 0.5;

struct LevelOptions
{
    std::int64_t count = 0; ///< 0: no levels, the tree alone
    /// Triangles of bark, leaves and fruit together, the finest first, each less than the one before; empty:
    /// the first level is the tree as it is, each further one has a quarter of the triangles, or less
    /// where that would give it more than half of the bark's.
    std::vector<std::int64_t> budgets{};
    bool operator==(const LevelOptions&) const = default;

    [[nodiscard]] bool isWanted() const { return count > 0; }
    /// The finest level is the tree itself, whose meshes are needed then.
    [[nodiscard]] bool beginsWhole() const { return budgets.empty(); }
};

/// Errors: Invalid (a count out of range, as many budgets as levels, a budget below leastBudget or over
/// mostBudget, budgets that do not fall).
Expected<void> checkLevels(const LevelOptions& options);

} // namespace ramure
