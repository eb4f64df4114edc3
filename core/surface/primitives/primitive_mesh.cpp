#include "core/surface/primitives/primitive_mesh.h"

#include "core/math/reproducible.h"
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>

namespace ramure {
namespace {

/// Radius and height of a point of an outline.
struct OutlinePoint
{
    double radius, height;
};

enum class Edges : std::uint8_t { Sharp, Smooth };

/// Turns outlines about Y, from the lowest point to the highest.
class Lathe
{
public:
    explicit Lathe(std::int64_t sides)
        : m_sides(sides)
    {
    }
    void turn(const std::vector<OutlinePoint>& outline, Edges edges)
    {
        for (std::size_t i = 0; i + 1 < outline.size(); ++i)
            belt(outline[i], outline[i + 1], edges);
    }
    TriangleMesh mesh;

private:
    /// The last side ends exactly where the first begins.
    [[nodiscard]] glm::dvec3 direction(std::int64_t side) const
    {
        const auto [sine, cosine] =
            maths::sincos(2.0 * std::numbers::pi * double(side % m_sides) / double(m_sides));
        return {sine, 0.0, cosine};
    }
    Index add(const OutlinePoint& point, const glm::dvec3& around, const glm::dvec3& normal)
    {
        // + 0.0: on the axis there is one position, not one with -0 as well.
        mesh.positions.emplace_back(around * point.radius + glm::dvec3(0.0, point.height, 0.0) + 0.0);
        mesh.normals.emplace_back(normal);
        return mesh.vertexCount() - 1;
    }
    void belt(const OutlinePoint& low, const OutlinePoint& high, Edges edges)
    {
        const double rise = high.height - low.height, inwards = low.radius - high.radius;
        const double length = maths::hypot(rise, inwards);
        for (std::int64_t side = 0; side < m_sides; ++side) {
            const glm::dvec3 a = direction(side), b = direction(side + 1);
            const glm::dvec3 middle = glm::normalize(a + b);
            const auto normal = [&](const OutlinePoint& point, const glm::dvec3& around) {
                if (edges == Edges::Smooth)
                    return glm::normalize(around * point.radius + glm::dvec3(0.0, point.height, 0.0));
                // Round about the axis, sharp along the outline; at a tip as in the middle of the side.
                return ((point.radius > 0.0 ? around : middle) * rise + glm::dvec3(0.0, inwards, 0.0)) /
                       length;
            };
            const Index p = add(low, a, normal(low, a)), q = add(high, a, normal(high, a));
            const Index r = low.radius > 0.0 ? add(low, b, normal(low, b)) : p;
            const Index s = high.radius > 0.0 ? add(high, b, normal(high, b)) : q;
            if (r != p)
                mesh.triangles.emplace_back(p, r, s);
            if (s != q)
                mesh.triangles.emplace_back(p, s, q);
        }
    }

    std::int64_t m_sides;
};

TriangleMesh turned(std::int64_t sides, const std::vector<OutlinePoint>& outline)
{
    Lathe lathe(sides);
    lathe.turn(outline, Edges::Sharp);
    return std::move(lathe.mesh);
}

TriangleMesh sphere(const PrimitiveParams& params)
{
    const std::int64_t rings = std::max<std::int64_t>(2, params.sides / 2);
    std::vector<OutlinePoint> outline{{0.0, -params.radius}};
    for (std::int64_t i = 1; i < rings; ++i) {
        const auto [sine, cosine] = maths::sincos(std::numbers::pi * double(i) / double(rings));
        outline.push_back({params.radius * sine, -params.radius * cosine});
    }
    outline.push_back({0.0, params.radius});
    Lathe lathe(params.sides);
    lathe.turn(outline, Edges::Smooth);
    return std::move(lathe.mesh);
}

/// A rectangle with its normal u x v.
void addFace(TriangleMesh& mesh, const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v)
{
    const Index first = mesh.vertexCount();
    const glm::vec3 normal(glm::normalize(glm::cross(u, v)));
    for (const glm::dvec3& corner : {-u - v, u - v, u + v, v - u}) {
        mesh.positions.emplace_back(centre + corner + 0.0);
        mesh.normals.push_back(normal);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
}

TriangleMesh box(const glm::dvec3& size)
{
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-0.5, 0.5}) {
            glm::dvec3 out(0.0), u(0.0), v(0.0);
            out[axis] = side * size[axis];
            u[(axis + 1) % 3] = 0.5 * size[(axis + 1) % 3];
            v[(axis + 2) % 3] = 0.5 * size[(axis + 2) % 3];
            side > 0.0 ? addFace(mesh, out, u, v) : addFace(mesh, out, v, u);
        }
    return mesh;
}

TriangleMesh plane(const glm::dvec3& size)
{
    TriangleMesh mesh;
    addFace(mesh, glm::dvec3(0.0), {0.0, 0.0, 0.5 * size.z}, {0.5 * size.x, 0.0, 0.0});
    return mesh;
}

/// What stands along Y stands along another axis, turned, not mirrored.
void standAlong(TriangleMesh& mesh, PrimitiveAxis axis)
{
    const auto turn = [axis](glm::vec3& v) {
        v = axis == PrimitiveAxis::X ? glm::vec3(v.y, v.z, v.x) : glm::vec3(v.z, v.x, v.y);
    };
    if (axis == PrimitiveAxis::Y)
        return;
    for (glm::vec3& p : mesh.positions)
        turn(p);
    for (glm::vec3& n : mesh.normals)
        turn(n);
}

void append(TriangleMesh& mesh, const TriangleMesh& more)
{
    const Index first = mesh.vertexCount();
    mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
    mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
    for (const glm::uvec3& t : more.triangles)
        mesh.triangles.push_back(t + glm::uvec3(first));
}

/// Three arrows that begin a little away from each other, so that each is a solid of its own.
TriangleMesh frameCross(const PrimitiveParams& params)
{
    const double thick = std::min(params.radius, 0.2 * params.height), tip = 0.75 * params.height;
    TriangleMesh mesh;
    for (const PrimitiveAxis axis : {PrimitiveAxis::X, PrimitiveAxis::Y, PrimitiveAxis::Z}) {
        TriangleMesh arrow = turned(
            params.sides,
            {{0.0, thick}, {0.5 * thick, thick}, {0.5 * thick, tip}, {thick, tip}, {0.0, params.height}});
        standAlong(arrow, axis);
        append(mesh, arrow);
    }
    return mesh;
}

} // namespace

TriangleMesh primitiveMesh(const PrimitiveParams& params)
{
    const double radius = params.radius, height = params.height;
    TriangleMesh mesh;
    switch (params.shape) {
    case PrimitiveShape::Cylinder:
        mesh = turned(params.sides, {{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}});
        break;
    case PrimitiveShape::Sphere:
        mesh = sphere(params);
        break;
    case PrimitiveShape::Box:
        mesh = box(params.size);
        break;
    case PrimitiveShape::Cone:
        mesh = turned(params.sides, {{0.0, 0.0}, {radius, 0.0}, {0.0, height}});
        break;
    case PrimitiveShape::Plane:
        mesh = plane(params.size);
        break;
    case PrimitiveShape::FrameCross:
        return frameCross(params);
    }
    standAlong(mesh, params.axis);
    return mesh;
}

TriangleMesh welded(const TriangleMesh& mesh)
{
    TriangleMesh out;
    std::map<std::tuple<float, float, float>, Index> known;
    std::vector<Index> became;
    became.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        const auto [place, isNew] = known.try_emplace({p.x, p.y, p.z}, out.vertexCount());
        if (isNew)
            out.positions.push_back(p);
        became.push_back(place->second);
    }
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::uvec3 joined(became[t.x], became[t.y], became[t.z]);
        if (joined.x != joined.y && joined.y != joined.z && joined.z != joined.x)
            out.triangles.push_back(joined);
    }
    return out;
}

TriangleMesh primitiveSolid(const PrimitiveParams& params)
{
    return welded(primitiveMesh(params));
}

} // namespace ramure
