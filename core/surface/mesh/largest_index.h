/// \file
/// Finds the largest vertex index of faces, to know whether the vertices exist and can be read.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <span>

namespace ramure {

/// The largest vertex in \p triangles; 0 of none.
Index largestIndex(std::span<const glm::uvec3> triangles);

} // namespace ramure
