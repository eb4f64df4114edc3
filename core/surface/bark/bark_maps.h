/// \file
/// Pictures of bark, made from a few numbers: one tile that repeats without a seam.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/bark_params.h"
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// Squares of the same size, rows from the foot up: x goes around the branch, y along it towards its tip.
struct BarkMaps
{
    int size = 0;                    ///< pixels a side
    std::vector<glm::u8vec3> colour; ///< sRGB
    std::vector<glm::u8vec3> normal; ///< tangent space, x around, y along, z outward; 128 = 0
    std::vector<std::uint8_t> height, occlusion, roughness;
    float relief = 0.0f; ///< height 255 stands so far over height 0, in tiles
    glm::u8vec3 young{}; ///< sRGB, of thin wood:
    float youngRadius = 0.0f,
          oldRadius = 0.0f; ///< m, up to which there is nothing else, and from which none is left
    glm::vec3 limb{1.0f};   ///< multiplies the colour on limbs
    float limbRadius = 1.0f,
          ripeRadius = 2.0f; ///< m, up to which bark is that of limbs, and from which all of it is old
    float grey = 0.5f;       ///< 0 .. 1, of colour on average
};

/// Raised when the same parameters give other pictures than before.
inline constexpr int barkVersion = 8;
inline constexpr int leastBarkSize = 16, mostBarkSize = 8192;

/// Errors: Invalid (a size out of range; the family Plain, which has no picture), Cancelled.
Expected<BarkMaps> barkMaps(const BarkParams& params, int size, const Progress& progress = {});

/// Returns how old the bark is on wood of this radius, m: 0 the skin of twigs, 1 bark. \pre The family is not
/// Plain.
float barkAge(BarkFamily family, double radius);
/// Returns how old bark is where no skin of twigs is left: 0 that of limbs, 1 that of old trunks. \pre As
/// above.
float barkRipeness(BarkFamily family, double radius);
/// Returns how far dirt, algae and weather have changed bark or skin at a place of the tree, m: 0 .. 1. Wide
/// patches along the wood, which no tile repeats. mesh.vert has the same function.
float barkWeather(const glm::vec3& place);
/// Multiplies a colour (sRGB) on fully weathered bark.
inline constexpr glm::vec3 weatheredBark{0.70f, 0.74f, 0.68f};
/// Returns the mean colour of bark on limbs, sRGB. \pre As above.
glm::u8vec3 limbColour(const BarkParams& params);
/// Returns the colour of thin wood, sRGB. \pre The family is not Plain.
glm::u8vec3 youngColour(const BarkParams& params);
/// sRGB, of the colour map, about: from some of its places. \pre the family is not Plain.
glm::u8vec3 meanColour(const BarkParams& params);

} // namespace ramure
