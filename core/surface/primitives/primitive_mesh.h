/// \file
/// The meshes of primitives.
#pragma once

#include "core/params/primitive_params.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// To look at: with normals, vertices of sharp edges once per face. Metres, the node's own space; triangles
/// counter-clockwise seen from outside.
TriangleMesh primitiveMesh(const PrimitiveParams& params);
/// The same without normals, every position once: closed and manifold, except the plane, which is open. For
/// files and checks.
TriangleMesh primitiveSolid(const PrimitiveParams& params);
/// Joins vertices at one position (to the last bit) and drops all but positions and triangles.
TriangleMesh welded(const TriangleMesh& mesh);

} // namespace ramure
