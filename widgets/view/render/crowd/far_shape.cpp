#include "widgets/view/render/crowd/far_shape.h"

#include "core/math/box.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

struct ShapeExtent
{
    Box box;
    glm::dvec3 facing{0.0}; ///< the sum of the faces' area vectors: zero where they close
    glm::dvec3 middle{0.0}; ///< the mean place of the area
    double area = 0.0;
};

glm::dvec3 areaVector(const TriangleMesh& shape, const glm::uvec3& face)
{
    const glm::dvec3 a(shape.positions[face[0]]), b(shape.positions[face[1]]), c(shape.positions[face[2]]);
    return 0.5 * glm::cross(b - a, c - a);
}

glm::dvec3 middleOf(const TriangleMesh& shape, const glm::uvec3& face)
{
    return glm::dvec3(shape.positions[face[0]] + shape.positions[face[1]] + shape.positions[face[2]]) / 3.0;
}

ShapeExtent extentOf(const TriangleMesh& shape)
{
    ShapeExtent extent;
    for (const glm::uvec3& face : shape.triangles) {
        const glm::dvec3 vector = areaVector(shape, face);
        const double area = glm::length(vector);
        extent.facing += vector;
        extent.area += area;
        extent.middle += area * middleOf(shape, face);
        for (int corner = 0; corner < 3; ++corner)
            extent.box.add(glm::dvec3(shape.positions[face[corner]]));
    }
    extent.middle /= std::max(extent.area, 1e-300);
    return extent;
}

/// Where a flat shape is longest: the larger principal axis of its area, across \p normal.
glm::dvec3 longestAcross(const TriangleMesh& shape, const ShapeExtent& extent, const glm::dvec3& normal)
{
    const glm::dvec3 some = std::abs(normal.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(normal, some)), v = glm::cross(normal, u);
    double uu = 0.0, uv = 0.0, vv = 0.0;
    for (const glm::uvec3& face : shape.triangles) {
        const double area = glm::length(areaVector(shape, face));
        const glm::dvec3 arm = middleOf(shape, face) - extent.middle;
        const double along = glm::dot(arm, u), across = glm::dot(arm, v);
        uu += area * along * along;
        uv += area * along * across;
        vv += area * across * across;
    }
    const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
    return std::cos(angle) * u + std::sin(angle) * v;
}

void add(TriangleMesh& made, const glm::dvec3& position, const glm::dvec3& normal)
{
    made.positions.emplace_back(position);
    made.normals.emplace_back(normal);
}

/// A rhombus of the same area, as long as the same second moment asks: a stalk hardly makes it longer.
TriangleMesh rhombus(const TriangleMesh& shape, const ShapeExtent& extent)
{
    TriangleMesh made;
    const glm::dvec3 normal = glm::normalize(extent.facing);
    const glm::dvec3 along = longestAcross(shape, extent, normal), across = glm::cross(normal, along);
    double spread = 0.0; // the second moment of area
    for (const glm::uvec3& face : shape.triangles) {
        const auto at = [&](int corner) {
            return glm::dot(glm::dvec3(shape.positions[face[corner]]) - extent.middle, along);
        };
        const double a = at(0), b = at(1), c = at(2);
        spread +=
            glm::length(areaVector(shape, face)) * (a * a + b * b + c * c + a * b + b * c + c * a) / 6.0;
    }
    if (spread <= 0.0)
        return made;
    const double most = std::sqrt(6.0 * spread / extent.area), half = 0.5 * extent.area / most;
    add(made, extent.middle - most * along, normal);
    add(made, extent.middle - half * across, normal);
    add(made, extent.middle + most * along, normal);
    add(made, extent.middle + half * across, normal);
    made.triangles = {{0, 1, 2}, {0, 2, 3}};
    return made;
}

/// An octahedron whose middle sections have the area of the ellipses in the box.
TriangleMesh octahedron(const ShapeExtent& extent)
{
    constexpr double wider = 1.2533141373155003; // sqrt(pi / 2)
    TriangleMesh made;
    const glm::dvec3 centre = extent.box.centre();
    const glm::dvec3 half = 0.5 * wider * (extent.box.max - extent.box.min);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {1.0, -1.0}) {
            glm::dvec3 way(0.0);
            way[axis] = side;
            add(made, centre + half * way, way);
        }
    }
    for (const Index x : {0u, 1u})
        for (const Index y : {2u, 3u})
            for (const Index z : {4u, 5u})
                made.triangles.push_back((x + y + z) % 2 == 0 ? glm::uvec3(x, y, z) : glm::uvec3(x, z, y));
    return made;
}

} // namespace

TriangleMesh farShape(const TriangleMesh& shape)
{
    constexpr double closing = 0.05; // of the area: less is a closed surface's rest
    const ShapeExtent extent = extentOf(shape);
    if (extent.area <= 0.0)
        return {};
    return glm::length(extent.facing) > closing * extent.area ? rhombus(shape, extent) : octahedron(extent);
}

TriangleMesh widened(TriangleMesh few, const TriangleMesh& whole)
{
    const ShapeExtent extent = extentOf(few);
    if (extent.area <= 0.0 || glm::length(extent.facing) <= 0.0)
        return few;
    const glm::dvec3 normal = glm::normalize(extent.facing);
    const glm::dvec3 across = glm::cross(normal, longestAcross(few, extent, normal));
    const double wider = std::clamp(extentOf(whole).area / extent.area, 1.0, 1.5) - 1.0;
    for (glm::vec3& position : few.positions)
        position += glm::vec3(wider * glm::dot(glm::dvec3(position) - extent.middle, across) * across);
    return few;
}

} // namespace ramure
