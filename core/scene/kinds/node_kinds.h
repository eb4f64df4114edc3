/// \file
/// The kinds of scene nodes, a row each: its name in files, its words and icon, how a new one begins, its
/// shape. A new kind is a value of NodeKind, a file beside this one and a row of node_kinds.cpp; project
/// file, scene panel, menus, counts, pictures, exports and checks ask the row.
#pragma once

#include "core/base/error.h"
#include "core/params/node_kind.h"
#include "core/params/node_params.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace ramure {

using SharedMesh = std::shared_ptr<const TriangleMesh>;

/// Describes one kind of node. Texts are English, context "core". A null function means that the kind lacks
/// this.
struct NodeKindRow
{
    NodeKind kind = NodeKind::Group;
    const char* name = "";  ///< in project files: "terrain"
    const char* icon = "";  ///< file in resources/icons
    const char* word = "";  ///< behind a verb: Delete "terrain"
    const char* tip = "";   ///< "Terrain: %1", with the node's name
    const char* label = ""; ///< name of a node that the action below adds
    const char* many = "";  ///< heads their count; empty: they have no shape, or parts that are counted
    /// The action that adds a node of this kind. Empty if it is added by a preset, a shape or an import.
    const char *addId = "", *addText = "", *addTip = nullptr;
    void (*begin)(NodeParams& params) = nullptr; ///< how a new one differs from the defaults
    /// Makes the mesh to look at, with normals. \param own the mesh that the node keeps, may be null \param
    /// params at the time. The result is null if there is nothing to show.
    SharedMesh (*look)(const NodeParams& params, const SharedMesh& own) = nullptr;
    /// Makes the mesh for files and checks, closed where it can be, from the same two.
    Expected<SharedMesh> (*solid)(const NodeParams& params, const SharedMesh& own) = nullptr;
    /// Is it an open surface by its nature? Then a boundary is no fault.
    bool (*isOpen)(const NodeParams& params) = nullptr;
};

/// Returns all kinds in the order of menus and counts.
std::span<const NodeKindRow* const> nodeKinds();

/// Returns the row of a kind. NodeKind::Unknown has a row that is not in the table.
const NodeKindRow& kindRow(NodeKind kind);
/// Null where there is none of this name.
const NodeKindRow* findKind(std::string_view name);
/// The parameters that nodes of this kind alone have, as numbers: equal for equal shapes.
std::vector<double> ownNumbers(NodeKind kind, const NodeParams& params);

/// Shown as one mesh that is made from the parameters at once.
inline bool isObject(NodeKind kind)
{
    return kindRow(kind).look != nullptr;
}
/// Everything with a geometry but trees, which have the pipeline.
inline bool isShape(NodeKind kind)
{
    return kindRow(kind).solid != nullptr;
}

} // namespace ramure
