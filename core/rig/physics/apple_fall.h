/// \file
/// Apples that came off: they fall, bounce on the ground y = 0, roll and come to rest.
#pragma once

#include "core/params/physics_params.h"
#include "core/rig/physics/physics_state.h"

namespace ramure {

/// Acceleration of free fall at gravity 1, m/s².
inline constexpr double earthGravity = 9.81;

/// Moves one apple on by \p seconds. The parabola is exact, the moment of each bounce too; an apple never
/// sinks below the ground, and its energy never grows. \p radius in metres.
void stepLooseApple(LooseApple& apple, const PhysicsParams& params, double radius, double seconds);

} // namespace ramure
