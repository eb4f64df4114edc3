#include "core/surface/foliage/twig_line.h"

#include <algorithm>

namespace ramure {

glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& way, const glm::dvec3& otherwise)
{
    const glm::dvec3 left = v - glm::dot(v, way) * way;
    return glm::length(left) > 1e-6 ? glm::normalize(left) : otherwise;
}

TwigLine::TwigLine(const Skeleton& skeleton, Index twig)
    : m_curve(branchCurve(skeleton, twig))
    , m_radius0(skeleton.a0[twig])
    , m_radius1(skeleton.a1[twig])
{
    for (std::size_t i = 0; i <= pieces; ++i) {
        const CurvePoint at = hermite(m_curve.h0, m_curve.h1, m_curve.v0, m_curve.v1, double(i) / pieces);
        m_points[i] = at.point;
        m_frames[i] = i == 0 ? frameFromTangent(at.tangent) : transported(m_frames[i - 1], at.tangent);
        m_lengths[i] = i == 0 ? 0.0 : m_lengths[i - 1] + glm::length(at.point - m_points[i - 1]);
    }
}

TwigLine::Place TwigLine::at(double along) const
{
    std::size_t i = 1;
    while (i < pieces && m_lengths[i] < along)
        ++i;
    const double piece = m_lengths[i] - m_lengths[i - 1];
    const double share = piece > 0.0 ? std::clamp((along - m_lengths[i - 1]) / piece, 0.0, 1.0) : 1.0;
    const double t = (double(i - 1) + share) / pieces;
    const CurvePoint on = hermite(m_curve.h0, m_curve.h1, m_curve.v0, m_curve.v1, t);
    return {on.point, transported(m_frames[i], on.tangent), (1.0 - t) * m_radius0 + t * m_radius1};
}

double twigLength(const Skeleton& skeleton, Index twig)
{
    const BranchCurve curve = branchCurve(skeleton, twig);
    double length = 0.0;
    glm::dvec3 before = curve.h0;
    for (std::size_t i = 0; i <= TwigLine::pieces; ++i) {
        const glm::dvec3 point =
            hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(i) / TwigLine::pieces).point;
        length += i == 0 ? 0.0 : glm::length(point - before);
        before = point;
    }
    return length;
}

double firstNode(const Skeleton& skeleton, Index twig)
{
    const Index parent = skeleton.parent[twig];
    return 1.5 * std::max(skeleton.a0[twig], parent == noIndex ? 0.0 : skeleton.a1[parent]);
}

} // namespace ramure
