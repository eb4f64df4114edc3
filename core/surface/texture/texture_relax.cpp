#include "core/surface/texture/texture_relax.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure {

namespace {

constexpr double densityWeight = 0.1;
constexpr double awakeAbove = 1.008; ///< (s/t + t/s) / 2 of a triangle stretched by 1.13
constexpr double halfWeight = 0.07;  ///< shape above 1 at which a triangle counts half: stretched by 1.45
constexpr double leastSoftness = 0.05;
constexpr int sweepsWhenFlat = 6;
constexpr double shorter = 0.4; ///< of a step that leads up
constexpr int mostTries = 6;
constexpr double enough = 1e-3; ///< tiles: a shorter step ends the moves of a vertex

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

} // namespace

void TextureRelaxer::clear()
{
    m_uv.clear();
    m_free.clear();
    m_awake.clear();
    m_triangles.clear();
    m_least = 1.0;
    m_anyAwake = false;
}

void TextureRelaxer::addVertex(const glm::dvec2& uv, bool isFree)
{
    m_uv.push_back(uv);
    m_free.push_back(isFree ? 1 : 0);
    m_awake.push_back(0);
}

TextureRelaxer::Jacobian TextureRelaxer::jacobian(const Triangle& triangle) const
{
    Jacobian map;
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec2& at = m_uv[triangle.corner[c]];
        map.u += (at.x + triangle.shift[c]) * triangle.gradient[c];
        map.v += at.y * triangle.gradient[c];
    }
    return map;
}

void TextureRelaxer::wake(const Triangle& triangle)
{
    for (const Index corner : triangle.corner)
        m_awake[corner] = m_free[corner];
    m_anyAwake = true;
}

void TextureRelaxer::addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                                 const std::array<double, 3>& shift)
{
    FlatCorners flat;
    if (!layFlat(place, flat))
        return;
    const glm::dvec2 one(1.0 / flat.x1, -flat.x2 / (flat.x1 * flat.y2)), two(0.0, 1.0 / flat.y2);
    m_triangles.push_back({corner, shift, {-one - two, one, two}, 1.0});
    const Jacobian map = jacobian(m_triangles.back());
    const double area = cross(map.u, map.v);
    m_least = std::min(m_least, area);
    if (glm::dot(map.u, map.u) + glm::dot(map.v, map.v) > 2.0 * awakeAbove * area)
        wake(m_triangles.back());
}

template <bool derivatives>
void TextureRelaxer::add(const TrianglesAround::Use& use, const glm::dvec2& moved, Around& sum) const
{
    const Triangle& triangle = m_triangles[use.triangle];
    Jacobian map = jacobian(triangle);
    const glm::dvec2& own = triangle.gradient[use.place];
    map.u += moved.x * own;
    map.v += moved.y * own;
    double area = cross(map.u, map.v), softened = 1.0;
    if (m_softness > 0.0) {
        const double root = std::sqrt(area * area + m_softness * m_softness);
        softened = 0.5 * (1.0 + area / root);
        area = 0.5 * (area + root);
    }
    if (!(area > 0.0)) {
        sum.energy = std::numeric_limits<double>::infinity();
        return;
    }
    const double inverse = 1.0 / area;
    const double shape = 0.5 * (glm::dot(map.u, map.u) + glm::dot(map.v, map.v)) * inverse;
    const double weight = 2.0 * triangle.weight * shape;
    sum.energy += 0.5 * weight * shape + 0.5 * densityWeight * (area + inverse);
    if constexpr (derivatives) {
        const glm::dvec2 byArea = softened * glm::dvec2(cross(own, map.v), cross(map.u, own));
        const glm::dvec2 spread = glm::dvec2(glm::dot(map.u, own), glm::dot(map.v, own)) * inverse;
        const glm::dvec2 area1 = byArea * inverse;
        const glm::dvec2 slope = spread - shape * area1;
        sum.slope += weight * slope + 0.5 * densityWeight * (1.0 - inverse * inverse) * byArea;
        const double size = glm::dot(own, own) * inverse;
        const double curve = densityWeight * inverse;
        const auto second = [&](double s, double t, double slopes, double spreads, double areas) {
            return weight * (s * t * size - spreads + 2.0 * shape * areas) + 2.0 * triangle.weight * slopes +
                   curve * areas;
        };
        sum.xx += second(1.0, 1.0, slope.x * slope.x, 2.0 * spread.x * area1.x, area1.x * area1.x);
        sum.yy += second(1.0, 1.0, slope.y * slope.y, 2.0 * spread.y * area1.y, area1.y * area1.y);
        sum.xy +=
            second(1.0, 0.0, slope.x * slope.y, spread.x * area1.y + spread.y * area1.x, area1.x * area1.y);
    }
}

/// \returns whether it moved by more than next to nothing.
bool TextureRelaxer::move(Index vertex)
{
    const std::span<const TrianglesAround::Use> uses = m_around.of(vertex);
    Around here;
    for (const TrianglesAround::Use& use : uses)
        add<true>(use, glm::dvec2(0.0), here);
    const double determinant = here.xx * here.yy - here.xy * here.xy;
    if (!std::isfinite(here.energy) || !(determinant > 0.0))
        return false;
    glm::dvec2 step = -glm::dvec2(here.yy * here.slope.x - here.xy * here.slope.y,
                                  here.xx * here.slope.y - here.xy * here.slope.x) /
                      determinant;
    if (glm::dot(step, step) < enough * enough)
        return false;
    for (int tries = 0; tries < mostTries; ++tries, step *= shorter) {
        Around there;
        for (const TrianglesAround::Use& use : uses)
            add<false>(use, step, there);
        if (there.energy < here.energy) {
            m_uv[vertex] += step;
            return true;
        }
    }
    return false;
}

double TextureRelaxer::leastArea() const
{
    double least = 1.0;
    for (const Triangle& triangle : m_triangles) {
        const Jacobian map = jacobian(triangle);
        least = std::min(least, cross(map.u, map.v));
    }
    return least;
}

/// (s/t + t/s) / 2 of the map's singular values: 1 where shapes are kept.
double TextureRelaxer::shapeOf(const Jacobian& map)
{
    return 0.5 * (glm::dot(map.u, map.u) + glm::dot(map.v, map.v)) / cross(map.u, map.v);
}

/// The worse a triangle's shape the less it counts; vertices at good ones sleep.
void TextureRelaxer::weigh()
{
    std::fill(m_awake.begin(), m_awake.end(), std::uint8_t(0));
    for (Triangle& triangle : m_triangles) {
        const double shape = shapeOf(jacobian(triangle)), excess = (shape - 1.0) / halfWeight;
        triangle.weight = 1.0 / (1.0 + excess * excess);
        if (shape > awakeAbove)
            wake(triangle);
    }
}

bool TextureRelaxer::sweep()
{
    bool moved = false;
    for (Index vertex = 0; vertex < m_uv.size(); ++vertex)
        if (m_awake[vertex] != 0)
            moved = move(vertex) || moved;
    return moved;
}

bool TextureRelaxer::run(int evenSweeps, int choosySweeps)
{
    if (!m_anyAwake)
        return m_least > 0.0;
    m_around.link(std::span<const Triangle>(m_triangles), m_uv.size());
    const bool folded = m_least <= 0.0;
    if (folded)
        m_awake = m_free;
    int flat = 0; // sweeps since nothing is folded
    for (int i = 0; i < evenSweeps; ++i) {
        m_softness = m_least > 0.0 ? 0.0 : std::max(leastSoftness, -0.5 * m_least);
        if (!sweep())
            break;
        if (folded)
            m_least = leastArea();
        if (m_least > 0.0 && ++flat == sweepsWhenFlat)
            break;
    }
    m_softness = 0.0;
    for (int i = 0; i < choosySweeps && m_least > 0.0; ++i) {
        weigh();
        if (!sweep())
            break;
    }
    return m_least > 0.0;
}

} // namespace ramure
