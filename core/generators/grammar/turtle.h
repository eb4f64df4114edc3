/// \file
/// The turtle: a string of symbols becomes a skeleton (SPEC A1).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include <string_view>

namespace ramure {

/// Most branches a skeleton may have.
inline constexpr std::size_t maxBranches = 16'000'000;

/// Deepest nesting of brackets.
inline constexpr std::size_t maxBracketDepth = 1'000'000;

/// Random variation of a tree: how far its branches vary, and the seed.
struct TurtleChance
{
    VariationParams variation;
    std::uint64_t seed = 1;
};

/// level = depth of brackets; key = hash of the parent's key and of the number of the branch among its
/// siblings. Errors: Invalid with column (unbalanced bracket, 1-based position in \p symbols), Invalid (no
/// branch at all), Limit (more than maxBranches), Cancelled.
Expected<Skeleton> runTurtle(std::string_view symbols, const TurtleParams& params,
                             const Progress& progress = {});
/// Runs the turtle with random variation: each turn, length and taper lies within its share around the value
/// of \p params. The draws of a branch depend on the seed and on its key alone, not on the rest of the tree.
/// Radii stay continuous and never grow along a branch, unless the taper is above 1. With no variation the
/// skeleton is the same to the bit as above. Errors: those of checkPart.
Expected<Skeleton> runTurtle(std::string_view symbols, const TurtleParams& params, const TurtleChance& chance,
                             const Progress& progress = {});

} // namespace ramure
