/// \file
/// Where the mesher puts its vertices and triangles.
#pragma once

#include "core/base/index.h"
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

struct MeshSink
{
    std::vector<glm::vec3> positions;
    std::vector<Index> owner; ///< per vertex: branch of the input skeleton
    std::vector<glm::uvec3> triangles;

    Index addVertex(const glm::dvec3& position, Index branch)
    {
        const auto index = static_cast<Index>(positions.size());
        positions.emplace_back(position);
        owner.push_back(branch);
        return index;
    }
    void addTriangle(Index a, Index b, Index c) { triangles.emplace_back(a, b, c); }
};

} // namespace ramure
