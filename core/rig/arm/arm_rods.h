/// \file
/// An arm without its skin (SPEC C1): spheres at the joints, rods between them and a smaller sphere at the
/// tip, of the straight arm along Z. Each vertex's branch is the segment that it follows.
#pragma once

#include "core/params/arm_params.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <span>

namespace ramure {

/// Makes the rods to look at, with normals. If \p jointRadius, in metres, is 0 or less, the mesh is empty.
TriangleMesh armRods(std::span<const ArmJoint> joints, double jointRadius);
/// The same as closed solids without normals, for files and checks: every sphere and every rod is one.
TriangleMesh armRodSolids(std::span<const ArmJoint> joints, double jointRadius);

} // namespace ramure
