/// \file
/// Texture coordinates of what is no tree: those that were read, or those of a box around it.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// Each triangle sees its picture along the axis that it faces most; one picture is as wide as the longest
/// side of the mesh's box. Three coordinates per triangle, in place of any others.
void addBoxTexture(TriangleMesh& mesh);

/// The mesh with one vertex per coordinate, for what knows no other texture coordinates: graphics cards. One
/// without coordinates gets those of addBoxTexture.
TriangleMesh splitByTexture(const TriangleMesh& mesh);

} // namespace ramure
