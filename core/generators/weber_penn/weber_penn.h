/// \file
/// The tree of Weber and Penn: "Creation and rendering of realistic trees" (SIGGRAPH 1995, doi
/// 10.1145/218380.218427). Trunk, limbs, branches and twigs, each level by its own numbers.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/weber_penn_params.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Each stem is one axis (core/skeleton/axes.h) whose level is the paper's; what a split adds is an axis of
/// its own on the same level. A stem starts at a fork of the one that carries it, at the offset that the
/// formulas say; the stems of a split share those that the whole one would carry. Beyond the paper: stems
/// stand evenly from where the wood that carries their parent ends, bends are spread over the pieces, and the
/// stems of a split turn at least 15 degrees away and are thinner. With a clearance, limbs level out above
/// the ground, and what they carry is shortened, or where a split sends it lower, ends there.
///
/// What a stem draws by chance depends on \p seed and its address alone. Errors, path = the parameter's key:
/// Limit (more branches than maxBranches; found before memory is taken), Invalid (no branch at all),
/// Cancelled. \pre checkParams.
Expected<Skeleton> growWeberPenn(const WeberPennParams& params, std::uint64_t seed,
                                 const Progress& progress = {});

} // namespace ramure
