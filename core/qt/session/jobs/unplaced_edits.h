/// \file
/// Steps of recipes whose limb does not exist at present. They are kept, and find their place again as soon
/// as the tree grows a limb that looks like it (core/skeleton/edit_places.h).
#pragma once

#include "core/qt/document/document.h"
#include <vector>

namespace ramure {

struct UnplacedEdit
{
    NodeId node = noNode;
    std::uint64_t id = 0; ///< TreeEdit::id
    bool operator==(const UnplacedEdit&) const = default;
};

/// Lists the unplaced edits of all trees, as the trees are shown. Trees that were never grown have none.
std::vector<UnplacedEdit> unplacedEdits(const Document& document);

} // namespace ramure
