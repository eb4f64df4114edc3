/// \file
/// The last step of the mesher: positions only. Two vertices at one place are moved apart, triangles without
/// area get some. The topology stays as it is.
#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// Afterwards no two positions are equal and every triangle has an area above 1e-14 of the squared diagonal
/// of the box. Deterministic. Returns the number of moved vertices (0 on most meshes); stops early when
/// cancelled.
Index separateVertices(std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
                       const Progress& progress, const std::vector<Index>* suspects = nullptr);

/// Has a triangle so small an area that separateVertices would open it? \p suspects: the only ones that may.
bool hasFlat(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
             const std::vector<Index>* suspects);

/// Would separateVertices move nothing?
bool areSeparate(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
                 const std::vector<Index>* suspects = nullptr);

} // namespace ramure
