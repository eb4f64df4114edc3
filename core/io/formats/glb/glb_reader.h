/// \file
/// Reading GLB files: all meshes in their places, or a scene with groups, meshes, cameras and arms. Internal
/// to the formats.
#pragma once

#include "core/io/formats/text/blender_scene.h"

namespace ramure {

/// Every mesh of the scene in its place in the world, copies too, with vertices at one place as one and skins
/// in the pose of their joints. Colours are those of materials and vertices; pictures are left out. Errors,
/// with the place inside: Io, Syntax, Invalid, Limit (see core/io/formats/glb/glb_file.h), Cancelled.
Expected<ReadMesh> readGlb(const std::string& path, const Progress& progress);

/// The nodes as they stand in the file: meshes, cameras, groups; a skin whose joints are a chain becomes an
/// arm that wears its mesh, one that branches a mesh in its pose. Pictures of materials are written into a
/// folder NAME_pictures beside the file. The first animation's moves of nodes become keys. What is left out
/// is a note. Errors as above, and Invalid, a space other than the program's is asked for.
Expected<BlenderImport> importGlb(const std::string& path, const ImportOptions& options,
                                  const Progress& progress);

} // namespace ramure
