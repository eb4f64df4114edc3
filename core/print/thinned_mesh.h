/// \file
/// Fewer triangles for the same surface: edges are collapsed where that changes least (quadrics, Garland and
/// Heckbert 1997, by OpenMesh). Vertices stay where they are or go.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <vector>

namespace ramure {

struct ThinningOptions
{
    double grain = 0.0;         ///< m, a usual edge: what is lost is a small part of it
    Index mostTriangles = 0;    ///< if need be, more is lost than that; 0: it never is
    bool isThin = false;        ///< nothing is left to go that costs nothing: the mesh was thinned before
    std::vector<bool> isKept{}; ///< by vertex; empty: any may go
};

/// \param mesh closed and 2-manifold; stays so. Errors: Invalid (it is not), Cancelled.
Expected<TriangleMesh> thinnedMesh(const TriangleMesh& mesh, const ThinningOptions& options,
                                   const Progress& progress = {});

} // namespace ramure
