#include "core/rig/tracks/quaternions.h"

#include "core/math/reproducible.h"
#include <cmath>

namespace ramure {

glm::dquat unit(const glm::dquat& q, const glm::dquat& fallback)
{
    const double length = std::sqrt(glm::dot(q, q));
    return length > 1e-12 && std::isfinite(length) ? q / length : fallback;
}

glm::dvec3 logarithm(const glm::dquat& q)
{
    const glm::dvec3 v{q.x, q.y, q.z};
    const double sine = std::sqrt(glm::dot(v, v));
    return sine < 1e-15 ? glm::dvec3(0.0) : v * (maths::atan2(sine, q.w) / sine);
}

glm::dquat exponential(const glm::dvec3& halfTurn)
{
    const double angle = std::sqrt(glm::dot(halfTurn, halfTurn));
    if (angle < 1e-15)
        return {1.0, 0.0, 0.0, 0.0};
    const auto [sine, cosine] = maths::sincos(angle);
    return {cosine, halfTurn * (sine / angle)};
}

glm::dquat slerped(const glm::dquat& a, const glm::dquat& b, double u)
{
    if (u == 0.0)
        return a;
    if (u == 1.0)
        return b;
    const double cosine = glm::dot(a, b);
    const glm::dquat across = b - a * cosine;
    const double sine = std::sqrt(glm::dot(across, across));
    if (sine < 1e-12) // one orientation; with opposite signs there is no way to go
        return a;
    const maths::SinCos turned = maths::sincos(maths::atan2(sine, cosine) * u);
    return unit(a * turned.cos + across * (turned.sin / sine), a);
}

glm::dquat squadded(const glm::dquat& a, const glm::dquat& sa, const glm::dquat& sb, const glm::dquat& b,
                    double u)
{
    return slerped(slerped(a, b, u), slerped(sa, sb, u), 2.0 * u * (1.0 - u));
}

} // namespace ramure
