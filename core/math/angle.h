/// \file
/// Angles in radians.
#pragma once

#include <numbers>

namespace ramure {

inline constexpr double pi = std::numbers::pi, fullTurn = 2.0 * pi, oneDegree = pi / 180.0;

} // namespace ramure
