/// \file
/// Turns branches about their starts; their children follow. Lengths and keys stay.
#pragma once

#include "core/skeleton/skeleton.h"
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <vector>

namespace ramure {

/// A rotation as a vector: its axis, as long as the angle in radians, and back (angle in 0..pi).
glm::dquat bendRotation(const glm::dvec3& bendRad);
glm::dvec3 bendVector(const glm::dquat& rotation);

/// Returns the rotation of every branch against the unbent skeleton. The turns of its ancestors come after
/// its own, so that a branch keeps its place on its parent when that is turned. \param bendRad one per
/// branch.
std::vector<glm::dquat> bendRotations(const Skeleton& skeleton, std::span<const glm::dvec3> bendRad);

/// Turns every branch about its start. Branches without a bend, and below none, keep their bytes; all others
/// their lengths to a few roundings. \param bendRad one per branch, finite; vectors in tree space, radians.
void bendBranches(Skeleton& skeleton, std::span<const glm::dvec3> bendRad);

} // namespace ramure
