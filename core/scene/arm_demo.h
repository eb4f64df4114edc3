/// \file
/// The demo of the articulated arm: `demo:Arm` (SPEC C).
#pragma once

#include "core/scene/scene.h"

namespace ramure {

/// The default arm on a terrain that gives it targets; it follows one a little over the ground.
Scene armDemo();

} // namespace ramure
