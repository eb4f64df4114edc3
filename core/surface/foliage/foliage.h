/// \file
/// Leaves and apples (SPEC A3, A6), and leaves as plants have them, each on its petiole. Which branches carry
/// them depends on radii only; where exactly on the branch's key and the foliage seed, so that no change
/// elsewhere re-rolls them.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/fruit_shapes.h"
#include "core/surface/foliage/leaf_shapes.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <glm/gtc/quaternion.hpp>

namespace ramure {

/// Most leaves and apples of one tree.
inline constexpr std::size_t maxLeaves = 4'000'000;
inline constexpr std::size_t maxApples = 100'000;

/// One leaf or apple: a rigid frame in tree space. A leaf with a petiole stands at its foot, on the bark.
struct FoliageItem
{
    Index branch = noIndex;
    glm::dvec3 position{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
    float size = 1.0F;        ///< of what all have
    float tone = 1.0F;        ///< brightness, of the brightest leaf's
    std::uint32_t number = 0; ///< among the leaves of its branch; of a plant's leaf that is its address
    glm::vec3 tint{1.0F};     ///< of the material's colour: of the season
};

struct Foliage
{
    std::vector<FoliageItem> leaves;
    std::vector<FoliageItem> apples;
    LeafForm form;        ///< of all leaves
    FruitForm fruit;      ///< of all apples
    std::size_t shed = 0; ///< leaves that the season took
};

/// The rule of SPEC A3: a branch with a0 < alpha * leavesCutoff carries leavesDensity leaves, at random
/// positions within alpha / 2 around it (evenly along it and over the disc across it), at random
/// orientations; on a terminal branch they stand up to alpha past its end; and, with applesProbability, one
/// apple, placed likewise. Lengths are those of the branch.
///
/// Branch b draws from Random(seed, RandomStream::Leaves, key of b) for its leaves, one after the other, and
/// from RandomStream::Apples first whether, then where. Errors: Limit (more than maxLeaves or maxApples; path
/// = the parameter to lower), Cancelled.
Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, double alpha,
                               const Progress& progress = {});
/// The same branches and apples, with the leaves of a plant (core/surface/foliage/leaf_placement.h) where
/// \p leaf names one, and the fruit or flowers that \p fruit names in the place of apples
/// (core/surface/foliage/fruit_placement.h).
Expected<Foliage> placeFoliage(const Skeleton& skeleton, const FoliageParams& params, const LeafParams& leaf,
                               const FruitParams& fruit, double alpha, const Progress& progress = {});

enum class FoliageModel : std::uint8_t {
    Rough, ///< squares of side alpha, cubes of edge alpha
    Rhomb, ///< rough, but leaves have their corners in the middle of the squares' sides
    Fine,  ///< equilateral triangles of side alpha, spheres of radius alpha / 2
};

/// What all leaves or apples of a tree are copies of, in the frame of an item of size and tone 1.
TriangleMesh oneLeaf(const LeafForm& form, double alpha, FoliageModel model);
TriangleMesh oneApple(const FruitForm& form, double alpha, FoliageModel model);

/// A faithful leaf is one flat face about its position, its normal its own +Z; a plant's is its leafMesh, in
/// the rough model a card where its blade is. All are to be drawn on both sides.
TriangleMesh buildLeaves(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model);
/// Fine apples are one closed manifold each; the cubes have flat faces, so their corners stand there three
/// times.
TriangleMesh buildApples(const Skeleton& skeleton, const Foliage& foliage, double alpha, FoliageModel model);

} // namespace ramure
