/// \file
/// The textures of Pivot Painter 2 beside a mesh file.
#pragma once

#include "core/io/export_scene.h"

namespace ramure {

/// "tree_pivots.exr" and "tree_axes.exr" for "tree.glb"; of several trees "tree_1_pivots.exr" ...
struct PivotPaths
{
    std::string pivots, axes;
};
PivotPaths pivotPaths(const std::string& path, const ExportPivots& pivots);

/// Writes the pivots of all trees of the scene that have some, with floats of 32 bits: with halves, the
/// pivots of a tall tree would be wrong by up to 4 mm. Errors: those of writeExr.
Expected<void> writePivots(const std::string& path, const ExportScene& scene);

} // namespace ramure
