/// \file
/// What bodies of a game bump into in the place of a tree: its trunk and thick limbs as a chain of convex
/// pieces, as engines want them.
#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

inline constexpr std::size_t mostCollisionPieces = 32;

/// Closed and convex pieces around all wood that is thick enough: a fifth of the thickest, or more where the
/// pieces would be too many. Each is a straight run of branches with eight sides and a point at either end,
/// in the space of the tree. None for a tree without wood.
std::vector<TriangleMesh> collisionChain(const Skeleton& tree);

} // namespace ramure
