#include "core/math/hermite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Exact at both ends, unlike a + t (b - a).
glm::dvec3 mix(const glm::dvec3& a, const glm::dvec3& b, double t)
{
    return (1.0 - t) * a + t * b;
}

/// Steps between the four Bezier points: the control points of a third of the derivative.
struct Steps
{
    glm::dvec3 a, b, c;
};

/// Where the first derivative vanishes, the next ones that do not tell where the curve is going. At the end
/// of the curve one looks back: what grows before the end grows there with the other sign.
glm::dvec3 limitDirection(const Steps& steps, double t, double small)
{
    const glm::dvec3 second = mix(steps.b - steps.a, steps.c - steps.b, t);
    if (glm::length(second) > small)
        return glm::normalize(t < 1.0 ? second : -second);
    const glm::dvec3 third = (steps.c - steps.b) - (steps.b - steps.a);
    if (glm::length(third) > small)
        return glm::normalize(third);
    return {0.0, 1.0, 0.0};
}

glm::dvec3 unitTangent(const Steps& steps, double t)
{
    const glm::dvec3 first = mix(mix(steps.a, steps.b, t), mix(steps.b, steps.c, t), t);
    const double squared = glm::dot(first, first);
    const double scale =
        std::max({glm::dot(steps.a, steps.a), glm::dot(steps.b, steps.b), glm::dot(steps.c, steps.c)});
    // 1e-14 of the longest step is what rounding leaves of a derivative that vanishes.
    if (squared > 1e-28 * scale)
        return first / std::sqrt(squared);
    return limitDirection(steps, t, 1e-14 * std::sqrt(scale));
}

} // namespace

CurvePoint hermite(const glm::dvec3& h0, const glm::dvec3& h1, const glm::dvec3& v0, const glm::dvec3& v1,
                   double t)
{
    constexpr double third = 1.0 / 3.0;
    const glm::dvec3 start = third * v0, end = third * v1;
    const glm::dvec3 b1 = h0 + start;
    const glm::dvec3 b2 = h1 - end;
    const glm::dvec3 left = mix(h0, b1, t), middle = mix(b1, b2, t), right = mix(b2, h1, t);
    // The steps come from the derivatives, not from differences of points, which lose digits far from the
    // origin.
    const Steps steps{start, (h1 - h0) - (start + end), end};
    return {mix(mix(left, middle, t), mix(middle, right, t), t), unitTangent(steps, t)};
}

} // namespace ramure
