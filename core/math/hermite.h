/// \file
/// Cubic Hermite curve (SPEC A4), evaluated by de Casteljau over its Bezier points.
#pragma once

#include <glm/vec3.hpp>

namespace ramure {

struct CurvePoint
{
    glm::dvec3 point;
    glm::dvec3 tangent; ///< unit, also where the derivative vanishes
};

/// Evaluates a cubic Hermite curve. \param h0,h1 end points \param v0,v1 end derivatives \param t in [0, 1]
/// (exact at 0 and 1). If the derivative vanishes, the tangent is the limit along the curve. A curve of one
/// point gives +Y.
CurvePoint hermite(const glm::dvec3& h0, const glm::dvec3& h1, const glm::dvec3& v0, const glm::dvec3& v1,
                   double t);

} // namespace ramure
