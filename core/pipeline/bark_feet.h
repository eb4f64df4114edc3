/// \file
/// Feet of petioles and stalks on the bark as the mesh has it. Near forks, and where the mesher repaired the
/// skeleton, that is not where a branch's plain curve and radius are.
#pragma once

#include "core/base/progress.h"
#include "core/surface/foliage/foliage.h"
#include "core/surface/mesher/branch_mesh.h"

namespace ramure {

/// Moves each plant's leaf, fruit and flower, as it is turned, so that its foot lies on the nearest triangle
/// of its branch's tube; of a branch without a tube, on that of the branch it was made part of. Faithful ones
/// stay where they are. \param alpha the grammar's length.
void standOnBark(Foliage& foliage, const BranchMesh& branches, std::size_t branchCount, double alpha,
                 const Progress& progress = {});

} // namespace ramure
