/// \file
/// Builds the one continuous mesh of a skeleton (SPEC A6): generalised cylinders joined at real forks, closed
/// at every root and tip. For any skeleton the mesh is closed and 2-manifold, has one fan per vertex, Euler
/// characteristic 2 per root, normals outward, and no duplicate or degenerate element.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesher/branch_mesh.h"
#include "core/surface/proof/validate.h"

namespace ramure {

/// \param skeleton any skeleton with finite numbers; radii >= 0; may be empty only as an error.
/// Works on as many threads as parallelThreads() says; the result is the same on any number of them.
/// Errors: Invalid (an empty skeleton, non-finite numbers, options out of range), Limit (more than 2^31
/// faces), Cancelled.
Expected<BranchMesh> buildBranchMesh(const Skeleton& skeleton, const BranchMeshOptions& options,
                                     const Progress& progress = {});

struct CheckedBranchMesh
{
    BranchMesh mesh;
    MeshReport report;
};
/// Builds the same mesh, always with normals, and checks it with validateMesh(). This takes less time than
/// the two calls, because the normals are computed beside the check.
Expected<CheckedBranchMesh> buildCheckedBranchMesh(const Skeleton& skeleton, const BranchMeshOptions& options,
                                                   const Progress& progress = {});

/// Returns the English message for the user (context "core") that explains a missed budget. The text is
/// empty if the mesh fits its budget or has none.
const char* budgetText(BudgetFit fit);

} // namespace ramure
