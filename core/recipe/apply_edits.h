/// \file
/// What the hands make of a tree that has grown: a plain function of both, in the order of the list.
#pragma once

#include "core/base/progress.h"
#include "core/params/tree_edit.h"
#include "core/recipe/edit_report.h"
#include "core/skeleton/axes.h"
#include <span>

namespace ramure {

class EditTree;

/// \param tree is changed. \param axes of the tree as it was grown. Edits that find no place, or cannot act,
/// change nothing and say why. Never fails: where the list asks for what cannot be, it is as if that were not
/// in it. Where it is cancelled the rest of the edits stay off.
EditReport applyEdits(EditTree& tree, const TreeAxes& axes, std::span<const TreeEdit> edits,
                      const Progress& progress = {});

/// How many of the edits found their places, for the counts of core/skeleton/edit_places.h: those that cannot
/// act are listed with those that have no place.
struct LayerCount
{
    std::uint32_t placed = 0, matched = 0, unplaced = 0;
};
LayerCount countLayer(const EditReport& report);

} // namespace ramure
