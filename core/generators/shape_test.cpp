#include "core/generators/shape_test.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace ramure {
namespace {

/// Every edge is there once in each direction.
bool isClosed(const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, back;
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            edges.emplace_back(t[i], t[(i + 1) % 3]);
            back.emplace_back(t[(i + 1) % 3], t[i]);
        }
    std::ranges::sort(edges);
    std::ranges::sort(back);
    return edges == back && std::ranges::adjacent_find(edges) == edges.end();
}

} // namespace

ShapeTest::ShapeTest(const EditShape& shape)
    : m_shape(shape)
{
    if (shape.kind != EditShapeKind::Mesh)
        return;
    m_isClosed = isClosed(shape.triangles);
    std::vector<PrimitiveBounds> bounds;
    double volume = 0.0;
    for (Index i = 0; i < shape.triangles.size(); ++i) {
        const auto& t = shape.triangles[i];
        const glm::vec3 a(shape.points[t[0]]), b(shape.points[t[1]]), c(shape.points[t[2]]);
        bounds.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
        volume += glm::dot(shape.points[t[0]] - shape.points[shape.triangles[0][0]], areaVector(i));
    }
    m_triangles = Bvh(std::move(bounds));
    m_outward = volume < 0.0 ? -1.0 : 1.0;
}

Expected<void> ShapeTest::check() const
{
    return m_isClosed ? Expected<void>()
                      : fail(ErrorCode::Invalid, RAMURE_NOOP("the mesh is not closed: it has no inside"));
}

bool ShapeTest::contains(const glm::dvec3& p) const
{
    const auto& n = m_shape.numbers;
    const glm::dvec3 from = p - glm::dvec3(n[0], n[1], n[2]);
    switch (m_shape.kind) {
    case EditShapeKind::Sphere:
        return glm::dot(from, from) <= n[3] * n[3];
    case EditShapeKind::Box:
        return from.x >= 0.0 && from.y >= 0.0 && from.z >= 0.0 && p.x <= n[3] && p.y <= n[4] && p.z <= n[5];
    case EditShapeKind::Cone: {
        const double radius = n[3] * (1.0 - from.y / n[4]);
        return from.y >= 0.0 && radius >= 0.0 && from.x * from.x + from.z * from.z <= radius * radius;
    }
    case EditShapeKind::Profile:
        return inProfile(from);
    case EditShapeKind::Mesh:
        return inMesh(p);
    }
    return false;
}

bool ShapeTest::inProfile(const glm::dvec3& from) const
{
    const std::vector<glm::dvec3>& outline = m_shape.points;
    const auto above = std::ranges::lower_bound(outline, from.y, {}, &glm::dvec3::y);
    if (above == outline.end() || (above == outline.begin() && above->y > from.y))
        return false;
    double radius = above->x;
    if (above != outline.begin()) {
        const glm::dvec3& low = *(above - 1);
        radius = low.x + (from.y - low.y) / (above->y - low.y) * (above->x - low.x);
    }
    return from.x * from.x + from.z * from.z <= radius * radius;
}

/// The first face along a ray that is along no edge of what artists build.
bool ShapeTest::inMesh(const glm::dvec3& point) const
{
    const Ray ray{point, glm::dvec3(0.0172, 1.0, 0.0091)};
    double nearest = std::numeric_limits<double>::max();
    Index face = noIndex;
    m_triangles.alongRay(ray, nearest, [&](Index i, double& tMost) {
        const auto& t = m_shape.triangles[i];
        const auto hit = intersect(ray, m_shape.points[t[0]], m_shape.points[t[1]], m_shape.points[t[2]]);
        if (!hit || hit->t > nearest || (hit->t == nearest && i > face))
            return;
        nearest = tMost = hit->t;
        face = i;
    });
    return face != noIndex && m_outward * glm::dot(areaVector(face), ray.direction) > 0.0;
}

glm::dvec3 ShapeTest::areaVector(Index triangle) const
{
    const auto& t = m_shape.triangles[triangle];
    return glm::cross(m_shape.points[t[1]] - m_shape.points[t[0]],
                      m_shape.points[t[2]] - m_shape.points[t[0]]);
}

} // namespace ramure
