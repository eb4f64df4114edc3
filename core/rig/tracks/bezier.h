/// \file
/// One segment of a Bezier curve over time, as Blender draws it (ANIMATION 4.1).
#pragma once

#include "core/rig/tracks/key.h"

namespace ramure {

/// Value at \p seconds from the segment's start. Handles that reach beyond the other end in time are first
/// shortened to it, both coordinates, so that time never runs backwards.
/// \param duration in seconds, above 0. \param v0, v1 the values at its ends.
double bezierValue(double duration, double v0, const Handle& out, const Handle& in, double v1,
                   double seconds);

} // namespace ramure
