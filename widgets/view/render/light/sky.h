/// \file
/// The light of a clear day: Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight" (SIGGRAPH
/// 1999). Luminance of the sky by Perez's five numbers, the sun dimmed and coloured by its way through the
/// air. Y is up; colours are linear sRGB, in kcd/m² (sky) and klx (sun).
#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>

namespace ramure {

inline constexpr double leastSunHeightDeg = 2.0; ///< lower, shadows have no end

/// Light from all around by the way a surface faces, nine numbers a colour (Ramamoorthi and Hanrahan, "An
/// Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001), times these of its normal:
/// 1, y, z, x, xy, yz, 3y² - 1, xz, z² - x².
using Ambient = std::array<glm::vec3, 9>;

struct Sky
{
    /// Turbidity: 2 is very clear, 3 clear, 6 hazy.
    static constexpr double leastTurbidity = 2.0, mostTurbidity = 8.0;

    glm::dvec3 sun{0.0, 1.0, 0.0}; ///< unit, towards it
    glm::dvec3 a, b, c, d, e;      ///< Perez's numbers, of Y, x and y (CIE 1931)
    glm::dvec3 scale;              ///< Y, x and y of the zenith over what Perez's formula gives there
    glm::dvec3 sunlight;           ///< on a surface that faces the sun

    /// \param direction unit; below the horizon the sky is as bright as at the horizon
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;
};

/// \param sun unit, above the horizon \param turbidity leastTurbidity .. mostTurbidity
Sky clearSky(const glm::dvec3& sun, double turbidity);

/// Irradiance over pi of light from all around. \param radiance by the direction it comes from, a unit vector
Ambient ambientOf(const std::function<glm::dvec3(const glm::dvec3&)>& radiance);
/// The same of the sky and of a ground of one radiance.
Ambient ambientOf(const Sky& sky, const glm::dvec3& ground);
/// Returns light that changes from below to above and nowhere else.
Ambient ambientOf(const glm::vec3& above, const glm::vec3& below);
glm::vec3 ambientAt(const Ambient& ambient, const glm::vec3& normal);

} // namespace ramure
