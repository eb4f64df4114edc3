/// \file
/// The heart of damped least squares: three equations, whatever the number of angles.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace ramure {

/// The solution of a symmetric, positive definite system.
inline glm::dvec3 solvedSymmetric(const glm::dmat3& m, const glm::dvec3& right)
{
    const glm::dvec3 c0 = glm::cross(m[1], m[2]), c1 = glm::cross(m[2], m[0]), c2 = glm::cross(m[0], m[1]);
    return (c0 * right.x + c1 * right.y + c2 * right.z) / glm::dot(m[0], c0);
}

} // namespace ramure
