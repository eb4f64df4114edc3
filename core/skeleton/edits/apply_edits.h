/// \file
/// What the hands made of a tree that has grown: a plain function of both, in the order of the list.
#pragma once

#include "core/params/tree_edit.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits/edit_report.h"
#include <span>

namespace ramure {

class EditTree;

struct EditedSkeleton
{
    Skeleton skeleton; ///< axes that nobody touched keep their addresses and keys
    EditReport report;
};

/// \param axes of \p grown. Edits that find no place, or cannot act, change nothing and say why. Never fails:
/// where the list asks for what cannot be, it is as if that were not in it.
EditedSkeleton applyEdits(const Skeleton& grown, const TreeAxes& axes, std::span<const TreeEdit> edits);

/// The same on a tree at work.
EditReport applyEdits(EditTree& tree, const TreeAxes& axes, std::span<const TreeEdit> edits);

/// How many of the edits found their places, for the counts of core/skeleton/edit_places.h: those that cannot
/// act are listed with those that have no place.
struct LayerCount
{
    std::uint32_t placed = 0, matched = 0, unplaced = 0;
};
LayerCount countLayer(const EditReport& report);

} // namespace ramure
