/// \file
/// Puts together what several threads have built.
#pragma once

#include "core/surface/mesher/branch_mesher.h"

namespace ramure {

/// The trunk's sink and the tasks' ranges of theirs become one mesh, every task right after what the trunk
/// held when it was put off. Arrays that \p mesh has keep their memory. Returns the triangles that may be too
/// small, by their final numbers.
std::vector<Index> assemblePieces(const MeshSink& trunk, const std::vector<Index>& smallOfTrunk,
                                  const std::vector<MeshTask>& tasks, BranchMesh& mesh);

} // namespace ramure
