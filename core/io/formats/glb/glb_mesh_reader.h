/// \file
/// Meshes of a GLB as triangles. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_file.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace ramure::glb {

inline constexpr std::size_t mostTriangles = 50'000'000; ///< of a mesh, and of all copies together

/// A primitive as it stands in the file: vertices are parted wherever texture, colour or normal differ.
struct Primitive
{
    std::optional<std::size_t> material;
    std::vector<glm::vec3> positions, normals; ///< normals: as many, or none
    std::vector<glm::vec2> uv;                 ///< as many, or none; rows of pictures from the lowest
    std::vector<glm::vec3> colours;            ///< as many, or none; linear
    std::vector<glm::uvec4> joints;            ///< as many, or none: places in the skin's list of joints
    std::vector<glm::vec4> weights;
    std::vector<Index> indices; ///< of triangles
};

struct ReadGlbMesh
{
    std::string name;
    std::vector<Primitive> primitives; ///< of triangles, with at least one
    /// Per corner of all primitives its vertex of the closed surface that EXT_mesh_manifold tells, or empty.
    std::vector<Index> closedCorners;
    std::vector<std::string> notes; ///< what was left out
};

/// Errors: Invalid, Limit and Unknown of File, with the place inside.
Expected<ReadGlbMesh> readGlbMesh(File& file, std::size_t number);

/// Vertices moved as the joints' matrices say, by their weights (linear blend skinning).
/// \param joints one for each joint of the skin. Error: Invalid, a joint that the skin has not.
Expected<void> applySkin(ReadGlbMesh& mesh, std::span<const glm::dmat4> joints, const std::string& place);

/// Some of the primitives as one mesh, in which vertices at one place are one: those that the closed surface
/// names where it is told and holds, else all of the same position. Normals of vertices that become one are
/// averaged. \param colours of the materials, linear, per primitive of the whole mesh; with several, or where
/// vertices have some, each triangle has one.
TriangleMesh joinedMesh(const ReadGlbMesh& mesh, std::size_t first, std::size_t count,
                        std::span<const glm::vec3> colours);

/// Encodes a linear colour, each part from 0 to 1 (IEC 61966-2-1).
glm::u8vec3 srgb(const glm::vec3& linear);

} // namespace ramure::glb
