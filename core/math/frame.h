/// \file
/// Rotation-minimising frames.
#pragma once

#include <glm/vec3.hpp>

namespace ramure {

/// Right-handed and orthonormal: binormal = tangent x normal.
struct Frame
{
    glm::dvec3 tangent{0.0, 1.0, 0.0};
    glm::dvec3 normal{1.0, 0.0, 0.0};
    glm::dvec3 binormal{0.0, 0.0, -1.0};
};

/// A frame with this unit tangent and any normal, chosen the same way every time (+Y gives the Frame's
/// defaults).
Frame frameFromTangent(const glm::dvec3& tangent);

/// The frame turned by the smallest rotation that takes its tangent to \p tangent (unit), re-orthonormalised.
/// Antiparallel tangents: half a turn about the normal.
Frame transported(const Frame& frame, const glm::dvec3& tangent);

/// The frame turned by \p angleRad about its tangent (counter-clockwise seen against the tangent).
Frame rolled(const Frame& frame, double angleRad);

} // namespace ramure
