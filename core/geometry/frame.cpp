#include "core/geometry/frame.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// The frame with this unit tangent and the normal's part across it.
Frame orthonormal(const glm::dvec3& tangent, const glm::dvec3& normal)
{
    Frame frame;
    frame.tangent = tangent;
    frame.normal = glm::normalize(normal - glm::dot(normal, tangent) * tangent);
    frame.binormal = glm::cross(tangent, frame.normal);
    return frame;
}

} // namespace

Frame frameFromTangent(const glm::dvec3& tangent)
{
    return transported(Frame(), tangent);
}

Frame transported(const Frame& frame, const glm::dvec3& tangent)
{
    // The smallest rotation from t to u moves a vector n across t to n - (n·u) / (1 + t·u) (t + u).
    // 1 + t·u is taken as |t + u|² / 2, which keeps its digits near a half turn.
    const glm::dvec3 sum = frame.tangent + tangent;
    const double onePlusCos = 0.5 * glm::dot(sum, sum);
    // Within 1e-14 rad of a half turn the axis is lost in rounding.
    if (onePlusCos < 1e-28)
        return orthonormal(tangent, frame.normal);
    const double share = glm::dot(frame.normal, tangent) / onePlusCos;
    return orthonormal(tangent, frame.normal - share * sum);
}

Frame rolled(const Frame& frame, double angleRad)
{
    const double cosine = std::cos(angleRad), sine = std::sin(angleRad);
    return orthonormal(frame.tangent, cosine * frame.normal + sine * frame.binormal);
}

} // namespace ramure
