/// \file
/// Reading 3MF files: the objects that the build names, in the place that it gives them. Internal to the
/// formats.
#pragma once

#include "core/io/mesh_file.h"

namespace ramure {

/// Reads all meshes. Those of other programs, which have Z up and a unit, are turned into the program's
/// space; those of Ramure keep their numbers (see fileSpaceOf). Triangles have the colours that base
/// materials and groups of colours give them; other properties are skipped. Errors: Io; Syntax (no archive,
/// broken XML); Invalid (no mesh, an index out of range, objects in other files); Limit (an archive, or
/// components in components, that would unpack to more than a mesh can be); Cancelled.
Expected<ReadMesh> readThreeMf(const std::string& path, const Progress& progress);

} // namespace ramure
