/// \file
/// A terrain: hills on a square grid, the same for the same seed everywhere.
///
/// Gradient noise (Perlin: Improving noise, 2002) in octaves: each has hills of half the width and
/// \c roughness times the height of the one before. The widest are half a side wide. The ground at the
/// middle is at height 0, so that something can stand there.
#pragma once

#include "core/base/error.h"
#include "core/params/arm_params.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// The grid with normals and texture coordinates 0..1. Errors: those of checkPart.
Expected<TriangleMesh> buildTerrain(const TerrainParams& params);

} // namespace ramure
