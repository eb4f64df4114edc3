/// \file
/// Keeping what the first steps of a recipe have made, so that they need not run again.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"

namespace ramure {

/// The list of steps with one more behind the first \p count, which holds the tree as they have made it
/// (EditOperation::Frozen). Errors: those of the generator; Invalid: a later step is frozen already;
/// Cancelled.
Expected<std::vector<TreeEdit>> frozenBehind(const NodeParams& tree, std::size_t count,
                                             const Progress& progress = {});

} // namespace ramure
