/// \file
/// Simulates an engine that shows a tree by an atlas of views: how the atlas covers a picture from any
/// direction, and how well this agrees with the tree itself.
#pragma once

#include "core/lod/billboard_picture.h"

namespace ramure {

/// How much of each pixel is covered, 0..1; rows from the top.
using Coverage = std::vector<float>;
/// Measures the alpha of a picture.
Coverage coverageOf(const BillboardPicture& picture);

/// Returns an atlas seen straight from a direction, as large as one of its views. Every pixel of the views
/// around the direction (viewsAround) is placed by its depth; if several views cover a place, the largest
/// coverage counts. \param views each way \param direction from the tree to the eye, unit, y >= 0
Coverage atlasCoverage(const BillboardPicture& atlas, int views, const glm::dvec3& direction);

/// Intersection over union.
struct Likeness
{
    double soft = 1.0; ///< sum over pixels of the lesser coverage, divided by the sum of the greater
    double hard = 1.0; ///< the same, counting pixels that are covered by at least half
};
/// \pre both have the same size
Likeness likenessOf(const Coverage& one, const Coverage& other);

/// Directions spread evenly over the upper hemisphere, from close to the top to close to the horizon (spiral
/// of Vogel 1979 on a sphere). \param count 1 or more \returns unit
std::vector<glm::dvec3> hemisphereDirections(int count);

} // namespace ramure
