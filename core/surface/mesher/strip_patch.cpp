#include "core/surface/mesher/strip_patch.h"

#include "core/math/angle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure {

namespace {

/// A vertex is inserted, and an edge flipped, only where all triangles keep this share of the tube's radius
/// squared.
constexpr double leastAreaShare = 1e-3;
constexpr double widestChord = 0.2; ///< of the circumference, between two vertices of the lower row
constexpr double upsideDown = 1e6;  ///< the cost of a triangle that should not be
constexpr double pitOpening =
    0.2; ///< a pit is filled where the angle at its bottom is not much more than right

/// The corner after a triangle's corner, and the one before it.
constexpr std::array<std::size_t, 3> following{1, 2, 0}, preceding{2, 0, 1};

/// Which of a triangle's corners a vertex is; without branches, nobody can guess them.
std::size_t cornerOf(const std::array<Index, 3>& corner, Index vertex)
{
    return (corner[1] == vertex ? 1U : 0U) + (corner[2] == vertex ? 2U : 0U);
}

/// The third corner of a triangle with the corners a and b.
Index thirdCorner(const std::array<Index, 3>& corner, Index a, Index b)
{
    return corner[0] ^ corner[1] ^ corner[2] ^ a ^ b;
}

double cross(double ax, double ay, double bx, double by)
{
    return ax * by - ay * bx;
}

} // namespace

void StripPatch::arrange(const std::vector<UnrolledVertex>& lower, const std::vector<UnrolledVertex>& upper,
                         const TubeScale& tube)
{
    const double radius = tube.radius;
    m_lowerCount = lower.size();
    m_upperCount = upper.size();
    m_radius = radius;
    m_circumference = fullTurn * radius;
    m_stretch = tube.stretch;
    m_least = leastAreaShare * radius * radius * m_stretch;
    std::size_t start = 0;
    for (std::size_t i = 1; i < m_lowerCount; ++i)
        if (lower[i].along > lower[start].along)
            start = i;
    const double zero = m_zero = lower[start].azimuth;
    m_lowerRow.clear();
    for (std::size_t i = 0; i <= m_lowerCount; ++i) {
        const bool again = start + i >= m_lowerCount;
        const UnrolledVertex& from = lower[again ? start + i - m_lowerCount : start + i];
        const double once = again ? fullTurn : 0.0;
        m_lowerRow.push_back(
            {(from.azimuth + once - zero) * radius, m_stretch * from.along, from.vertex, from.shared});
    }
    const auto offset = [&](const UnrolledVertex& v) {
        const double d = v.azimuth - zero;
        return d - fullTurn * std::round(d / fullTurn);
    };
    std::size_t first = 0;
    double nearest = offset(upper[0]);
    for (std::size_t j = 1; j < m_upperCount; ++j)
        if (const double away = offset(upper[j]); std::abs(away) < std::abs(nearest)) {
            first = j;
            nearest = away;
        }
    const double shift = nearest - upper[first].azimuth;
    m_upperRow.clear();
    for (std::size_t j = 0; j <= m_upperCount; ++j) {
        const bool again = first + j >= m_upperCount;
        const UnrolledVertex& from = upper[again ? first + j - m_upperCount : first + j];
        const double once = again ? fullTurn : 0.0;
        m_upperRow.push_back({(from.azimuth + once + shift) * radius, m_stretch * from.along, from.vertex});
    }
}

/// Both rows could advance: which one should? A triangle upside down is never made where it can be avoided,
/// nor one that leaves the next upside down; then the row that is behind; then the shorter diagonal.
bool StripPatch::preferLower(std::size_t i, std::size_t j) const
{
    const Local &a = lowerAt(i), &b = lowerAt(i + 1), &u = upperAt(j), &v = upperAt(j + 1);
    if (cross(b.x - a.x, b.y - a.y, u.x - a.x, u.y - a.y) <= 0.0)
        return false;
    if (cross(b.x - a.x, b.y - a.y, v.x - a.x, v.y - a.y) <= 0.0)
        return true;
    const double lag = b.x - v.x;
    const auto most = static_cast<double>(std::max({std::size_t(8), lowerLeft(), m_upperCount}));
    if (std::abs(lag) > 0.5 * m_circumference / most)
        return lag < 0.0;
    const double ifLower = (b.x - u.x) * (b.x - u.x) + (b.y - u.y) * (b.y - u.y);
    const double ifUpper = (v.x - a.x) * (v.x - a.x) + (v.y - a.y) * (v.y - a.y);
    return ifLower < ifUpper;
}

/// Row by row, greedily. Returns what that costs in all, and whether it is crooked: whether it makes a
/// triangle upside down, or a very wide one.
double StripPatch::chooseStepsQuickly()
{
    m_steps.clear();
    std::size_t i = 0, j = 0;
    double cost = 0.0;
    while (i < lowerLeft() || j < m_upperCount) {
        const bool lower = i < lowerLeft() && (j >= m_upperCount || preferLower(i, j));
        const double step = stepCost(i, j, lower);
        m_crooked = m_crooked || step >= upsideDown;
        cost += step;
        m_steps.push_back(lower ? 1 : 0);
        ++(lower ? i : j);
    }
    return cost;
}

/// What the next triangle costs if the lower (or the upper) row advances: its new edge squared; far more
/// where it is upside down or reaches around the tube.
double StripPatch::stepCost(std::size_t i, std::size_t j, bool lower) const
{
    const Local &a = lowerAt(i), &u = upperAt(j), &next = lower ? lowerAt(i + 1) : upperAt(j + 1);
    const double area = cross(next.x - a.x, next.y - a.y, u.x - a.x, u.y - a.y);
    const Local& other = lower ? u : a;
    const double dx = next.x - other.x, dy = next.y - other.y;
    const double cost = (dx * dx + dy * dy) / (m_circumference * m_circumference);
    const bool bad = area <= m_least * 0.01 || std::abs(dx) > 0.45 * m_circumference;
    return bad ? upsideDown * (1.0 + cost) : cost;
}

/// The steps of least cost in all. \param most what some steps cost: nothing dearer is followed up.
void StripPatch::chooseStepsByCost(double most)
{
    const std::size_t rows = lowerLeft() + 1, columns = m_upperCount + 1;
    m_costs.assign(rows * columns, std::numeric_limits<double>::infinity());
    m_cameByLower.assign(rows * columns, 0);
    m_costs[0] = 0.0;
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            const double here = m_costs[i * columns + j];
            if (here > most)
                continue;
            if (i + 1 < rows) // every place is reached from the row below first
                if (const double cost = here + stepCost(i, j, true); cost < m_costs[(i + 1) * columns + j]) {
                    m_costs[(i + 1) * columns + j] = cost;
                    m_cameByLower[(i + 1) * columns + j] = 1;
                }
            if (j + 1 < columns)
                if (const double cost = here + stepCost(i, j, false); cost < m_costs[i * columns + j + 1]) {
                    m_costs[i * columns + j + 1] = cost;
                    m_cameByLower[i * columns + j + 1] = 0;
                }
        }
    m_steps.resize(rows + columns - 2);
    std::size_t i = rows - 1, j = columns - 1;
    for (std::size_t s = m_steps.size(); s-- > 0;) {
        m_steps[s] = m_cameByLower[i * columns + j];
        --(m_steps[s] ? i : j);
    }
}

/// Edges between the rows would exist twice exactly if one row advanced all around in one go.
void StripPatch::breakSingleRun()
{
    int changes = m_steps.back() != m_steps.front() ? 1 : 0;
    for (std::size_t s = 0; s + 1 < m_steps.size(); ++s)
        changes += m_steps[s] != m_steps[s + 1] ? 1 : 0;
    if (changes > 2)
        return;
    std::fill(m_steps.begin(), m_steps.end(), std::uint8_t(0));
    m_steps[0] = 1;
    std::fill(m_steps.begin() + 2, m_steps.begin() + 1 + static_cast<std::ptrdiff_t>(lowerLeft()),
              std::uint8_t(1));
}

/// Narrow pits of the lower row are filled from below: what is left of the row, m_lowerRow, sees the upper
/// one.
void StripPatch::fillPits()
{
    m_active.clear();
    for (Index i = 0; i <= m_lowerCount; ++i)
        m_active.push_back({i, noIndex});
    const auto at = [&](std::size_t k) -> const Local& { return m_lowerRow[m_active[k].corner]; };
    const auto local = [&](std::size_t k) { return m_active[k].corner % static_cast<Index>(m_lowerCount); };
    for (std::size_t k = 1; k + 1 < m_active.size() && m_active.size() > 5;) {
        const Local &a = at(k - 1), &b = at(k), &c = at(k + 1);
        const double ax = a.x - b.x, ay = a.y - b.y, cx = c.x - b.x, cy = c.y - b.y;
        const double area = cross(cx, cy, ax, ay), dot = ax * cx + ay * cy;
        if (area <= m_least || dot < -pitOpening * area || c.x - a.x > widestChord * m_circumference ||
            !mayJoin(local(k - 1), local(k + 1))) {
            ++k;
            continue;
        }
        const auto ear = static_cast<Index>(m_triangles.size());
        m_triangles.push_back(
            {{local(k - 1), local(k), local(k + 1)}, {m_active[k - 1].below, m_active[k].below, noIndex}});
        for (const std::size_t edge : {std::size_t(0), std::size_t(1)})
            if (const Index below = m_triangles[ear].neighbour[edge]; below != noIndex)
                m_triangles[below].neighbour[2] = ear;
        m_active[k - 1].below = ear;
        m_active.erase(m_active.begin() + static_cast<std::ptrdiff_t>(k));
        k = std::max<std::size_t>(1, k - 1);
    }
    if (m_active.size() == m_lowerRow.size())
        return;
    for (std::size_t k = 0; k < m_active.size(); ++k)
        m_lowerRow[k] = m_lowerRow[m_active[k].corner];
    m_lowerRow.resize(m_active.size());
}

void StripPatch::buildTriangles()
{
    const auto lowerCount = static_cast<Index>(m_lowerRow.size() - 1),
               upperCount = static_cast<Index>(m_upperCount), upperFirst = static_cast<Index>(m_lowerCount);
    const auto first = static_cast<Index>(m_triangles.size());
    const auto count = static_cast<Index>(m_steps.size());
    m_triangles.resize(first + count);
    m_refinable = true;
    Index i = 0, j = 0;
    const auto wrapped = [](Index k, Index around) -> Index { return k < around ? k : k - around; };
    const auto lower = [&](Index k) { return m_active[wrapped(k, lowerCount)].corner; };
    for (Index s = 0; s < count; ++s) {
        const Index t = first + s;
        const Index after = first + (s + 1 < count ? s + 1 : 0), before = first + (s > 0 ? s - 1 : count - 1);
        const Index u = upperFirst + wrapped(j, upperCount);
        if (m_steps[s]) {
            const Index below = m_active[wrapped(i, lowerCount)].below;
            m_triangles[t] = {{lower(i), lower(i + 1), u}, {below, after, before}};
            if (below != noIndex)
                m_triangles[below].neighbour[2] = t;
            ++i;
        } else {
            m_triangles[t] = {{lower(i), upperFirst + wrapped(j + 1, upperCount), u},
                              {after, noIndex, before}};
            ++j;
        }
        // Differences of azimuth are taken the short way: that needs edges under half a turn.
        const double across = std::abs(m_lowerRow[i].x - m_upperRow[j].x);
        m_refinable = m_refinable && across < 0.45 * m_circumference;
    }
    for (std::size_t k = 0; k < lowerCount; ++k)
        m_refinable = m_refinable && m_lowerRow[k + 1].x - m_lowerRow[k].x < 0.45 * m_circumference;
}

void StripPatch::zip(const std::vector<UnrolledVertex>& lower, const std::vector<UnrolledVertex>& upper,
                     const TubeScale& tube)
{
    arrange(lower, upper, tube);
    m_vertices.assign(m_lowerRow.begin(), m_lowerRow.end() - 1);
    m_vertices.insert(m_vertices.end(), m_upperRow.begin(), m_upperRow.end() - 1);
    m_triangles.clear();
    m_settled.clear();
    fillPits();
    m_crooked = m_lowerRow.size() <= m_lowerCount;
    const double cost = chooseStepsQuickly();
    if (cost >= upsideDown)
        chooseStepsByCost(cost);
    breakSingleRun();
    buildTriangles();
}

/// Does a triangle hold a vertex, well inside or on an edge with another triangle beyond it? Returns 3, the
/// edge's number, or -1. The corners are seen from the vertex, which tells the right side of the tube from
/// the far one only if the triangle does not reach halfway around.
int StripPatch::holds(const Triangle& triangle, Index vertex) const
{
    std::array<double, 3> x, y;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = deltaX(vertex, triangle.corner[i]);
        y[i] = m_vertices[triangle.corner[i]].y - m_vertices[vertex].y;
    }
    int place = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        if (std::abs(x[next] - x[i]) > 0.5 * m_circumference)
            return -1;
        const double area = cross(x[i], y[i], x[next], y[next]);
        if (area > m_least)
            continue;
        if (area < -m_least || place != 3)
            return -1;
        place = static_cast<int>(i);
    }
    return place;
}

/// Is the vertex beyond an edge of a triangle seen from a vertex on that edge, with room on both sides?
bool StripPatch::seesBeyond(const Triangle& triangle, std::size_t edge, Index vertex) const
{
    const Index other = triangle.neighbour[edge];
    if (other == noIndex)
        return false;
    const Index a = triangle.corner[edge], b = triangle.corner[following[edge]];
    const Index far = thirdCorner(m_triangles[other].corner, a, b);
    const double y = m_vertices[vertex].y;
    const double fx = deltaX(vertex, far), fy = m_vertices[far].y - y;
    const double ax = deltaX(vertex, a), bx = deltaX(vertex, b);
    return std::abs(fx - ax) < 0.5 * m_circumference && std::abs(fx - bx) < 0.5 * m_circumference &&
           far != triangle.corner[preceding[edge]] && cross(ax, m_vertices[a].y - y, fx, fy) > m_least &&
           cross(fx, fy, bx, m_vertices[b].y - y) > m_least;
}

void StripPatch::relink(Index triangle, Index old, Index now)
{
    if (triangle == noIndex)
        return;
    for (Index& neighbour : m_triangles[triangle].neighbour)
        if (neighbour == old) {
            neighbour = now;
            return;
        }
}

/// The triangle that holds a vertex, or one on the way there: from where the last one was inserted, over the
/// edges that it is beyond.
Index StripPatch::walkTo(Index vertex) const
{
    constexpr int mostSteps = 256;
    const double y = m_vertices[vertex].y;
    Index at = m_last;
    for (int step = 0; step < mostSteps; ++step) {
        const Triangle& t = m_triangles[at];
        Index next = noIndex;
        for (std::size_t i = 0; i < 3 && next == noIndex; ++i) {
            const Index a = t.corner[i], b = t.corner[(i + 1) % 3];
            if (cross(deltaX(vertex, a), m_vertices[a].y - y, deltaX(vertex, b), m_vertices[b].y - y) <
                -m_least)
                next = t.neighbour[i];
        }
        if (next == noIndex)
            break;
        at = next;
    }
    return at;
}

/// Which triangle to look at as number \p number when a vertex asks for its place. Few are looked at one
/// after the other; among many, the first is one near the vertex.
Index StripPatch::candidate(Index number, Index vertex)
{
    constexpr std::size_t few = 192;
    const auto count = static_cast<Index>(m_triangles.size());
    if (number == 0) {
        if (vertex == m_lowerCount + m_upperCount) // the strip's first: nothing of an earlier strip may show
            m_last = 0;
        m_first = count > few ? walkTo(vertex) : 0;
    }
    return m_first + number < count ? m_first + number : m_first + number - count;
}

bool StripPatch::insert(const UnrolledVertex& vertex)
{
    if (!m_refinable)
        return false;
    const auto local = static_cast<Index>(m_vertices.size());
    double x = (vertex.azimuth - m_zero) * m_radius;
    x -= m_circumference * std::floor(x / m_circumference);
    m_vertices.push_back({x, m_stretch * vertex.along, vertex.vertex});
    for (Index t = 0; t < m_triangles.size(); ++t) {
        const Index at = candidate(t, local);
        const int place = holds(m_triangles[at], local);
        if (place < 0)
            continue;
        const auto edge = static_cast<std::size_t>(place);
        if (edge < 3 && !seesBeyond(m_triangles[at], edge, local))
            continue;
        m_last = at;
        split(at, local);
        if (edge < 3) // the triangle over the edge it lies on is flat: it goes at once
            exchange(m_suspects[edge].triangle, local);
        legalise(local);
        return true;
    }
    m_vertices.pop_back();
    return false;
}

/// One triangle becomes three around a vertex; in each, the vertex is corner 2.
void StripPatch::split(Index triangle, Index vertex)
{
    const Triangle old = m_triangles[triangle];
    const auto second = static_cast<Index>(m_triangles.size()), third = second + 1;
    m_triangles[triangle] = {{old.corner[0], old.corner[1], vertex}, {old.neighbour[0], second, third}};
    m_triangles.push_back({{old.corner[1], old.corner[2], vertex}, {old.neighbour[1], third, triangle}});
    m_triangles.push_back({{old.corner[2], old.corner[0], vertex}, {old.neighbour[2], triangle, second}});
    relink(old.neighbour[1], triangle, second);
    relink(old.neighbour[2], triangle, third);
    m_suspects.assign({{triangle, noEdge}, {second, noEdge}, {third, noEdge}});
    unsettle(triangle);
}

/// Is there an edge between an inserted vertex and another one already? Walks around the vertex.
bool StripPatch::joined(Index vertex, Index other, Index triangle) const
{
    Index at = triangle;
    do {
        const Triangle& t = m_triangles[at];
        const std::size_t i = cornerOf(t.corner, vertex);
        if (t.corner[following[i]] == other)
            return true;
        at = t.neighbour[preceding[i]];
    } while (at != triangle);
    return false;
}

/// Replaces the edge opposite an inserted vertex by one to the vertex beyond it.
void StripPatch::exchange(Index triangle, Index vertex)
{
    Triangle& t = m_triangles[triangle];
    const std::size_t i = cornerOf(t.corner, vertex);
    const Index a = t.corner[following[i]], b = t.corner[preceding[i]];
    const Index other = t.neighbour[following[i]];
    Triangle& o = m_triangles[other];
    const std::size_t j = cornerOf(o.corner, b);
    const Index far = o.corner[preceding[j]];
    const Index beyondA = o.neighbour[following[j]], beyondB = o.neighbour[preceding[j]];
    const Index besideA = t.neighbour[i], besideB = t.neighbour[preceding[i]];
    t = {{vertex, a, far}, {besideA, beyondA, other}};
    o = {{vertex, far, b}, {triangle, beyondB, besideB}};
    relink(beyondA, other, triangle);
    relink(besideB, triangle, other);
    m_suspects.push_back({triangle, 2}); // what is new is the edge between them
    m_suspects.push_back({other, 0});
    unsettle(triangle);
    unsettle(other);
}

/// Is the vertex beyond the edge opposite an inserted one inside the circle, and may the edge be exchanged?
bool StripPatch::isIllegal(Index triangle, Index vertex) const
{
    const Triangle& t = m_triangles[triangle];
    const std::size_t edge = following[cornerOf(t.corner, vertex)];
    if (!seesBeyond(t, edge, vertex))
        return false;
    const Index a = t.corner[edge], b = t.corner[following[edge]];
    const Index far = thirdCorner(m_triangles[t.neighbour[edge]].corner, a, b);
    const double ax = deltaX(vertex, a), ay = m_vertices[a].y - m_vertices[vertex].y;
    const double bx = deltaX(vertex, b), by = m_vertices[b].y - m_vertices[vertex].y;
    const double fx = deltaX(vertex, far), fy = m_vertices[far].y - m_vertices[vertex].y;
    // The vertex is the origin: the circle through it, a and b, tested with the far one.
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, ff = fx * fx + fy * fy;
    const double inside =
        aa * cross(bx, by, fx, fy) - bb * cross(ax, ay, fx, fy) + ff * cross(ax, ay, bx, by);
    return inside < -1e-12 * ff * aa && !joined(vertex, far, triangle);
}

void StripPatch::legalise(Index vertex)
{
    while (!m_suspects.empty()) {
        const Index triangle = m_suspects.back().triangle;
        m_suspects.pop_back();
        if (isIllegal(triangle, vertex))
            exchange(triangle, vertex);
    }
}

/// Two vertices of the lower row that no other strip has in common, or vertices of different rows.
bool StripPatch::mayJoin(Index a, Index b) const
{
    const Index inner = static_cast<Index>(m_lowerCount + m_upperCount);
    if (a >= inner || b >= inner)
        return true;
    const bool lowerA = a < m_lowerCount, lowerB = b < m_lowerCount;
    if (!lowerA && !lowerB)
        return false;
    if (!lowerA || !lowerB)
        return true;
    for (const Index s : m_vertices[a].shared)
        if (s != noIndex && (s == m_vertices[b].shared[0] || s == m_vertices[b].shared[1]))
            return false;
    return true;
}

/// Is there an edge between two vertices? Walks around the first one, which is a corner of the triangle, both
/// ways as far as its fan goes.
bool StripPatch::isEdge(Index a, Index b, Index triangle) const
{
    for (const bool back : {true, false}) {
        Index at = triangle;
        do {
            const Triangle& t = m_triangles[at];
            const std::size_t i = cornerOf(t.corner, a);
            if (t.corner[0] == b || t.corner[1] == b || t.corner[2] == b)
                return true;
            at = t.neighbour[back ? preceding[i] : i];
        } while (at != noIndex && at != triangle);
        if (at == triangle)
            return false;
    }
    return false;
}

/// Exchanges an edge if that makes it Delaunay.
bool StripPatch::relaxEdge(Index triangle, std::size_t edge)
{
    const Triangle& t = m_triangles[triangle];
    const Index other = t.neighbour[edge];
    if (other == noIndex)
        return false;
    const Index a = t.corner[edge], b = t.corner[following[edge]], c = t.corner[preceding[edge]];
    const Index d = thirdCorner(m_triangles[other].corner, a, b);
    const double half = 0.5 * m_circumference;
    const double ax = deltaX(c, a), ay = m_vertices[a].y - m_vertices[c].y;
    const double bx = deltaX(c, b), by = m_vertices[b].y - m_vertices[c].y;
    const double dx = deltaX(c, d), dy = m_vertices[d].y - m_vertices[c].y;
    // Two angles across an edge that are right or less: the edge is Delaunay. That goes for many.
    if (ax * bx + ay * by >= 0.0 && (ax - dx) * (bx - dx) + (ay - dy) * (by - dy) >= 0.0)
        return false;
    if (c == d || !mayJoin(c, d))
        return false;
    const bool chord = c < m_lowerCount && d < m_lowerCount;
    if (chord && std::abs(dx) > widestChord * m_circumference)
        return false;
    if (std::abs(ax - bx) > half || std::abs(ax - dx) > half || std::abs(bx - dx) > half)
        return false;
    if (cross(ax, ay, dx, dy) <= m_least || cross(dx, dy, bx, by) <= m_least)
        return false;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, dd = dx * dx + dy * dy;
    const double inside =
        aa * cross(bx, by, dx, dy) - bb * cross(ax, ay, dx, dy) + dd * cross(ax, ay, bx, by);
    if (inside >= -1e-9 * dd * aa || isEdge(c, d, triangle))
        return false;
    exchange(triangle, c);
    return true;
}

void StripPatch::relax()
{
    if (!m_refinable)
        return;
    m_suspects.clear();
    m_settled.resize(m_triangles.size(), 0);
    for (Index t = 0; t < m_triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) { // every edge once: with the triangle of the higher number
            const Index other = m_triangles[t].neighbour[e];
            if (other < t && !(m_settled[t] && m_settled[other]) && relaxEdge(t, e))
                break;
        }
    std::size_t left = 20 * m_triangles.size();
    while (!m_suspects.empty() && left-- > 0) {
        // The last one exchanged first: whatever changed after this one has been looked at, and the edge that
        // was new in it is Delaunay.
        const Suspect suspect = m_suspects.back();
        m_suspects.pop_back();
        for (std::size_t e = 0; e < 3; ++e)
            if (e != suspect.newEdge && relaxEdge(suspect.triangle, e))
                break;
    }
    m_suspects.clear();
    m_settled.assign(m_triangles.size(), 1);
}

bool StripPatch::measureNormals(const MeshSink& sink, std::vector<glm::vec3>& normals) const
{
    bool isFolded = false;
    const std::size_t first = normals.size();
    const auto at = [&](const Triangle& t, std::size_t corner) {
        return glm::dvec3(sink.positions[m_vertices[t.corner[corner]].vertex]);
    };
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
        const glm::dvec3 a = at(m_triangles[t], 0);
        const glm::dvec3 normal = glm::cross(at(m_triangles[t], 1) - a, at(m_triangles[t], 2) - a);
        const double square = glm::dot(normal, normal);
        normals.emplace_back(square > 0.0 ? normal * (1.0 / std::sqrt(square)) : normal);
        for (const Index other : m_triangles[t].neighbour) // those without a number yet come later
            isFolded = isFolded ||
                       (other < t && glm::dot(normals[first + t], normals[first + other]) < foldedCosine);
    }
    return isFolded;
}

void StripPatch::write(MeshSink& sink) const
{
    for (const Triangle& t : m_triangles)
        sink.addTriangle(m_vertices[t.corner[0]].vertex, m_vertices[t.corner[1]].vertex,
                         m_vertices[t.corner[2]].vertex);
}

} // namespace ramure
