/// \file
/// What is seen of forks from nearby: their walls and the rings beside them are faired, and bark stands up
/// along their walls as a ridge. Moves vertices; triangles stay.
#pragma once

#include "core/params/node_params.h"
#include "core/surface/mesher/branch_mesh.h"

namespace ramure {

/// Fairs the forks of thick wood as far as MeshParams::fairing says, then raises the ridges that
/// MeshParams::ridge asks for: along a wall, above a limb or between twins. Triangles do not turn against
/// what is around them and keep at least a fifth of their area; feet, cuts and tips stay where they are. The
/// same bytes on any number of threads. \param mesh complete, but without normals.
void finishForks(BranchMesh& mesh, const MeshParams& params);

} // namespace ramure
