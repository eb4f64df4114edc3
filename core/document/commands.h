/// \file
/// All commands that change a document. They swap values on undo and redo, merge within one gesture (press to
/// release, focus-in to focus-out; never by the clock), and one that ends where it began removes itself.
#pragma once

#include "core/document/document.h"
#include <QString>
#include <map>
#include <utility>
#include <vector>

namespace ramure {

/// One per class; QUndoCommand::id().
enum class CommandId : int {
    SetParam = 1,
    SetNodeState,
    InsertNodes,
    RemoveNodes,
    MoveNode,
    SetBranchParams,
    SetTimeline,
};

/// A gesture: commands with the same id merge. 0 = never merge.
using GestureId = quint64;
/// Another one than ever before; from any thread.
GestureId newGesture();

/// Each function pushes one undo step (or none where nothing would change) and returns an error where the
/// value is refused, the node unknown or locked; then nothing is pushed. Nodes that are locked, or below a
/// locked one, only accept setNodeLocked. A node that is named twice counts once.
namespace edit {
/// Errors: Unknown (node), Invalid (value, locked, a kind of node without this parameter); path = key.
Expected<void> setParam(Document& document, const std::vector<NodeId>& nodes, const ParamDef& def,
                        const ParamValue& value, GestureId gesture = 0);
/// Several parameters as one step ("paste group", "new from preset"). Of a parameter named twice the last
/// counts.
Expected<void> setParams(Document& document, const std::vector<NodeId>& nodes,
                         const std::vector<std::pair<const ParamDef*, ParamValue>>& values,
                         const QString& text, GestureId gesture = 0);
/// One component of a vector parameter (0 = x, 1 = y, 2 = z); of each node the other components stay.
Expected<void> setComponent(Document& document, const std::vector<NodeId>& nodes, const ParamDef& def,
                            int axis, double value, GestureId gesture = 0);
Expected<void> setNodeName(Document& document, NodeId node, const QString& name);
Expected<void> setNodeVisible(Document& document, const std::vector<NodeId>& nodes, bool visible);
Expected<void> setNodeLocked(Document& document, const std::vector<NodeId>& nodes, bool locked);
/// The nodes' ids are replaced by new ones; returns the id of the top node, which becomes selected.
/// \p subtree as Scene::insert wants it.
Expected<NodeId> insertNodes(Document& document, std::vector<Node> subtree, NodeId parent, int row);
/// Nodes with all below them. Error also where one of those is locked.
Expected<void> removeNodes(Document& document, const std::vector<NodeId>& nodes);
/// Copies beside their originals, selected, with names of their own; returns their ids.
Expected<std::vector<NodeId>> duplicateNodes(Document& document, const std::vector<NodeId>& nodes);
/// \param row among the new siblings without the node itself.
/// \param keepWorld changes the placement so that the node stays where it is (sheared parents: an error).
Expected<void> moveNode(Document& document, NodeId node, NodeId newParent, int row, bool keepWorld);
/// Sets the hand-made values of branches (by Skeleton::key) of one tree.
Expected<void> setBranchRoll(Document& document, NodeId node, const std::vector<std::uint64_t>& keys,
                             double rollRad, GestureId gesture = 0);
/// Sets how branches (by Skeleton::key) of one tree are turned about their starts, as one step; branches that
/// are not named lose their bend.
Expected<void> setBranchBends(Document& document, NodeId node,
                              const std::map<std::uint64_t, glm::dvec3>& bendRad);
/// "New tree" (Space): the next seeds and stochastic rewriting on, as one step. Seeds follow each other in a
/// fixed order that repeats after 2^31 of them; trees of one call never get the same. Nodes that are no trees
/// are left out; error where no tree remains.
Expected<void> newTree(Document& document, const std::vector<NodeId>& nodes);
/// Frames and frame rate. Errors: those of checkTimeline.
Expected<void> setTimeline(Document& document, const TimelineSettings& settings, GestureId gesture = 0);
} // namespace edit

} // namespace ramure
