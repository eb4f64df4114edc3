/// \file
/// Exact little tests between rays, planes, segments and triangles, in doubles.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

namespace ramure {

/// A half-line; t counts in lengths of the direction, which need not be unit but must not be zero.
struct Ray
{
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

struct TriangleHit
{
    double t = 0.0;
    glm::dvec3 weights{0.0}; ///< barycentric, of the three corners
};

/// Möller & Trumbore 1997, both sides; nothing for rays in the triangle's plane and for t < 0.
std::optional<TriangleHit> intersect(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b,
                                     const glm::dvec3& c);

/// The half-space dot(plane, (p, 1)) >= 0.
using CutPlane = glm::dvec4;

/// Is any point of the segment, of the triangle, inside all half-spaces (at most 8)?
bool touches(std::span<const CutPlane> planes, const glm::dvec3& a, const glm::dvec3& b);
bool touches(std::span<const CutPlane> planes, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

} // namespace ramure
