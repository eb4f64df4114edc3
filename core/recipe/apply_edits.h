/// \file
/// Applies the recipe's steps to a grown tree: a plain function of both, in the order of the list.
#pragma once

#include "core/base/progress.h"
#include "core/params/tree_edit.h"
#include "core/recipe/edit_report.h"
#include "core/skeleton/axes.h"
#include <span>

namespace ramure {

class EditTree;

/// Changes \p tree. \param axes the axes of the tree as it was grown. Steps that find no place, or cannot
/// act, change nothing and say why. The function never fails: a step that asks for the impossible is skipped.
/// If it is cancelled, the remaining steps are skipped.
EditReport applyEdits(EditTree& tree, const TreeAxes& axes, std::span<const TreeEdit> edits,
                      const Progress& progress = {});

/// Number of edits that found their places, for the counts of core/skeleton/edit_places.h. Edits that cannot
/// act count as having no place.
struct LayerCount
{
    std::uint32_t placed = 0, matched = 0, unplaced = 0;
};
LayerCount countLayer(const EditReport& report);

} // namespace ramure
