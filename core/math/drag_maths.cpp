#include "core/math/drag_maths.h"

#include "core/math/reproducible.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ramure {

std::optional<double> alongAxis(const Ray& ray, const glm::dvec3& origin, const glm::dvec3& direction)
{
    const glm::dvec3 way = glm::normalize(ray.direction);
    const glm::dvec3 across = glm::cross(direction, way);
    const double sineSquare = glm::dot(across, across);
    if (sineSquare < leastSightSine * leastSightSine)
        return std::nullopt;
    // The shortest way between two lines is perpendicular to both.
    return glm::dot(glm::cross(ray.origin - origin, way), across) / sineSquare;
}

std::optional<glm::dvec3> onPlane(const Ray& ray, const glm::dvec3& origin, const glm::dvec3& normal)
{
    const glm::dvec3 way = glm::normalize(ray.direction);
    const double slope = glm::dot(way, normal);
    if (std::abs(slope) < leastSightSine)
        return std::nullopt;
    const double t = glm::dot(origin - ray.origin, normal) / slope;
    if (t < 0.0)
        return std::nullopt;
    return ray.origin + t * way;
}

std::optional<double> aroundRing(const Ray& ray, const glm::dvec3& centre, const glm::dvec3& axis,
                                 const glm::dvec3& zero)
{
    const auto met = onPlane(ray, centre, axis);
    if (!met)
        return std::nullopt;
    const glm::dvec3 away = *met - centre;
    return maths::atan2(glm::dot(away, glm::cross(axis, zero)), glm::dot(away, zero));
}

double snapped(double value, double step)
{
    if (!(step > 0.0))
        return value;
    const double count = std::nearbyint(value / step);
    const double inverse = std::nearbyint(1.0 / step);
    // Steps like 0.1 are parts of a whole: dividing by a whole number rounds once, multiplying twice.
    if (inverse > 0.0 && std::abs(inverse * step - 1.0) < 1e-12)
        return count / inverse;
    return count * step;
}

glm::dvec3 anyPerpendicular(const glm::dvec3& direction)
{
    const glm::dvec3 size = glm::abs(direction);
    const glm::dvec3 least = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                             : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                  : glm::dvec3(0.0, 0.0, 1.0);
    return glm::normalize(glm::cross(direction, least));
}

glm::dmat3 squareFrame(const glm::dmat3& axes)
{
    constexpr double least = 1e-12;
    const auto unit = [](const glm::dvec3& v) { return v / glm::length(v); };
    const glm::dvec3 x =
        glm::length(axes[0]) > least ? unit(axes[0])
        : glm::length(axes[1]) > least
            ? anyPerpendicular(axes[1])
            : (glm::length(axes[2]) > least ? anyPerpendicular(axes[2]) : glm::dvec3(1, 0, 0));
    glm::dvec3 y = axes[1] - glm::dot(axes[1], x) * x;
    if (glm::length(y) <= least * std::max(1.0, glm::length(axes[1])))
        y = glm::length(axes[2]) > least ? glm::cross(axes[2], x) : anyPerpendicular(x);
    y = glm::length(y) > least ? unit(y) : anyPerpendicular(x);
    const glm::dvec3 z = glm::cross(x, y);
    return {x, y, glm::dot(z, axes[2]) < 0.0 ? -z : z};
}

glm::dmat3 nearestRotation(const glm::dmat3& matrix)
{
    glm::dmat3 now = matrix;
    constexpr int mostRounds = 60; // it converges quadratically: about ten for scales a thousandfold apart
    for (int round = 0; round < mostRounds; ++round) {
        const glm::dmat3 other = glm::inverse(glm::transpose(now));
        // Scaled so that both parts weigh alike: the way from far away is short then.
        const double size = maths::pow(std::abs(glm::determinant(now)), -1.0 / 3.0);
        const glm::dmat3 next = 0.5 * (size * now + (1.0 / size) * other);
        double change = 0.0;
        for (int i = 0; i < 3; ++i)
            change = std::max(change, glm::length(next[i] - now[i]));
        now = next;
        if (change < 1e-15)
            break;
    }
    return now;
}

glm::dmat3 turnAbout(const glm::dvec3& axis, double angleRad)
{
    // Quarter turns are exact: whoever types 90 gets no 6e-17.
    const double quarters = angleRad / (0.5 * 3.14159265358979323846);
    const double whole = std::nearbyint(quarters);
    auto [s, c] = maths::sincos(angleRad);
    if (std::abs(quarters - whole) < 1e-14 * std::max(1.0, std::abs(whole))) {
        const auto place = static_cast<int>(std::fmod(whole, 4.0) + 4.0) % 4;
        c = place == 0 ? 1.0 : place == 2 ? -1.0 : 0.0;
        s = place == 1 ? 1.0 : place == 3 ? -1.0 : 0.0;
    }
    const glm::dmat3 cross{glm::dvec3(0.0, axis.z, -axis.y), glm::dvec3(-axis.z, 0.0, axis.x),
                           glm::dvec3(axis.y, -axis.x, 0.0)};
    return c * glm::dmat3(1.0) + s * cross + (1.0 - c) * glm::outerProduct(axis, axis);
}

} // namespace ramure
