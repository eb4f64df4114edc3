/// \file
/// Ways between orientations (ANIMATION 4.3). All quaternions are units.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace ramure {

/// The axis times half the angle, of the turn that \p q does by its own sign. Zero for 1 and -1.
glm::dvec3 logarithm(const glm::dquat& q);
glm::dquat exponential(const glm::dvec3& halfTurn);
/// From a to b along the great circle by the signs they have; u may lie outside 0..1. The result is a unit.
glm::dquat slerped(const glm::dquat& a, const glm::dquat& b, double u);
/// Between a and b with the inner points sa and sb (Shoemake 1987).
glm::dquat squadded(const glm::dquat& a, const glm::dquat& sa, const glm::dquat& sb, const glm::dquat& b,
                    double u);
/// Unit again; a quaternion without a direction becomes \p fallback.
glm::dquat unit(const glm::dquat& q, const glm::dquat& fallback);

} // namespace ramure
