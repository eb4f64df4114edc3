/// \file
/// The geometry of objects: primitives and imported meshes. Made from the parameters at once, in the node's
/// own space; trees have the pipeline.
#pragma once

#include "core/scene/scene.h"
#include <memory>

namespace ramure {

constexpr bool isObject(NodeKind kind)
{
    return kind == NodeKind::Primitive || kind == NodeKind::Mesh;
}

/// To look at, with normals. \p params those of the time (paramsAt). Null for nodes that are no objects and
/// for meshes without triangles.
std::shared_ptr<const TriangleMesh> objectMesh(const Node& node, const NodeParams& params);
/// For files and checks: primitives closed and without normals, imported meshes as they were read.
std::shared_ptr<const TriangleMesh> objectSolid(const Node& node, const NodeParams& params);

} // namespace ramure
