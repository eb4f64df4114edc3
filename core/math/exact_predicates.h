/// \file
/// On which side of a plane or a line does a point lie? The sign is exact for any finite float coordinates:
/// a determinant in doubles decides where its error bound allows, the same determinant as an expansion
/// (Shewchuk 1997) elsewhere.
#pragma once

#include <glm/vec3.hpp>

namespace ramure {

/// Sign of dot(cross(b - a, c - a), d - a): 1 where d lies above the plane in which a, b, c run
/// counter-clockwise, -1 below it, 0 in it (or where a, b, c lie on one line). Finite coordinates.
int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

/// A coordinate plane to look at from outside along the axis that it leaves out: 0 = yz, 1 = zx, 2 = xy.
using FlatView = int;

/// Sign of the area of a, b, c in a coordinate plane: 1 where they run counter-clockwise, 0 on one line.
int orientation(FlatView view, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// A view in which the triangle has an area, or -1: its corners lie on one line.
FlatView viewOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

} // namespace ramure
