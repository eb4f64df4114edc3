/// \file
/// What solids of the scene mean to trees that grow by space colonisation.
#pragma once

#include <cstdint>
#include <memory>

namespace ramure {

/// Of a primitive or an imported mesh. The order is that of the interface; files know the names.
enum class GrowthRole : std::uint8_t {
    None,
    Envelope, ///< a tree above it in the scene fills it
    Obstacle, ///< no tree grows through it
};

class GrowthSpace; ///< core/generators/colonisation/growth_space.h

/// Derived from the scene (core/scene/growth_spaces.h) and in no file. Two are equal where the same solids
/// stand at the same places.
struct GrowthSpaceLink
{
    std::shared_ptr<const GrowthSpace> space; ///< null: no solid concerns the tree
    std::uint64_t hash = 0;
    double top = 0.0; ///< m, tree space: of what the tree is to fill

    bool operator==(const GrowthSpaceLink& other) const { return hash == other.hash; }
};

} // namespace ramure
