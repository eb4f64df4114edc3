#include "core/math/frame.h"

#include "core/math/reproducible.h"
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// v / |v|. What was turned is a unit vector up to rounding: one step of Newton's method then does without
/// root and division, which a chain of frames would wait for at every link.
glm::dvec3 normalised(const glm::dvec3& v)
{
    const double squared = glm::dot(v, v);
    const bool almostUnit = std::abs(squared - 1.0) < 1e-8;
    return v * (almostUnit ? 1.5 - 0.5 * squared : 1.0 / std::sqrt(squared));
}

/// The frame with this unit tangent and the normal's part across it.
Frame orthonormal(const glm::dvec3& tangent, const glm::dvec3& normal)
{
    Frame frame;
    frame.tangent = tangent;
    frame.normal = normalised(normal - glm::dot(normal, tangent) * tangent);
    frame.binormal = glm::cross(tangent, frame.normal);
    return frame;
}

} // namespace

Frame frameFromTangent(const glm::dvec3& tangent)
{
    // The smallest rotation from +Y, spelled out; below the horizon by far it takes the careful way.
    if (tangent.y < -0.5)
        return transported(Frame(), tangent);
    const double share = tangent.x / (1.0 + tangent.y);
    Frame frame;
    frame.tangent = tangent;
    frame.normal = {1.0 - share * tangent.x, -tangent.x, -share * tangent.z};
    frame.binormal = glm::cross(tangent, frame.normal);
    return frame;
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
    const auto [sine, cosine] = maths::sincos(angleRad);
    return orthonormal(frame.tangent, cosine * frame.normal + sine * frame.binormal);
}

} // namespace ramure
