/// \file
/// What trees that grow find in the scene: the roles of its solids, and their neighbours.
#pragma once

#include "core/base/lazy.h"
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace ramure {

/// The role of a primitive or an imported mesh. The order is that of the interface; files know the names.
enum class GrowthRole : std::uint8_t {
    None,
    Envelope, ///< a tree above it in the scene fills it
    Obstacle, ///< no tree grows through it
};

class GrowthSpace; ///< core/generators/colonisation/growth_space.h

/// Another tree that grows beside one, planted in the same year: what its parameters say of its crown.
struct NeighbourCrown
{
    glm::dvec3 foot{0.0};                                         ///< m, tree space
    double height = 0.0, width = 0.0, base = 0.0, maturity = 1.0; ///< as GrowthParams has them
};

struct GrowthSolids
{
    std::shared_ptr<const GrowthSpace> space;
    double top = 0.0; ///< m, tree space: highest point of the solids to be filled
};

/// Derived from the scene (core/scene/growth_spaces.h) and in no file. Two are equal where the same solids
/// stand at the same places. The solids are brought into the tree's space when the tree first grows.
struct GrowthSpaceLink
{
    std::uint64_t hash = 0;
    std::shared_ptr<const Lazy<GrowthSolids>> solids; ///< null: no solid concerns the tree
    std::vector<NeighbourCrown> neighbours;           ///< the nearest, for a tree that heeds them

    [[nodiscard]] const GrowthSpace* space() const { return solids ? (*solids)->space.get() : nullptr; }
    [[nodiscard]] double top() const { return solids ? (*solids)->top : 0.0; }
    bool operator==(const GrowthSpaceLink& other) const { return hash == other.hash; }
};

} // namespace ramure
