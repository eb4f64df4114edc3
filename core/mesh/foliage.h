/// \file
/// Leaves and apples (SPEC A3, A6). Which branches carry them depends on radii only; where exactly on the
/// branch's key and the foliage seed, so that no change elsewhere re-rolls them.
#pragma once

#include "core/mesh/triangle_mesh.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include <glm/gtc/quaternion.hpp>

namespace ramure {

/// One leaf or apple: a rigid frame in tree space.
struct FoliageItem
{
    Index branch = noIndex;
    glm::dvec3 position{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};

struct Foliage
{
    std::vector<FoliageItem> leaves;
    std::vector<FoliageItem> apples;
};

/// The rule of SPEC A3: a branch with a0 < alpha * leavesCutoff carries leavesDensity leaves, at random
/// positions within alpha / 2 around it, at random orientations (on a terminal branch up to alpha past its
/// end); and, with applesProbability, one apple.
Foliage placeFoliage(const Skeleton& skeleton, const FoliageParams& params, double alpha);

enum class FoliageModel : std::uint8_t {
    Rough, ///< squares of side alpha, cubes of edge alpha
    Fine,  ///< equilateral triangles of side alpha, spheres of radius alpha / 2
};
TriangleMesh buildLeaves(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model);
TriangleMesh buildApples(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model);

} // namespace ramure
