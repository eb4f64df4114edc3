/// \file
/// Turns drags of the mouse into movements along an axis, in a plane or around a ring, and snaps values to
/// steps. The functions are pure and take rays in world space, metres and radians. Each returns nothing if
/// the view does not determine the answer: an axis seen from its end, a plane seen from its edge.
#pragma once

#include "core/math/intersect.h"
#include <glm/mat3x3.hpp>

namespace ramure {

/// Sine of the angle below which an axis counts as seen from its end, or a plane from its edge.
inline constexpr double leastSightSine = 0.02;

/// Returns where along the axis origin + s * direction (unit) the ray comes closest to it, in metres.
std::optional<double> alongAxis(const Ray& ray, const glm::dvec3& origin, const glm::dvec3& direction);
/// Returns where the ray's line meets the plane; nothing if that is behind the ray's origin.
std::optional<glm::dvec3> onPlane(const Ray& ray, const glm::dvec3& origin, const glm::dvec3& normal);
/// The angle about \p axis (unit, right hand), from \p zero (unit, perpendicular to the axis) to where the
/// ray meets the ring's plane: -pi .. pi.
std::optional<double> aroundRing(const Ray& ray, const glm::dvec3& centre, const glm::dvec3& axis,
                                 const glm::dvec3& zero);

/// The nearest multiple of \p step; the value itself where the step is not above 0. Steps that no binary
/// number can be (0.1) give the nearest number to the decimal multiple: 0.3, not 0.30000000000000004.
double snapped(double value, double step);

/// Returns the axes of a matrix as a right-angled frame of unit vectors: the first keeps its direction, the
/// second its plane, the third its side. An axis without length is chosen to complete the others.
glm::dmat3 squareFrame(const glm::dmat3& axes);
/// The rotation (or rotation and mirror image) nearest to a matrix, by polar decomposition (Higham 1986).
/// \pre the determinant is not 0.
glm::dmat3 nearestRotation(const glm::dmat3& matrix);
/// Rotation matrix about a unit axis, right hand.
glm::dmat3 turnAbout(const glm::dvec3& axis, double angleRad);
/// Any unit vector perpendicular to \p direction (not zero), always the same one.
glm::dvec3 anyPerpendicular(const glm::dvec3& direction);

} // namespace ramure
