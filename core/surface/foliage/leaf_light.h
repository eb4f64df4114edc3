/// \file
/// The light that leaves stand in, and what they make of it: leaves of the sun are smaller and lighter.
#pragma once

#include "core/surface/foliage/foliage.h"
#include <vector>

namespace ramure {

/// Returns for each leaf how much light reaches it: 0 in the middle of the crown or low at its edge, 1 on top
/// and outside. The crown is taken as the ellipsoid whose spread is that of the leaves.
std::vector<float> leafLight(const std::vector<FoliageItem>& leaves);

/// Makes the leaves in the shade larger and darker, those in the sun smaller (below 1 the other way round);
/// the geometric mean of their sizes stays. \param ratio area of a leaf in the deepest shade over one in full
/// sun; 1 changes nothing
void growByLight(double ratio, Foliage& foliage);

} // namespace ramure
