/// \file
/// Reading USD as text, .usda and .usdz: all meshes in their places, or a scene with groups, meshes and
/// cameras. Internal to the formats.
#pragma once

#include "core/io/formats/text/blender_scene.h"

namespace ramure {

/// Every mesh in its place in the world, copies too. Colours are those of materials and faces; pictures are
/// left out. Errors, with file and line: Io, Syntax, Invalid, Limit, Version (a binary layer), Cancelled.
Expected<ReadMesh> readUsd(const std::string& path, const Progress& progress);

/// The prims as nodes: meshes, cameras, groups; copies become one mesh. Variants are those that the file
/// chooses. Pictures are named where they stand, those of a package are written into a folder NAME_pictures
/// beside it. Skins stay at rest, and nothing moves. What is left out is a note. Errors as above, and
/// Invalid, a space other than the file's is asked for.
Expected<BlenderImport> importUsd(const std::string& path, const ImportOptions& options,
                                  const Progress& progress);

} // namespace ramure
