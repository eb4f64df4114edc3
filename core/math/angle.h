/// \file
/// Angles in radians.
#pragma once

#include <numbers>

namespace ramure {

inline constexpr double pi = std::numbers::pi, fullTurn = 2.0 * pi, oneDegree = pi / 180.0;
inline constexpr double goldenAngle = pi * (3.0 - 2.23606797749978969);

} // namespace ramure
