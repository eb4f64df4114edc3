/// \file
/// Small closed meshes made by hand, to test the tests' own judges.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"

namespace ramure::test {

/// The 8 corners and 12 outward triangles of a box.
TriangleMesh box(const glm::vec3& low, const glm::vec3& high);
/// A torus about Y of radii 2 and 0.5 with \p around x \p across quads.
TriangleMesh torus(int around, int across);
/// Both meshes in one, nothing welded; arrays that only one of them has are dropped.
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);
/// All vertices moved by \p offset.
TriangleMesh moved(TriangleMesh mesh, const glm::vec3& offset);

} // namespace ramure::test
