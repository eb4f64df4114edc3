/// \file
/// Key shapes of a mesh as the morph targets of a GLB. Internal to glb_format.cpp.
#pragma once

#include "core/io/formats/glb/glb_parts.h"

namespace ramure::glb {

/// How far each vertex is from the mesh in each of its shapes. \param mesh of the file, with one primitive
/// \param rest the mesh that it was made of \param from per vertex of the file its vertex there
void addShapes(Json& mesh, Buffer& buffer, const ExportShapes& shapes, const TriangleMesh& rest,
               const std::vector<Index>& from);

} // namespace ramure::glb
