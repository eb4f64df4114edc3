/// \file
/// What an engine makes of an atlas of views: how it covers a picture from any direction, and how much that
/// is what the tree itself covers.
#pragma once

#include "core/lod/billboard_picture.h"

namespace ramure {

/// How much of each pixel is covered, 0..1; rows from the top.
using Coverage = std::vector<float>;
/// Measures the alpha of a picture.
Coverage coverageOf(const BillboardPicture& picture);

/// An atlas seen straight from a direction, as large as one of its views. Every pixel of the views
/// around the direction (viewsAround) stands where its depth says; of what several show, the most is seen.
/// \param views each way \param direction from the tree to the eye, unit, y >= 0
Coverage atlasCoverage(const BillboardPicture& atlas, int views, const glm::dvec3& direction);

/// Intersection over union.
struct Likeness
{
    double soft = 1.0; ///< of shares of pixels: the sum of the lesser over that of the greater
    double hard = 1.0; ///< of the pixels that are covered by half and more
};
/// \pre both have the same size
Likeness likenessOf(const Coverage& one, const Coverage& other);

/// Directions spread evenly over the upper hemisphere, from close to the top to close to the horizon (spiral
/// of Vogel 1979 on a sphere). \param count 1 or more \returns unit
std::vector<glm::dvec3> hemisphereDirections(int count);

} // namespace ramure
