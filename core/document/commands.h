/// \file
/// All commands that change a document. They swap values on undo and redo, merge within one gesture (press to
/// release, focus-in to focus-out; never by the clock), and one that ends where it began removes itself.
#pragma once

#include "core/document/document.h"
#include <QUndoCommand>
#include <vector>

namespace ramure {

/// One per class; QUndoCommand::id().
enum class CommandId : int {
    SetParam = 1,
    SetNodeState,
    InsertNodes,
    RemoveNodes,
    MoveNode,
    SetBranchParams
};

/// A gesture: commands with the same id merge. 0 = never merge.
using GestureId = quint64;
GestureId newGesture();

/// Each function pushes one undo step (or none where nothing would change) and returns an error where the
/// value is refused, the node unknown or locked; then nothing is pushed. Locked nodes only accept
/// setNodeLocked.
namespace edit {
Expected<void> setParam(Document& document, const std::vector<NodeId>& nodes, const ParamDef& def,
                        const ParamValue& value, GestureId gesture = 0);
/// Several parameters of one node as one step ("paste group", "new from preset", "New tree").
Expected<void> setParams(Document& document, const std::vector<NodeId>& nodes,
                         const std::vector<std::pair<const ParamDef*, ParamValue>>& values,
                         const QString& text);
Expected<void> setNodeName(Document& document, NodeId node, const QString& name);
Expected<void> setNodeVisible(Document& document, const std::vector<NodeId>& nodes, bool visible);
Expected<void> setNodeLocked(Document& document, const std::vector<NodeId>& nodes, bool locked);
/// The nodes' ids are replaced by new ones; returns the id of the top node, which becomes selected.
Expected<NodeId> insertNodes(Document& document, std::vector<Node> subtree, NodeId parent, int row);
Expected<void> removeNodes(Document& document, const std::vector<NodeId>& nodes);
Expected<std::vector<NodeId>> duplicateNodes(Document& document, const std::vector<NodeId>& nodes);
/// \param keepWorld changes the placement so that the node stays where it is (sheared parents: an error).
Expected<void> moveNode(Document& document, NodeId node, NodeId newParent, int row, bool keepWorld);
/// Sets the hand-made values of branches (by Skeleton::key) of one tree.
Expected<void> setBranchRoll(Document& document, NodeId node, const std::vector<std::uint64_t>& keys,
                             double rollRad, GestureId gesture = 0);
/// "New tree" (Space): another seed for each tree and stochastic rewriting on, as one step.
Expected<void> newTree(Document& document, const std::vector<NodeId>& nodes);
} // namespace edit

} // namespace ramure
