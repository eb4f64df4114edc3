/// \file
/// The geometry of all nodes but trees, made from the parameters at once, in the node's own space, as the row
/// of their kind says; trees have the pipeline.
#pragma once

#include "core/scene/kinds/node_kinds.h"
#include "core/scene/scene.h"
#include <memory>

namespace ramure {

/// Is this node's geometry an open surface by its nature, a terrain or a plane? Then a boundary is no fault.
bool isOpenSurface(const Node& node);

/// Makes the mesh of a primitive, imported mesh or terrain to look at, with normals. \p params are those of
/// the time (paramsAt). It is null for other nodes, for meshes without triangles and for terrains that cannot
/// be made.
std::shared_ptr<const TriangleMesh> objectMesh(const Node& node, const NodeParams& params);
/// Makes the mesh of a node for files and checks. Primitives are closed and without normals, imported meshes
/// are as they were read, and arms have the pose of their joints (core/evaluate/evaluator.h turns them for a
/// time). It is null if there is nothing. Errors: those of buildTerrain, armCylinder and checkArmMesh.
Expected<std::shared_ptr<const TriangleMesh>> objectSolid(const Node& node, const NodeParams& params);
/// Equal for nodes whose objectSolid() is equal, without making it; 0 of a mesh without triangles.
std::uint64_t shapeHash(const Node& node);

} // namespace ramure
