/// \file
/// Orientations as three angles about X, Y, Z of Rz * Ry * Rx: what fields and curves show of them. Radians.
#pragma once

#include "core/rig/tracks/track.h"
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace ramure {

/// Returns, of all angles that give this orientation, those nearest to \p near.
glm::dvec3 anglesOf(const glm::dquat& orientation, const glm::dvec3& near);
/// The same of a rotation matrix.
glm::dvec3 anglesOf(const glm::dmat3& rotation, const glm::dvec3& near);
/// A unit quaternion.
glm::dquat orientationOf(const glm::dvec3& angles);
/// Returns the angles of every key. They follow the orientation on its way between the keys, beyond half a
/// turn too. (On tracks with thousands of keys the ways between are not looked at.)
std::vector<glm::dvec3> anglesOfKeys(const OrientationTrack& track);

} // namespace ramure
