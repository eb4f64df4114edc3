/// \file
/// The rough model (SPEC A3): one open truncated cone per branch, all in one mesh.
#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// \param radialDivisions sides of each cone, >= 3. A branch without length gives no faces.
/// \param used a mesh that nobody needs any more, whose arrays are written again (MeshArrays)
TriangleMesh buildRoughBranches(const Skeleton& skeleton, int radialDivisions, TriangleMesh used = {});

} // namespace ramure
