/// \file
/// One surface around all that a mesh encloses, however its parts run through each other: a level set on a
/// grid (OpenVDB), whose zero is the new mesh.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/print/notch_fill.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

struct UnionOptions
{
    double voxel = 0.0; ///< m, a side of the grid's cells; what is thinner than two of them may come apart
    bool cutsGround = true; ///< what lies below y = 0 is taken off, and the cut lies in y = 0 exactly
    std::vector<NotchBall> notches{}; ///< to be filled
    TriangleMesh sheets{};            ///< open surfaces, which become shells; may be empty
    double thickness = 0.0;           ///< m, of the shells
};

struct UnitedSurface
{
    TriangleMesh mesh;        ///< without normals; the piece with the largest volume
    Index loose = 0;          ///< other pieces, which were dropped
    double looseVolume = 0.0; ///< m³, of them together
    Index cavities = 0;       ///< closed hollows, which were filled
};

/// \param closed closed surfaces, looking outward; they may cross each other and themselves, as sheets may.
/// The result is closed, 2-manifold, outward, one piece; the same bytes on any number of threads. Errors:
/// Invalid (nothing is left; the voxel is no size; a knot that cannot be undone), Limit (a grid of more than
/// 16,000 voxels a side), Cancelled.
Expected<UnitedSurface> unitedSurface(const TriangleMesh& closed, const UnionOptions& options,
                                      const Progress& progress = {});

} // namespace ramure
