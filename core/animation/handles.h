/// \file
/// Where Bezier handles stand that are not put by hand, as Blender 3.4 computes them (ANIMATION 4.1).
#pragma once

#include "core/animation/key.h"
#include <vector>

namespace ramure {

/// Sets the handles of one curve. Vector: a third of the way to the neighbour. Auto: the mean slope of both
/// sides, flat at the ends. AutoClamped: of all smooth curves the one without a jump of the acceleration,
/// never beyond the values of the keys. Aligned: turned into line with the other side, its length kept; where
/// both are aligned, with the handle before. Free ones stay.
/// \param keys sorted, no two at one time.
void settleHandles(std::vector<Key>& keys);

} // namespace ramure
