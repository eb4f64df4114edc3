/// \file
/// What is left of a leaf or a fruit from far away.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// A shape of 2 triangles for what is open (a leaf) and 8 for what is closed (a fruit): it stands where
/// \p shape does and covers about as much of a picture. Normals, no colours and no texture; the units and the
/// space of \p shape. Empty where nothing has an area.
TriangleMesh farShape(const TriangleMesh& shape);

/// A leaf of few triangles, wider by what they lack of the area of \p whole; never narrower, at most half as
/// wide again.
TriangleMesh widened(TriangleMesh few, const TriangleMesh& whole);

} // namespace ramure
