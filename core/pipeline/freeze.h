/// \file
/// Freezes the first steps of a recipe: their result is kept, so that they need not run again.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"

namespace ramure {

/// Returns the list with a frozen step (EditOperation::Frozen) after the first \p count, which holds their
/// result. Errors: those of the generator; Invalid: a later step is frozen already; Cancelled.
Expected<std::vector<TreeEdit>> frozenBehind(const NodeParams& tree, std::size_t count,
                                             const Progress& progress = {});

} // namespace ramure
