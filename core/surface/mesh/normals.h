/// \file
/// Vertex normals.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// Fills mesh.normals with angle-weighted vertex normals (Thürmer & Wüthrich 1998), unit length. A vertex
/// without a usable face gets +Y. Fixed summation order: the same bytes on every run.
void computeNormals(TriangleMesh& mesh);

} // namespace ramure
