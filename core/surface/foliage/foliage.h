/// \file
/// The leaves and fruit of a tree: rigid copies of one leaf and of one fruit. place_foliage.h places them
/// and builds their meshes.
#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/fruit_shapes.h"
#include "core/surface/foliage/leaf_shapes.h"
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <vector>

namespace ramure {

/// A tree has at most so many leaves and so many fruit.
inline constexpr std::size_t maxLeaves = 4'000'000;
inline constexpr std::size_t maxApples = 100'000;

/// The frame of one leaf or fruit in tree space. The frame of a leaf with a petiole lies at the petiole's
/// foot, on the bark.
struct FoliageItem
{
    Index branch = noIndex;
    glm::dvec3 position{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
    float size = 1.0F; ///< relative to the common shape
    float tone = 1.0F; ///< brightness relative to the brightest leaf
    /// Its number among the leaves of its branch. For a leaf of a plant it is the leaf's address, which
    /// random choices are keyed by.
    std::uint32_t number = 0;
    glm::vec3 tint{1.0F}; ///< multiplies the material's colour, by the leaf and by the season; at most 1
};

/// What the time of a leaf depends on; see core/surface/season/crown_place.h.
struct LeafPhase
{
    float light = 0.0F; ///< 0 deep inside .. 1 on the crown's top and outside
    float phase = 0.0F; ///< 0 turns first .. 1 turns last
    std::uint64_t lots = 0;
};

struct Foliage
{
    std::vector<FoliageItem> leaves;
    std::vector<FoliageItem> apples; ///< fruit and flowers of all kinds
    /// On a day, of each fruit its number among those that were placed; noIndex: a flower. Empty: its own.
    std::vector<Index> fruitOf;
    LeafForm form;          ///< common to all leaves
    FruitForm fruit;        ///< common to all fruit
    std::size_t shed = 0;   ///< number of leaves, or of shoots, that the season took
    std::size_t toCome = 0; ///< those of them that have not come yet this year
    /// One for each leaf as it was placed; null: not asked for yet.
    std::shared_ptr<const std::vector<LeafPhase>> phases{};
    /// sRGB, 0..255, on a day of the year: how all leaves together look, and what shines through them.
    glm::vec3 meanColour{0.0F}, meanThrough{0.0F};
    glm::vec3 fallenColour{0.0F}; ///< the same of leaves that have just fallen; 0: not known
};

/// Returns the number of leaves that hang: a shoot counts with all of its leaves.
inline std::size_t leafCount(const Foliage& foliage)
{
    return foliage.leaves.size() * static_cast<std::size_t>(foliage.form.perShoot);
}

enum class FoliageModel : std::uint8_t {
    Rough, ///< squares of side alpha, cubes of edge alpha
    Rhomb, ///< like Rough, but a leaf's corners lie in the middles of the square's sides
    Fine,  ///< equilateral triangles of side alpha, spheres of radius alpha / 2
};

} // namespace ramure
