/// \file
/// All commands that change a document. They swap values on undo and redo, merge within one gesture (press to
/// release, focus-in to focus-out; never by the clock), and one that ends where it began removes itself.
#pragma once

#include "core/qt/document/document.h"
#include "core/scene/node_transform.h"
#include <QString>
#include <utility>
#include <vector>

namespace ramure {

/// Groups all commands that are pushed while it lives into one step of undo. Without commands there is no
/// step. An edit that the hand still holds is finished before.
class OneStep
{
public:
    OneStep(Document& document, const QString& text)
        : m_document(document)
    {
        m_document.history().beginStep(text);
    }
    ~OneStep() { m_document.history().endStep(); }
    OneStep(const OneStep&) = delete;
    OneStep& operator=(const OneStep&) = delete;

private:
    Document& m_document;
};

/// A track that a channel of a node gets; null or without keys: none.
struct TrackEdit
{
    NodeId node = noNode;
    Channel channel;
    NodeAnimation::TrackPtr track;
};

/// An arm's target, the angles that follow from it, and their keys. These belong together and change
/// together.
struct ArmState
{
    std::vector<ArmJoint> joints;
    bool follows = true;
    glm::dvec3 target{0.0}; ///< m, in the arm's own space
    NodeAnimation animation;
    bool operator==(const ArmState&) const = default;
};
/// \pre an arm
ArmState armState(const Node& arm);

/// A new place for a node, see core/scene/node_transform.h.
struct NodePlacing
{
    NodeId node = noNode;
    NodeTransform values;
    bool keys = false;   ///< the tracks are what changes, else the placement
    bool placed = false; ///< with keys: the placement changes too, see core/scene/keyed_placement.h
};

/// Each function pushes one undo step (or none where nothing would change) and returns an error where the
/// value is refused, the node unknown or locked; then nothing is pushed. Nodes that are locked, or below a
/// locked one, only accept setNodeLocked. A node that is named twice counts once.
namespace edit {
/// Errors: Unknown (node), Invalid (value, locked, a kind of node without this parameter); path = key.
Expected<void> setParam(Document& document, const std::vector<NodeId>& nodes, const ParamDef& def,
                        const ParamValue& value, GestureId gesture = 0);
/// Sets several parameters as one step ("paste group", "new from preset"). If a parameter is named twice, the
/// last value counts.
Expected<void> setParams(Document& document, const std::vector<NodeId>& nodes,
                         const std::vector<std::pair<const ParamDef*, ParamValue>>& values,
                         const QString& text, GestureId gesture = 0);
/// Resets parameters to the values of each node's preset, or to the defaults if the node came from none
/// (core/presets/presets.h). Errors: as above.
Expected<void> resetParams(Document& document, const std::vector<NodeId>& nodes,
                           const std::vector<const ParamDef*>& params, const QString& text);
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
/// \param keepWorld changes the placement so that the node stays where it is at \p timeSeconds (sheared
/// parents: an error).
Expected<void> moveNode(Document& document, NodeId node, NodeId newParent, int row, bool keepWorld,
                        double timeSeconds = 0.0);
/// Rolls branches (by Skeleton::key) of one tree at their starts: each gets a Roll step there, or the one
/// that it has is changed; for 0 it is removed. Errors: Unknown (node, no such branch in the tree as it is
/// shown), Invalid (locked, no tree, not finite).
Expected<void> setBranchRoll(Document& document, NodeId node, const std::vector<std::uint64_t>& keys,
                             double rollRad, GestureId gesture = 0);
/// Returns what setBranchRoll has set of each branch, in rad; 0 for a branch that the tree has not.
std::vector<double> branchRolls(const Document& document, NodeId node,
                                const std::vector<std::uint64_t>& keys);
/// Adds or replaces steps of a tree (core/params/tree_edit.h). A step whose id the tree has already replaces
/// that one. Others go to the end of the list and get an id if they have none. Returns the ids. A drag passes
/// the step again and again with the id from the first call, and becomes one step of undo. The function does
/// not ask whether a step can act: see core/recipe/edit_context.h. Errors: Unknown (node), Invalid (locked,
/// no tree, refused by checkTreeEdit; path = "edits[0].at").
Expected<std::vector<std::uint64_t>> putTreeEdits(Document& document, NodeId tree,
                                                  std::vector<TreeEdit> edits, GestureId gesture = 0);
/// Errors of these: those of editable trees; Unknown (no edit of that id).
/// The whole list in the place of another. Errors: those of checkTreeEdits, Unknown, Invalid (locked).
Expected<void> setTreeEdits(Document& document, NodeId tree, std::vector<TreeEdit> edits,
                            const QString& text);
/// Sets a parameter of a step (stepParams). Errors: those of checkValue; Unknown (tree, step), Invalid (the
/// step has no such parameter), path = the key.
Expected<void> setStepParam(Document& document, NodeId tree, std::uint64_t step, const ParamDef& def,
                            const ParamValue& value, GestureId gesture = 0);
/// Freezes the tree after a step, or for 0 after the recipe's first source: a further step holds the result,
/// and the steps before do not run. Errors: those of core/pipeline/freeze.h.
Expected<void> freezeTree(Document& document, NodeId tree, std::uint64_t step);
/// A copy behind each of these steps, with an id of its own.
Expected<void> duplicateTreeEdits(Document& document, NodeId tree, const std::vector<std::uint64_t>& ids);
Expected<void> removeTreeEdits(Document& document, NodeId tree, const std::vector<std::uint64_t>& ids,
                               GestureId gesture = 0);
Expected<void> setTreeEditsEnabled(Document& document, NodeId tree, const std::vector<std::uint64_t>& ids,
                                   bool enabled);
/// An empty name is that of the operation.
Expected<void> renameTreeEdit(Document& document, NodeId tree, std::uint64_t id, const QString& name);
/// \param row in the list without the edit itself; past its end: the last.
Expected<void> moveTreeEdit(Document& document, NodeId tree, std::uint64_t id, int row);
/// Copies steps with their ids to the ends of the lists of other trees, as one step of undo. A step that a
/// tree has already is replaced.
Expected<void> copyTreeEdits(Document& document, NodeId from, const std::vector<std::uint64_t>& ids,
                             const std::vector<NodeId>& to);
/// Sets the joints of an arm: their number, lengths, angles and limits. Errors: Unknown (node), Invalid
/// (locked, no arm, what checkArm refuses).
Expected<void> setJoints(Document& document, NodeId node, std::vector<ArmJoint> joints, const QString& text,
                         GestureId gesture = 0);
/// Sets all of an arm's state as one step. Errors: those of setJoints and of setParam for the target; Invalid
/// (a track that an arm cannot have).
Expected<void> setArm(Document& document, NodeId node, ArmState state, const QString& text,
                      GestureId gesture = 0);
/// Inserts a copy of joint \p at right behind it; the keys of the joints behind move on with them. Errors:
/// those of setJoints; Unknown (no joint \p at).
Expected<void> addJoint(Document& document, NodeId node, std::size_t at);
/// Takes joint \p at and its keys out. Errors: likewise.
Expected<void> removeJoint(Document& document, NodeId node, std::size_t at);
/// Sets the mesh that an arm wears, in the arm's own space around the straight arm. An empty mesh means the
/// cylinder. Errors: Unknown (node), Invalid (locked, no arm, refused by checkArmMesh).
Expected<void> setArmMesh(Document& document, NodeId arm, SharedValue<TriangleMesh> mesh,
                          const QString& text);
/// The arm wears a copy of the mesh of a node: as it stands around the straight arm at rest, or \p fitted to
/// it (fittedToArm). The node is hidden, in the same step. Errors: as above; Unknown (mesh), Invalid (it is
/// no imported mesh; the scale of one of the two is 0).
Expected<void> wearMesh(Document& document, NodeId arm, NodeId mesh, bool fitted);
/// "New tree" (Space): the next seeds and stochastic rewriting on, as one step. Seeds follow each other in a
/// fixed order that repeats after 2^31 of them; trees of one call never get the same. Nodes that are no
/// trees, and trees in which chance has no say (core/generators/variety.h), are left out; error where
/// no tree remains.
Expected<void> newTree(Document& document, const std::vector<NodeId>& nodes);
/// Sets tracks of any channels of any nodes as one step. Every edit of keys (insert, remove, drag, paste,
/// modes, extrapolation) changes copies of the tracks and sets them with this. During a gesture, the dragged
/// tracks are made anew from those before the gesture. If a channel is named twice, the last track counts.
/// Errors: Unknown (node), Invalid (locked; the node's kind does not have the channel; a track of the wrong
/// kind).
Expected<void> setTracks(Document& document, const std::vector<TrackEdit>& edits, const QString& text,
                         GestureId gesture = 0);
/// Inserts a key at \p time in each of these channels, with the value that the channel has then ("insert
/// key"). An existing key stays. Channels that a node does not have are skipped. A new key takes the mode of
/// the key before it, or \p mode if there is none. If all \p channels belong to the global transform, its
/// three parts are keyed as wholes, and the placement is taken over if possible, see
/// core/scene/keyed_placement.h.
Expected<void> insertKeys(Document& document, const std::vector<NodeId>& nodes,
                          const std::vector<Channel>& channels, Ticks time, KeyMode mode = KeyMode::Bezier);
/// Sets placements and global tracks of nodes as one step, for gestures in the viewport. While a gesture goes
/// on, the same nodes are given again. Errors: Unknown (node), Invalid (locked, a value out of range, a track
/// of the wrong kind).
Expected<void> placeNodes(Document& document, const std::vector<NodePlacing>& places, const QString& text,
                          GestureId gesture = 0);
/// Sets frames and frame rate. Errors: those of checkTimeline.
Expected<void> setTimeline(Document& document, const TimelineSettings& settings, GestureId gesture = 0);
/// A view that is kept, by its place from 0; nothing forgets it. Errors: Invalid (place, checkViewBookmark).
Expected<void> setBookmark(Document& document, std::size_t place, const std::optional<ViewBookmark>& view);
} // namespace edit

} // namespace ramure
