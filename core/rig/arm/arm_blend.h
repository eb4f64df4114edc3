/// \file
/// From one pose of an arm to another.
#pragma once

#include "core/params/arm_params.h"
#include <span>
#include <vector>

namespace ramure {

/// Turns each angle of \p joints the share \p weight (0..1) of the way towards that of \p other: the shorter
/// way round, or, where the angle has limits, the way between them. \pre as many joints.
void blendJoints(std::span<const ArmJoint> other, double weight, std::vector<ArmJoint>& joints);

} // namespace ramure
