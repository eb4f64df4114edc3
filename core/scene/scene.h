/// \file
/// The scene: a hierarchy of nodes (SPEC B2). Plain data with checked operations; only commands of the
/// document change the scene of an open document.
#pragma once

#include "core/base/error.h"
#include "core/base/shared_value.h"
#include "core/params/node_kind.h"
#include "core/params/node_params.h"
#include "core/rig/tracks/node_animation.h"
#include "core/rig/tracks/timeline_settings.h"
#include "core/scene/node_list.h"
#include "core/scene/view_bookmarks.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <vector>

namespace ramure {

using NodeId = std::uint32_t;
inline constexpr NodeId noNode = 0; ///< also the parent of the top level

struct Node
{
    NodeId id = noNode;
    NodeId parent = noNode;
    NodeKind kind = NodeKind::Group;
    std::string name;
    std::string preset; ///< name of the preset it came from, or empty
    bool visible = true;
    bool locked = false; ///< cannot be selected in the viewport nor changed
    NodeParams params;
    NodeAnimation animation;
    SharedValue<TriangleMesh>
        mesh; ///< mesh of a Mesh node, or the mesh an Arm wears; see core/qt/document/project/project_mesh.h
    std::string
        extras; ///< keys of the project file that this version does not know: one JSON object, or empty
    bool operator==(const Node&) const = default;
};

/// Copies share their nodes, so that a copy costs little whatever the nodes hold.
class Scene
{
public:
    /// Depth-first: parents before children, siblings in their order.
    [[nodiscard]] NodeList nodes() const { return NodeList(m_nodes); }
    [[nodiscard]] bool empty() const { return m_nodes.empty(); }
    [[nodiscard]] const Node* find(NodeId id) const;
    /// To change it: a node that other scenes share is copied first. Pointers to it from before a copy of the
    /// scene was made still show the shared one.
    [[nodiscard]] Node* find(NodeId id);
    [[nodiscard]] std::vector<NodeId> children(NodeId parent) const;
    /// Position among its siblings, -1 where there is no such node.
    [[nodiscard]] int row(NodeId id) const;
    /// The node and all below it, depth-first. Empty where there is no such node.
    [[nodiscard]] std::vector<Node> subtree(NodeId id) const;
    /// True only where both exist and \p node is strictly below \p ancestor (everything is below noNode).
    [[nodiscard]] bool isAncestor(NodeId ancestor, NodeId node) const;
    /// Visible itself and all above it.
    [[nodiscard]] bool isShown(NodeId id) const;
    /// Locked itself or below a locked node.
    [[nodiscard]] bool isLocked(NodeId id) const;

    /// A scene of these nodes, siblings in their order, parents before or behind their children.
    /// Errors: Invalid (an id twice or noNode, an unknown parent, parents in a circle), path "[i].id" or
    /// "[i].parent".
    static Expected<Scene> fromNodes(std::vector<Node> nodes);
    /// An id not used in this scene, by now or before (before: as long as there are such).
    NodeId newId();
    /// Inserts a whole subtree below \p parent at \p row (clamped). Parents stand before their children; the
    /// first node is the top and its parent field is overwritten; any order of siblings becomes depth-first.
    /// Error: no node, an id that exists or is noNode, an unknown parent. Then the scene is unchanged.
    Expected<void> insert(std::vector<Node> nodes, NodeId parent, int row);
    /// Takes the node and all below it out and returns them.
    std::vector<Node> remove(NodeId id);
    /// \p row counts among the new siblings without the node itself (clamped).
    /// Error: into itself or below itself, unknown ids.
    Expected<void> move(NodeId id, NodeId newParent, int row);
    [[nodiscard]] const TimelineSettings& timeline() const { return m_timeline; }
    /// \pre checkTimeline.
    void setTimeline(const TimelineSettings& settings) { m_timeline = settings; }
    [[nodiscard]] const ViewBookmarks& bookmarks() const { return m_bookmarks; }
    /// \pre checkViewBookmark of each.
    void setBookmarks(const ViewBookmarks& bookmarks) { m_bookmarks = bookmarks; }
    /// The same nodes in the same order, the same timeline and bookmarks; which ids were used before does
    /// not count.
    bool operator==(const Scene& other) const;

private:
    void noteUsed(NodeId highest);
    [[nodiscard]] std::size_t indexOf(NodeId id) const;
    [[nodiscard]] std::size_t subtreeEnd(std::size_t top) const;
    [[nodiscard]] std::size_t placeFor(NodeId parent, int row) const;
    void splice(NodeList::Pointers block, NodeId parent, int row);
    NodeList::Pointers take(NodeId id);
    Node& own(std::size_t index);

    NodeList::Pointers m_nodes; ///< one that another scene has too is never changed
    TimelineSettings m_timeline;
    ViewBookmarks m_bookmarks;
    NodeId m_nextId = 1; ///< noNode once all have been used
};

/// T * R * S of a placement.
glm::dmat4 placementMatrix(const PlacementParams& placement);
/// The rotation alone, Rz * Ry * Rx.
glm::dmat3 rotationMatrix(const glm::dvec3& rotationRad);
/// At rest, without tracks: parent world * own placement, from the top down. Unknown ids: identity. At a
/// time: core/scene/world_transforms.h.
glm::dmat4 worldMatrix(const Scene& scene, NodeId id);
/// The same of the node's own geometry, with its local placement. A group has none.
glm::dmat4 geometryMatrix(const Scene& scene, const Node& node);
/// Is the node below a scatter? Then it is not seen where it stands, but as copies that the scatter makes.
bool isPrototype(const Scene& scene, NodeId id);
/// Calls \p act for each of the nodes \p only that there is; where it names none, for all.
template <class Act> void forEachOf(const Scene& scene, std::span<const NodeId> only, Act&& act)
{
    for (const NodeId id : only)
        if (const Node* node = scene.find(id))
            act(*node);
    if (only.empty())
        for (const Node& node : scene.nodes())
            act(node);
}
/// The placement whose matrix is \p matrix. Error Invalid: the matrix is sheared, flattened, projective or
/// not finite, so that no translation, rotation and scale give it. A mirrored matrix gets its negative scale
/// on X.
Expected<PlacementParams> decomposePlacement(const glm::dmat4& matrix);

} // namespace ramure
