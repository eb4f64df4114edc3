/// \file
/// Polygons of mesh files as triangles.
#pragma once

#include "core/base/index.h"
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ramure {

/// True where the triangles (0, k, k + 1) lie side by side, so that they are the polygon. This holds of every
/// convex polygon whose first corner is one. Also true of a polygon without an area, which no cut improves.
bool isFan(std::span<const glm::vec3> corners);

/// Cuts a polygon into as many triangles as it has corners, less two, by clipping ears (Meisters 1975), in
/// the plane of two axes that faces it best. Corners on a straight side get triangles with an area. Each
/// triangle is three numbers of corners, in the direction of the polygon. Returns false where the polygon
/// crosses itself, so that some triangles lie on others. Takes no more than a second, whatever the polygon.
bool cutPolygon(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles);

} // namespace ramure
