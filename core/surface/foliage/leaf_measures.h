/// \file
/// What botanists measure of a crown's leaves.
#pragma once

#include "core/surface/foliage/foliage.h"

namespace ramure {

struct LeafMeasures
{
    std::size_t leaves = 0; ///< those that hang
    double length = 0.0;    ///< m, median, without the petiole
    double reach = 0.0;     ///< m, median, from the foot of the petiole to the tip
    double area = 0.0;      ///< m², one side of all blades, half of the surface of needles
    double areaIndex = 0.0; ///< that over the ground below the crown; 0 without a crown
};

/// \param alpha radius of the trunk, m. \param crownWidth m, see TreeMeasures.
/// \pre the shape of the leaves is not Faithful.
LeafMeasures leafMeasures(const Foliage& foliage, double alpha, double crownWidth);

} // namespace ramure
