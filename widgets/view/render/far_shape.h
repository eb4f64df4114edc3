/// \file
/// What is left of a leaf or a fruit from far away.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// A shape of 2 triangles for what is open (a leaf) and 8 for what is closed (a fruit): it stands where
/// \p shape does and covers about as much of a picture. Normals, no colours and no texture; the units and the
/// space of \p shape. Empty where nothing has an area.
TriangleMesh farShape(const TriangleMesh& shape);

} // namespace ramure
