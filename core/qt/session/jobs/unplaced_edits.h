/// \file
/// Values of branches and hand edits whose branch does not exist at present. They are kept, and find their
/// place again as soon as the tree grows a branch that looks like it (core/skeleton/edit_places.h).
#pragma once

#include "core/qt/document/document.h"
#include <vector>

namespace ramure {

struct UnplacedEdit
{
    NodeId node = noNode;
    std::uint64_t name = 0;  ///< NodeParams::branches
    bool isTreeEdit = false; ///< the name is a TreeEdit::id of NodeParams::edits
    bool operator==(const UnplacedEdit&) const = default;
};

/// Lists the unplaced edits of all trees, as the trees are shown. Trees that were never grown have none.
std::vector<UnplacedEdit> unplacedEdits(const Document& document);
/// Groups them as an artist counts them: all bends, or rolls, along one axis are one edit.
std::vector<std::vector<UnplacedEdit>> unplacedGroups(const Document& document);

} // namespace ramure
