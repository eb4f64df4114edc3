/// \file
/// The wood that a cut lays open: discs with rings of the year, which lie on the flat ends of a branch mesh.
/// The mesh below stays one closed surface; its bark shows around them.
#pragma once

#include "core/surface/mesher/branch_mesh.h"

namespace ramure {

/// On what was cut (Skeleton::sawn), on the splinters of dead wood that broke, and on the feet of limbs that
/// fall. With normals, branch, level and colours; empty where nothing was cut. Tree space. \param skeleton
/// that the mesh was made of
TriangleMesh cutWood(const BranchMesh& mesh, const Skeleton& skeleton);

} // namespace ramure
