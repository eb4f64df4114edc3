/// \file
/// The directions in which a cloud of points is long, broad and thin.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace ramure {

/// A right-handed frame: its columns are the longest, the second and the shortest direction. \param spread
/// symmetric: second moments. The same input gives the same bytes.
glm::dmat3 principalAxes(const glm::dmat3& spread);

} // namespace ramure
