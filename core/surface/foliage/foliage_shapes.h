/// \file
/// The shapes that leaves and apples are copies of: about the origin, with normals, without branch and level.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// Side 1, in the plane z = 0, facing +Z.
TriangleMesh unitSquare();
/// Equilateral, side 1, centroid at the origin, in the plane z = 0, facing +Z.
TriangleMesh unitTriangle();
/// Edge 1, flat faces: four vertices of its own for each.
TriangleMesh unitCube();
/// Radius 1: an icosahedron split twice, 162 vertices, 320 faces, closed and manifold.
TriangleMesh unitSphere();

} // namespace ramure
