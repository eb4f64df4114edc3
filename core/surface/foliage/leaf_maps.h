/// \file
/// The pictures of a leaf: its veins stand out, are paler and let less light through than the blade between
/// them.
#pragma once

#include "core/base/error.h"
#include "core/params/leaf_params.h"
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// Squares of the same size, rows from the foot of the blade up; the texture coordinates of leafMesh lie on
/// them: a blade or leaflet has the whole picture.
struct LeafMaps
{
    int size = 0;                    ///< pixels a side
    glm::u8vec3 blade{255};          ///< sRGB, of the row
    std::vector<glm::u8vec3> colour; ///< sRGB, of the brightest leaf in summer
    std::vector<glm::u8vec3> normal; ///< tangent space, x to the right, y to the tip, z upwards; 128 = 0
    std::vector<std::uint8_t> height;
    std::vector<std::uint8_t> through;  ///< light that shines through, of the most
    std::vector<std::uint8_t> coverage; ///< 255 inside the outline, 0 outside
};

/// Raised when the same leaf gives other pictures than before.
inline constexpr int leafMapsVersion = 3;
inline constexpr int leastLeafSize = 16, mostLeafSize = 8192;

/// Errors: Invalid (a size out of range; the faithful leaf, which has no picture).
Expected<LeafMaps> leafMaps(LeafShape shape, int size);

} // namespace ramure
