/// \file
/// SPEC A7, to the letter.
#pragma once

#include "core/rig/physics/step_arrays.h"

namespace ramure {

/// One step of params.stepSeconds from state.timeSeconds on. Leaves time and step of the state alone.
void faithfulStep(const StepInputs& in, PhysicsState& state);

} // namespace ramure
