/// \file
/// The tree of a result, for making further steps of its recipe.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/recipe/edit_context.h"

namespace ramure {

/// The tree with all steps of \p params. They are made again only where the result has others than those
/// that lead to the present ones, as after undo. \pre the result has TreeResult::grown
EditContext contextOf(const TreeResult& tree, const NodeParams& params);

} // namespace ramure
