/// \file
/// The parameters of space colonisation: Runions, Lane, Prusinkiewicz, "Modeling trees with a space
/// colonization algorithm" (Eurographics Workshop on Natural Phenomena 2007). Lengths in metres, tree space.
#pragma once

#include "core/params/growth_space.h"
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace ramure {

/// The shape of the crown. All but the last are solids of revolution about the trunk. The order is that of
/// the interface; files know the names.
enum class CrownEnvelope : std::uint8_t {
    Sphere, ///< an ellipsoid, where height and width differ
    Hemisphere,
    Cone,
    Cylinder,
    Profile, ///< drawn by the profile's curve
    Solid,   ///< the solids of the scene that stand below the tree and have the role to be filled
};

struct ColonisationParams
{
    CrownEnvelope envelope = CrownEnvelope::Sphere;
    /// Pairs of height and radius, as shares of the crown's, by commas (core/generators/colonisation/
    /// crown_shape.h).
    std::string profile = "0 0.3, 0.35 1, 0.75 0.7, 1 0";
    double crownBase = 1.8;   ///< height of the envelope's lower end
    double crownHeight = 5.0; ///< height of the envelope, without the bare trunk
    double crownRadius = 2.4; ///< radius at its widest point
    std::int64_t points = 3500;
    double surface = 0.3;               ///< 0: points fill the envelope evenly; 1: they lie on its surface
    double influence = 1.0;             ///< how far a branch sees points
    double kill = 0.2;                  ///< a point so near to a branch is reached
    double step = 0.15;                 ///< length that a branch grows in one round
    glm::dvec3 tropism{0.0, 0.15, 0.0}; ///< added to the directions to the points, which are of length 1
    double exponent = 2.5;              ///< n of r^n = sum of the children's r^n
    double tipRadius = 0.007;
    double thinning = 0.2;  ///< shorter twigs are left out
    double smoothing = 0.6; ///< 0: as grown; 1: kinks are gone
    GrowthSpaceLink space;  ///< no parameter: filled in from the scene
    bool operator==(const ColonisationParams&) const = default;
};

/// m, tree space.
inline double crownTop(const ColonisationParams& params)
{
    const bool fillsSolid = params.envelope == CrownEnvelope::Solid && params.space.top() > 0.0;
    return fillsSolid ? params.space.top() : params.crownBase + params.crownHeight;
}

} // namespace ramure
