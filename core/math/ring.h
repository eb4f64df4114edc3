/// \file
/// Points around a circle, as all tubes use them.
#pragma once

#include <glm/vec2.hpp>

namespace ramure {

/// (cos, sin) of 2 pi k / n; n >= 1.
glm::dvec2 ringDirection(int k, int n);

} // namespace ramure
