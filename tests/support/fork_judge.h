/// \file
/// Builds the branch mesh of a skeleton and lets both judges, the program's and the tests' own, look at it.
#pragma once

#include "core/surface/mesher/branch_mesh.h"
#include <string>

namespace ramure::test {

/// Everything SPEC A6 promises of a branch mesh, whatever the skeleton.
/// \return what is wrong, empty when all is well.
std::string branchMeshFaults(const Skeleton& skeleton, const BranchMeshOptions& options);

/// The same for a mesh that is there already.
std::string branchMeshFaults(const Skeleton& skeleton, const BranchMesh& built);

} // namespace ramure::test
