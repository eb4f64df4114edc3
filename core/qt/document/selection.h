/// \file
/// The selection: nodes, and branches of one tree node. Not part of undo.
#pragma once

#include "core/base/index.h"
#include "core/scene/scene.h"
#include <vector>

namespace ramure {

struct Selection
{
    std::vector<NodeId> nodes;    ///< in the order of selecting; the last is the active one
    NodeId branchNode = noNode;   ///< the tree whose branches are selected
    std::vector<Index> branches;  ///< indices in its simplified skeleton, ascending
    Index activeBranch = noIndex; ///< the one the inspector shows

    [[nodiscard]] NodeId activeNode() const { return nodes.empty() ? noNode : nodes.back(); }
    bool operator==(const Selection&) const = default;
};

} // namespace ramure
