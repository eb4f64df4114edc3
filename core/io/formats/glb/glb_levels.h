/// \file
/// What a GLB says of levels of detail beyond MSFT_lod. Internal to the format.
#pragma once

#include "core/io/export_scene.h"
#include "core/io/formats/glb/glb_file.h"

namespace ramure::glb {

/// Says in the extras of a node between which sizes on the screen, and distances, the level fades in: \c fade
/// with \c screenHeight and \c metres. Nothing where the mesh is no level, or the finest.
void tellFade(Json& node, const ExportMesh& mesh);

} // namespace ramure::glb
