/// \file
/// Blender's easings (ANIMATION 4.1, checked against Blender 3.4.1).
#pragma once

#include "core/rig/tracks/key.h"

namespace ramure {

/// How far the way has come: value = start + change * share. Exactly 0 at x = 0 and 1 at x = 1.
/// \param shape of the key that begins the way; its mode is one of the easings.
/// \param x 0..1.
/// \param durationSeconds of the way, above 0.
/// \param change of the value over the way; only Elastic looks at it, whose amplitude is in units of the
/// value.
double easedShare(const KeyShape& shape, double x, double durationSeconds, double change);

} // namespace ramure
