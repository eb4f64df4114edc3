/// \file
/// The white balance of a picture: which light it shows as white.
#pragma once

#include <glm/vec3.hpp>

namespace ramure {

inline constexpr double usualKelvin = 6500.0, leastKelvin = 3000.0, mostKelvin = 12000.0;

/// Factors for linear red, green and blue that turn the light of a black body of this temperature into the
/// colour that one of usualKelvin has: below it pictures become bluer, above it warmer. Grey of usualKelvin
/// keeps its luminance; at usualKelvin all are 1. Locus of black bodies: Kim et al. 2002 (US patent 7024034),
/// as cubic splines of CIE 1931 x and y. \param kelvin leastKelvin .. mostKelvin
glm::dvec3 whiteBalance(double kelvin);

} // namespace ramure
