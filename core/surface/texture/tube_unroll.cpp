#include "core/surface/texture/tube_unroll.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {

namespace {

/// The part of a vector across a unit direction, as a unit vector; any such where nothing is left.
glm::dvec3 across(const glm::dvec3& vector, const glm::dvec3& direction)
{
    const glm::dvec3 rest = vector - direction * glm::dot(vector, direction);
    const double square = glm::dot(rest, rest);
    if (square > 1e-12 * glm::dot(vector, vector))
        return rest * (1.0 / std::sqrt(square));
    return frameFromTangent(direction).normal;
}

/// The angle of a vector, rad, to 2e-9: finer than coordinates, which are floats, and a sixth of the time of
/// maths::atan2. The same on every processor, as it only adds, multiplies and divides.
double angleOf(double x, double y)
{
    const double acrossSize = std::abs(y), alongSize = std::abs(x);
    const double larger = std::max(acrossSize, alongSize);
    if (!(larger > 0.0))
        return 0.0;
    double t = std::min(acrossSize, alongSize) / larger; // of 0 to 45 degrees the tangent
    const bool isSteep = t > std::numbers::sqrt2 - 1.0;
    if (isSteep)
        t = (t - 1.0) / (t + 1.0);
    const double s = t * t;
    double angle =
        t + t * s *
                (-0.33333333333 +
                 s * (0.199999999 +
                      s * (-0.1428571 + s * (0.111109 + s * (-0.0908 + s * (0.0755 - s * 0.052))))));
    if (isSteep)
        angle += 0.25 * std::numbers::pi;
    if (acrossSize > alongSize)
        angle = 0.5 * std::numbers::pi - angle;
    return std::copysign(x < 0.0 ? std::numbers::pi - angle : angle, y);
}

constexpr double mostBend = 0.6;   ///< more of it would crowd the inside too much
constexpr double bendWithin = 2.0; ///< radii, within which a bend gives way to the next

} // namespace

void UnrollAxis::build(const TubeAxis& axis, const glm::dvec3& normal, const glm::dvec3& bend)
{
    const BranchCurve& curve = axis.curve;
    const glm::dvec3 way = curve.h1 - curve.h0;
    const glm::dvec3 c1 = curve.v0, c2 = 3.0 * way - 2.0 * curve.v0 - curve.v1,
                     c3 = curve.v0 + curve.v1 - 2.0 * way;
    const double least = 1e-12 * (glm::dot(way, way) + glm::dot(c1, c1) + 1e-300);
    glm::dvec3 tangent = hermite(curve.h0, curve.h1, curve.v0, curve.v1, 0.0).tangent, carried = normal;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double t = double(i) / double(steps);
        Node& node = m_nodes[i];
        node.point = i == steps ? curve.h1 : curve.h0 + t * (c1 + t * (c2 + t * c3));
        const glm::dvec3 derivative = c1 + t * (2.0 * c2 + 3.0 * t * c3);
        const double square = glm::dot(derivative, derivative);
        if (square > least)
            tangent = derivative * (1.0 / std::sqrt(square));
        carried = across(carried, tangent);
        node.frame = {tangent, carried, glm::cross(tangent, carried)};
        node.along = i == 0 ? 0.0 : m_nodes[i - 1].along + glm::length(node.point - m_nodes[i - 1].point);
        node.own = axis.a0 + (axis.a1 - axis.a0) * t;
        node.radius = axis.radiusAt(t);
    }
    bendNodes(bend);
    m_last = 0;
}

/// The bend at each node, after its tangents before and behind.
void UnrollAxis::bendNodes(const glm::dvec3& before)
{
    for (std::size_t i = 0; i <= steps; ++i) {
        const Node &from = m_nodes[i == 0 ? 0 : i - 1], &to = m_nodes[std::min(i + 1, steps)];
        Node& node = m_nodes[i];
        const double way = to.along - from.along;
        glm::dvec3 bend =
            way > 0.0 ? (to.frame.tangent - from.frame.tangent) * (node.radius / way) : glm::dvec3(0.0);
        const double part = std::min(node.along / (bendWithin * m_nodes[0].radius), 1.0);
        bend = before + (bend - before) * (part >= 0.0 ? part : 1.0);
        const double size = glm::length(bend);
        bend *= size > mostBend ? mostBend / size : 1.0;
        node.bend = {glm::dot(bend, node.frame.normal), glm::dot(bend, node.frame.binormal)};
    }
}

std::pair<std::size_t, double> UnrollAxis::find(double along) const
{
    std::size_t i = 0;
    while (i + 2 < m_nodes.size() && m_nodes[i + 1].along < along)
        ++i;
    const double span = m_nodes[i + 1].along - m_nodes[i].along;
    return {i, span > 0.0 ? std::clamp((along - m_nodes[i].along) / span, 0.0, 1.0) : 0.0};
}

UnrollAxis::Place UnrollAxis::place(const glm::dvec3& point)
{
    const auto ahead = [&](std::size_t i) {
        return glm::dot(point - m_nodes[i].point, m_nodes[i].frame.tangent);
    };
    std::size_t cell = std::min(m_last, steps - 1);
    double first = ahead(cell), second = ahead(cell + 1);
    while (second > 0.0 && cell + 1 < steps) {
        first = second;
        second = ahead(++cell + 1);
    }
    while (first < 0.0 && cell > 0) {
        second = first;
        first = ahead(--cell);
    }
    m_last = cell;
    const Node &a = m_nodes[cell], &b = m_nodes[cell + 1];
    const double span = first - second;
    const double part = span > 0.0 ? std::clamp(first / span, 0.0, 1.0) : 0.0;
    const auto between = [part](const auto& from, const auto& to) { return from + (to - from) * part; };
    const glm::dvec3 away = point - between(a.point, b.point);
    const double x = glm::dot(away, between(a.frame.normal, b.frame.normal));
    const double y = glm::dot(away, between(a.frame.binormal, b.frame.binormal));
    const double radius = between(a.radius, b.radius), distance = std::sqrt(x * x + y * y);
    const glm::dvec2 bend = between(a.bend, b.bend);
    Place place{between(a.along, b.along),
                angleOf(x, y),
                distance / radius,
                0.0,
                distance > 0.0 ? (bend.x * y - bend.y * x) / distance : 0.0,
                radius};
    if (second > 0.0)
        place.beyond = second / radius;
    else if (first < 0.0)
        place.beyond = -first / radius;
    return place;
}

} // namespace ramure
