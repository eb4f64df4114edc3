/// \file
/// What a click or a box in the viewport makes of a selection.
#pragma once

#include "core/qt/document/selection.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <optional>

namespace ramure {

/// A click on \p hit selects its limb, and a click on a limb that is selected alone the branch that was hit.
/// \p extend (Shift) adds the limb, or takes out what of it was selected. A click beside everything leaves
/// the nodes selected and clears the branches, unless it extends.
/// \param limb all branches of the limb that was hit, ascending
Selection afterClick(const Selection& selection, const std::optional<PickHit>& hit,
                     const std::vector<Index>& limb, bool extend);

/// The branch, or where there is none the node.
[[nodiscard]] bool isSelected(const Selection& selection, const PickHit& hit);

/// A box around \p picked. Branches of one tree are selected: of the one whose branches were, else of the one
/// with most of them in the box.
Selection afterBox(const Selection& selection, const std::vector<PickedBranches>& picked, bool extend);

} // namespace ramure
