/// \file
/// What an artist set by hand on branches, and did to limbs, that are not there at present. It is kept, and
/// finds its place again as soon as the tree grows one that looks like it (core/skeleton/edit_places.h).
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

/// Of all trees, as they are shown; those that were never grown have none.
std::vector<UnplacedEdit> unplacedEdits(const Document& document);
/// The same as an artist counts them: what was bent, or rolled, along one axis is one edit.
std::vector<std::vector<UnplacedEdit>> unplacedGroups(const Document& document);

} // namespace ramure
