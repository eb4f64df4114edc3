/// \file
/// From one pose of a tree to another: branches turn, none becomes longer.
#pragma once

#include "core/rig/physics/tree_body.h"
#include "core/rig/pose/pose.h"

namespace ramure {

/// Turns each bone of \p pose by the share \p weight (0..1) of the shorter way towards that of \p other.
/// Children follow the end of their branch, so that lengths stay exact and joints closed. The time stays.
/// \pre both have a bone per branch of the body.
void blendPose(const TreeBody& body, const Pose& other, double weight, Pose& pose);

} // namespace ramure
