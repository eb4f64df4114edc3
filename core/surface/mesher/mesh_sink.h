/// \file
/// Where the mesher puts its vertices and triangles.
#pragma once

#include "core/surface/mesher/branch_mesh.h"
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

struct MeshSink
{
    std::vector<glm::vec3> positions;
    std::vector<Index> owner; ///< per vertex: branch of the input skeleton
    std::vector<glm::uvec3> triangles;
    std::vector<TubeRange> tubes;
    std::vector<TubeAxis> axes;
    std::vector<ForkVertex> forkVertices;

    /// All triangles from here on belong to the tube of \p branch.
    void startTube(Index branch, Index parent, const TubeAxis& axis)
    {
        tubes.push_back({branch, parent, static_cast<Index>(triangles.size())});
        axes.push_back(axis);
    }
    [[nodiscard]] Index nextVertex() const { return static_cast<Index>(positions.size()); }
    Index addVertex(const glm::dvec3& position, Index branch)
    {
        const Index index = nextVertex();
        positions.emplace_back(position);
        owner.push_back(branch);
        return index;
    }
    /// Room for \p count vertices of one branch; the caller writes the positions from the returned place on.
    glm::vec3* addVertices(std::size_t count, Index branch)
    {
        const std::size_t first = positions.size();
        positions.resize(first + count);
        owner.resize(first + count, branch);
        return positions.data() + first;
    }
    void addTriangle(Index a, Index b, Index c) { triangles.emplace_back(a, b, c); }
    /// Room for \p count triangles, which the caller writes.
    glm::uvec3* addTriangles(std::size_t count)
    {
        triangles.resize(triangles.size() + count);
        return triangles.data() + (triangles.size() - count);
    }
};

} // namespace ramure
