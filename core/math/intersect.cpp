#include "core/math/intersect.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

double side(const CutPlane& plane, const glm::dvec3& p)
{
    return glm::dot(glm::dvec3(plane), p) + plane.w;
}

} // namespace

std::optional<TriangleHit> intersect(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b,
                                     const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0)
        return std::nullopt;
    const glm::dvec3 toOrigin = ray.origin - a;
    const double u = glm::dot(toOrigin, p) / determinant;
    if (!(u >= 0.0 && u <= 1.0))
        return std::nullopt;
    const glm::dvec3 q = glm::cross(toOrigin, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    const double t = glm::dot(ac, q) / determinant;
    if (!(v >= 0.0 && u + v <= 1.0 && t >= 0.0))
        return std::nullopt;
    return TriangleHit{t, {1.0 - u - v, u, v}};
}

bool touches(std::span<const CutPlane> planes, const glm::dvec3& a, const glm::dvec3& b)
{
    double from = 0.0;
    double to = 1.0;
    for (const CutPlane& plane : planes) {
        const double atA = side(plane, a);
        const double atB = side(plane, b);
        if (atA < 0.0 && atB < 0.0)
            return false;
        if (atA < 0.0)
            from = std::max(from, atA / (atA - atB));
        else if (atB < 0.0)
            to = std::min(to, atA / (atA - atB));
        if (from > to)
            return false;
    }
    return true;
}

// The triangle is cut down plane by plane (Sutherland & Hodgman 1974); each cut adds at most one corner.
bool touches(std::span<const CutPlane> planes, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    std::array<glm::dvec3, 12> polygon{a, b, c};
    std::size_t count = 3;
    for (const CutPlane& plane : planes) {
        std::array<glm::dvec3, 12> cut;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count && kept + 2 <= cut.size(); ++i) {
            const glm::dvec3& p = polygon[i];
            const glm::dvec3& q = polygon[(i + 1) % count];
            const double atP = side(plane, p);
            const double atQ = side(plane, q);
            if (atP >= 0.0)
                cut[kept++] = p;
            if ((atP < 0.0) != (atQ < 0.0))
                cut[kept++] = p + atP / (atP - atQ) * (q - p);
        }
        if (kept == 0)
            return false;
        polygon = cut;
        count = kept;
    }
    return true;
}

} // namespace ramure
