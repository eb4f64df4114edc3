/// \file
/// Meshes moved by a matrix.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <glm/mat4x4.hpp>

namespace ramure {

/// Positions by \p matrix, normals by its inverse transpose; a mirroring one turns the triangles round. A
/// flat one leaves no normals.
TriangleMesh transformed(const TriangleMesh& mesh, const glm::dmat4& matrix);

} // namespace ramure
