/// \file
/// Places on the bark: what leaves and fruit stand on.
#pragma once

#include "core/surface/mesher/branch_mesh.h"
#include <span>
#include <vector>

namespace ramure {

/// By branch; a branch without a tube of its own has none.
std::vector<std::span<const glm::uvec3>> trianglesOfTubes(const BranchMesh& mesh, std::size_t branches);

/// A place on the bark.
struct BarkPlace
{
    glm::uvec3 triangle{noIndex};
    glm::dvec3 shares{1.0, 0.0, 0.0}; ///< weights of its corners
};

/// Returns the first of the nearest places. \pre the tube has triangles.
BarkPlace nearestOnBark(const TriangleMesh& mesh, std::span<const glm::uvec3> tube, const glm::dvec3& place);

} // namespace ramure
