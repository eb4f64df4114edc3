/// \file
/// A triangle mesh with the data per vertex that the viewport, the files and the skin need. Triangles are
/// counter-clockwise seen from outside; indices are 32 bits wide; positions in metres, tree space.
#pragma once

#include "core/base/index.h"
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

struct TriangleMesh
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit, one per vertex, or empty
    std::vector<glm::uvec3> triangles;
    std::vector<Index>
        branch; ///< per vertex: the branch it follows (index into the mesh's skeleton), or empty
    std::vector<Index> level;  ///< per vertex: level of that branch, or empty
    std::vector<glm::vec2> uv; ///< texture coordinates, or empty
    /// Per triangle its corners' places in uv; empty where uv has one entry per vertex.
    std::vector<glm::uvec3> uvTriangles;
    std::vector<glm::u8vec3> colours; ///< sRGB, one per triangle, or empty
    std::vector<float> radius;        ///< m, of the wood there, one per vertex, or empty

    [[nodiscard]] Index vertexCount() const { return static_cast<Index>(positions.size()); }
    [[nodiscard]] Index faceCount() const { return static_cast<Index>(triangles.size()); }
    [[nodiscard]] bool empty() const { return triangles.empty(); }
    bool operator==(const TriangleMesh&) const = default;
};

/// Equal for equal positions and triangles.
std::uint64_t hashOf(const TriangleMesh& mesh);
/// The memory of the mesh's lists.
std::size_t bytesOf(const TriangleMesh& mesh);

} // namespace ramure
