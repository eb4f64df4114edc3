/// \file
/// The nodes of a GLB, checked, and where each stands. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_file.h"
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

namespace ramure::glb {

/// What animations move, where a node says it so and not as a matrix.
struct Pose
{
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
};

struct FileNode
{
    const Json* json = nullptr;
    std::string name; ///< of the file, else of what it holds, else "node 3"
    Index parent = noIndex;
    std::optional<std::size_t> mesh, skin, camera;
    Pose pose;
    glm::dmat4 local{1.0}, world{1.0};
};

struct FileNodes
{
    std::vector<FileNode> all;  ///< by their numbers in the file
    std::vector<Index> inScene; ///< those of the scene that is shown, parents before children
};

/// Errors: Invalid (a node below two others or itself, a matrix that is none), with the place inside.
Expected<FileNodes> nodesOf(const File& file);

struct FileCopy
{
    glm::dmat4 place{1.0}; ///< in its node
    glm::vec3 tint{1.0F};  ///< linear, times the mesh's colour
};
/// The copies of a node's mesh: what EXT_mesh_gpu_instancing says, else one in its place. Their colours have
/// no name in the extension; _COLOR_0 is what three.js takes. Errors: those of File::floats; Limit.
Expected<std::vector<FileCopy>> copiesOf(File& file, const FileNode& node, const std::string& place);

/// What moves a vertex from where it is bound to where its joint stands in the world, for each joint of a
/// skin. Errors: those of File; Invalid (a joint that is no node).
Expected<std::vector<glm::dmat4>> jointMatrices(File& file, const FileNodes& nodes, std::size_t skin);
/// The nodes that are its joints.
Expected<std::vector<Index>> jointsOf(const File& file, const FileNodes& nodes, std::size_t skin);
/// From the mesh's space into that of each joint as it was bound; identities where the file says none.
Expected<std::vector<glm::dmat4>> inverseBinds(File& file, std::size_t skin, std::size_t joints);

} // namespace ramure::glb
