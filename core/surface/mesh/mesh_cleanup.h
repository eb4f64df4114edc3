/// \file
/// The last step of the mesher: positions only. Vertices that lie too near to each other are moved apart, and
/// triangles without area get some. The topology stays as it is.
#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// A mesh to clean up.
struct CleanupInput
{
    const std::vector<glm::uvec3>& triangles;
    /// The only triangles that may have too small an area; null: any of them.
    const std::vector<Index>* suspects = nullptr;
    /// m, the least distance between two vertices; it is never less than 4e-7 of the diagonal of the box.
    double leastGap = 0.0;
};

/// Afterwards no two vertices are nearer than the least gap, and every triangle has an area above 1e-14 of
/// the squared diagonal of the box. Deterministic. Returns the number of moves (0 on most meshes); stops
/// early when cancelled.
Index separateVertices(std::vector<glm::vec3>& positions, const CleanupInput& mesh, const Progress& progress);

/// Would separateVertices move nothing?
bool areSeparate(const std::vector<glm::vec3>& positions, const CleanupInput& mesh);

} // namespace ramure
