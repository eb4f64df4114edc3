#include "core/surface/mesh/polygon_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace ramure {
namespace {

/// A corner counts as straight where its sides turn by less.
constexpr double leastCornerTurn = 1e-6;
/// Looks at corners, of one polygon.
constexpr std::size_t mostCornerLooks = 200'000'000;

/// Twice the area of the triangle, positive where it turns left.
double twiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool turnsLeft(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const double area = twiceArea(a, b, c);
    const glm::dvec2 ab = b - a, ac = c - a;
    return area > 0.0 &&
           area * area > leastCornerTurn * leastCornerTurn * glm::dot(ab, ab) * glm::dot(ac, ac);
}

/// Which two axes make the plane, in the order in which the polygon turns left; {0, 0}: it has no area.
struct FacingPlane
{
    glm::length_t x = 0, y = 0;

    explicit FacingPlane(std::span<const glm::vec3> corners)
    {
        glm::dvec3 normal(0.0); // the method of Newell
        const glm::dvec3 first(corners[0]);
        for (std::size_t i = 2; i < corners.size(); ++i)
            normal += glm::cross(glm::dvec3(corners[i - 1]) - first, glm::dvec3(corners[i]) - first);
        glm::length_t most = 0;
        for (glm::length_t axis = 1; axis < 3; ++axis)
            if (std::abs(normal[axis]) > std::abs(normal[most]))
                most = axis;
        if (!(std::abs(normal[most]) > 0.0))
            return;
        x = (most + 1) % 3;
        y = (most + 2) % 3;
        if (normal[most] < 0.0)
            std::swap(x, y);
    }
    [[nodiscard]] glm::dvec2 operator()(const glm::vec3& p) const { return {p[x], p[y]}; }
};

/// Points by the cells of a square grid, about one in each.
class PointGrid
{
public:
    PointGrid() = default;
    PointGrid(std::span<const glm::dvec2> points, std::span<const Index> numbers)
        : m_side(static_cast<std::size_t>(std::sqrt(double(numbers.size()))) + 1)
        , m_begin(m_side * m_side + 1, 0)
        , m_numbers(numbers.size())
    {
        glm::dvec2 high = m_low = points[numbers[0]];
        for (const Index i : numbers) {
            m_low = glm::min(m_low, points[i]);
            high = glm::max(high, points[i]);
        }
        for (glm::length_t axis = 0; axis < 2; ++axis)
            m_scale[axis] = high[axis] > m_low[axis] ? double(m_side) / (high[axis] - m_low[axis]) : 0.0;
        for (const Index i : numbers)
            ++m_begin[cell(points[i].x, 0) + m_side * cell(points[i].y, 1) + 1];
        std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
        std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
        for (const Index i : numbers)
            m_numbers[next[cell(points[i].x, 0) + m_side * cell(points[i].y, 1)]++] = i;
    }
    /// Calls \p isInTheWay for the points of all cells that the box meets, until one is.
    template <class Test> bool any(const glm::dvec2& low, const glm::dvec2& high, Test&& isInTheWay) const
    {
        const std::size_t left = cell(low.x, 0), right = cell(high.x, 0), last = cell(high.y, 1);
        for (std::size_t y = cell(low.y, 1); y <= last; ++y)
            for (std::size_t at = m_begin[y * m_side + left]; at < m_begin[y * m_side + right + 1]; ++at)
                if (isInTheWay(m_numbers[at]))
                    return true;
        return false;
    }

private:
    [[nodiscard]] std::size_t cell(double place, glm::length_t axis) const
    {
        const double number = (place - m_low[axis]) * m_scale[axis];
        return std::min(static_cast<std::size_t>(std::max(number, 0.0)), m_side - 1);
    }

    std::size_t m_side = 0;
    glm::dvec2 m_low{0.0}, m_scale{0.0};
    std::vector<std::size_t> m_begin; ///< per cell, row by row: where its numbers begin
    std::vector<Index> m_numbers;
};

class EarClipper
{
public:
    EarClipper(std::vector<glm::dvec2> points, std::vector<glm::uvec3>& triangles)
        : m_points(std::move(points))
        , m_out(triangles)
        , m_left(static_cast<Index>(m_points.size()))
        , m_isReflex(m_points.size())
        , m_isGone(m_points.size(), false)
    {
        for (Index i = 0; i < m_left; ++i) {
            m_previous.push_back((i + m_left - 1) % m_left);
            m_next.push_back((i + 1) % m_left);
        }
        for (Index i = 0; i < m_left; ++i)
            look(i);
        fillGrid();
    }

    bool run()
    {
        Index at = 0, sinceEar = 0;
        bool isStrict = true;
        while (m_left > 3 && m_looks < mostCornerLooks) {
            if (isEar(at, isStrict)) {
                clip(at);
                sinceEar = 0;
                isStrict = true;
                at = m_next[m_next[at]]; // every other corner: triangles do not become a fan of slivers
                continue;
            }
            at = m_next[at];
            if (++sinceEar < m_left)
                continue;
            if (!isStrict)
                break;
            isStrict = false;
            sinceEar = 0;
        }
        const Index next = m_next[at], last = m_next[next];
        const bool isWhole = m_left == 3 && !turnsLeft(m_points[last], m_points[next], m_points[at]);
        while (m_left >= 3)
            clip(m_next[at]);
        return isWhole;
    }

private:
    void look(Index i)
    {
        m_isReflex[i] = !turnsLeft(m_points[m_previous[i]], m_points[i], m_points[m_next[i]]);
    }
    /// \param isStrict: with an area
    bool isEar(Index b, bool isStrict)
    {
        const Index a = m_previous[b], c = m_next[b];
        const glm::dvec2 &pa = m_points[a], &pb = m_points[b], &pc = m_points[c];
        ++m_looks;
        if (isStrict ? m_isReflex[b] : turnsLeft(pc, pb, pa))
            return false;
        return !m_grid.any(glm::min(glm::min(pa, pb), pc), glm::max(glm::max(pa, pb), pc), [&](Index i) {
            const glm::dvec2& p = m_points[i];
            ++m_looks;
            return m_isReflex[i] && !m_isGone[i] && p != pa && p != pb && p != pc &&
                   twiceArea(pa, pb, p) >= 0.0 && twiceArea(pb, pc, p) >= 0.0 && twiceArea(pc, pa, p) >= 0.0;
        });
    }
    /// Of the corners that are left. A convex corner never becomes reflex.
    void fillGrid()
    {
        std::vector<Index> reflex;
        for (Index i = 0; i < m_points.size(); ++i)
            if (m_isReflex[i] && !m_isGone[i])
                reflex.push_back(i);
        m_inGrid = m_left;
        m_grid = reflex.empty() ? PointGrid(m_points, std::array<Index, 1>{0}) : PointGrid(m_points, reflex);
    }
    void clip(Index b)
    {
        const Index a = m_previous[b], c = m_next[b];
        m_out.emplace_back(a, b, c);
        m_next[a] = c;
        m_previous[c] = a;
        m_isGone[b] = true;
        --m_left;
        look(a);
        look(c);
        if (m_left < m_inGrid / 2)
            fillGrid();
    }

    std::vector<glm::dvec2> m_points;
    std::vector<glm::uvec3>& m_out;
    Index m_left; ///< corners that are not clipped yet
    std::vector<bool> m_isReflex, m_isGone;
    std::vector<Index> m_previous, m_next;
    PointGrid m_grid;   ///< those that are reflex, and some that were
    Index m_inGrid = 0; ///< corners that were left when it was filled
    std::size_t m_looks = 0;
};

} // namespace

bool isFan(std::span<const glm::vec3> corners)
{
    const FacingPlane plane(corners);
    if (plane.x == plane.y)
        return true;
    const glm::dvec2 first = plane(corners[0]);
    glm::dvec2 previous = plane(corners[1]);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec2 next = plane(corners[i]);
        if (!turnsLeft(first, previous, next))
            return false;
        previous = next;
    }
    return true;
}

bool cutPolygon(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles)
{
    const FacingPlane plane(corners);
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners)
        points.push_back(plane.x == plane.y ? glm::dvec2(0.0) : plane(corner));
    return EarClipper(std::move(points), triangles).run();
}

} // namespace ramure
