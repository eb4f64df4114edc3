#include "core/surface/mesher/fork_triangulation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double gridPerUnit = 65536.0;
constexpr std::int64_t gridLimit = (1 << 20) - 1;

__extension__ using Wide = __int128; // products of four coordinates of 21 bits

} // namespace

glm::dvec2 ForkTriangulation::place(Index site) const
{
    return {static_cast<double>(m_sites[site].x) / gridPerUnit,
            static_cast<double>(m_sites[site].y) / gridPerUnit};
}

/// Positive where a, b, c turn left.
std::int64_t ForkTriangulation::orient(Index a, Index b, Index c) const
{
    const Site& p = m_sites[a];
    return (m_sites[b].x - p.x) * (m_sites[c].y - p.y) - (m_sites[b].y - p.y) * (m_sites[c].x - p.x);
}

/// Is d strictly inside the circle through a, b, c (counter-clockwise)?
bool ForkTriangulation::inCircle(Index a, Index b, Index c, Index d) const
{
    const Site& p = m_sites[d];
    const std::int64_t ax = m_sites[a].x - p.x, ay = m_sites[a].y - p.y;
    const std::int64_t bx = m_sites[b].x - p.x, by = m_sites[b].y - p.y;
    const std::int64_t cx = m_sites[c].x - p.x, cy = m_sites[c].y - p.y;
    const Wide aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    return aa * (bx * cy - by * cx) - bb * (ax * cy - ay * cx) + cc * (ax * by - ay * bx) > 0;
}

void ForkTriangulation::snap(std::span<const glm::dvec2> points)
{
    m_sites.clear();
    m_order.clear();
    for (const glm::dvec2& point : points) {
        const auto grid = [](double v) {
            return std::clamp(static_cast<std::int64_t>(std::llround(v * gridPerUnit)), -gridLimit,
                              gridLimit);
        };
        m_order.push_back(static_cast<Index>(m_sites.size()));
        m_sites.push_back({grid(point.x), grid(point.y)});
    }
    const auto before = [this](Index a, Index b) {
        const Site &p = m_sites[a], &q = m_sites[b];
        return p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : a < b);
    };
    std::sort(m_order.begin(), m_order.end(), before);
    // Equal sites climb: each takes the next free place above the one before it.
    for (std::size_t i = 1; i < m_order.size(); ++i) {
        const Site& low = m_sites[m_order[i - 1]];
        Site& high = m_sites[m_order[i]];
        if (high.x == low.x && high.y <= low.y)
            high.y = low.y + 1;
    }
}

void ForkTriangulation::addTriangle(Index a, Index b, Index c)
{
    m_triangles.push_back({{a, b, c}, {noIndex, noIndex, noIndex}});
}

/// The first sites lie on one line; the apex is the first that does not: it sees the whole line.
void ForkTriangulation::startFan(Index apex, std::size_t chain)
{
    const bool left = orient(m_order[0], m_order[1], apex) > 0;
    const auto link = [this](Index from, Index to) {
        m_next[from] = to;
        m_previous[to] = from;
    };
    for (std::size_t i = 0; i + 1 < chain; ++i) {
        const Index a = m_order[i], b = m_order[i + 1];
        if (left) {
            addTriangle(a, b, apex);
            link(a, b);
        } else {
            addTriangle(b, a, apex);
            link(b, a);
        }
    }
    const Index first = left ? m_order[0] : m_order[chain - 1];
    const Index last = left ? m_order[chain - 1] : m_order[0];
    link(last, apex);
    link(apex, first);
}

/// Joins a site to all edges of the hull it sees. It is the right-most so far, so it sees the last one's.
void ForkTriangulation::addPoint(Index point, Index last)
{
    Index front = last;
    while (orient(front, m_next[front], point) < 0) {
        addTriangle(front, point, m_next[front]);
        front = m_next[front];
    }
    Index back = last;
    while (orient(m_previous[back], back, point) < 0) {
        addTriangle(m_previous[back], point, back);
        back = m_previous[back];
    }
    m_next[back] = point;
    m_previous[point] = back;
    m_next[point] = front;
    m_previous[front] = point;
}

void ForkTriangulation::sweep()
{
    const std::size_t count = m_order.size();
    m_next.assign(count, noIndex);
    m_previous.assign(count, noIndex);
    std::size_t chain = 2;
    while (chain < count && orient(m_order[0], m_order[1], m_order[chain]) == 0)
        ++chain;
    if (chain == count)
        return;
    startFan(m_order[chain], chain);
    for (std::size_t i = chain + 1; i < count; ++i)
        addPoint(m_order[i], m_order[i - 1]);
}

/// Finds every triangle's neighbours by sorting all directed edges.
void ForkTriangulation::linkNeighbours()
{
    std::vector<SortedEdge>& edges = m_edges;
    edges.clear();
    for (Index t = 0; t < m_triangles.size(); ++t)
        for (int e = 0; e < 3; ++e) {
            const auto at = static_cast<std::size_t>(e);
            const Index a = m_triangles[t].site[at], b = m_triangles[t].site[(at + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), t, e});
        }
    std::sort(edges.begin(), edges.end(), [](const SortedEdge& a, const SortedEdge& b) {
        return a.low != b.low ? a.low < b.low
                              : (a.high != b.high ? a.high < b.high : a.triangle < b.triangle);
    });
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        if (edges[i].low == edges[i + 1].low && edges[i].high == edges[i + 1].high) {
            m_triangles[edges[i].triangle].neighbour[static_cast<std::size_t>(edges[i].edge)] =
                edges[i + 1].triangle;
            m_triangles[edges[i + 1].triangle].neighbour[static_cast<std::size_t>(edges[i + 1].edge)] =
                edges[i].triangle;
        }
}

void ForkTriangulation::replaceNeighbour(Index triangle, Index old, Index now)
{
    if (triangle == noIndex)
        return;
    for (Index& neighbour : m_triangles[triangle].neighbour)
        if (neighbour == old) {
            neighbour = now;
            return;
        }
}

/// Lawson's step. A site strictly inside the circle beyond an edge makes a strictly convex quadrilateral, so
/// both new triangles turn left.
bool ForkTriangulation::flipIfIllegal(Index triangle, int edge)
{
    Triangle& t = m_triangles[triangle];
    const auto i = static_cast<std::size_t>(edge);
    const Index other = t.neighbour[i];
    if (other == noIndex)
        return false;
    Triangle& o = m_triangles[other];
    const Index a = t.site[i], b = t.site[(i + 1) % 3], c = t.site[(i + 2) % 3];
    std::size_t j = 0;
    while (o.site[j] != b)
        ++j;
    const Index d = o.site[(j + 2) % 3];
    if (!inCircle(a, b, c, d))
        return false;
    const Index beyondBC = t.neighbour[(i + 1) % 3], beyondCA = t.neighbour[(i + 2) % 3];
    const Index beyondAD = o.neighbour[(j + 1) % 3], beyondDB = o.neighbour[(j + 2) % 3];
    t = {{c, a, d}, {beyondCA, beyondAD, other}};
    o = {{d, b, c}, {beyondDB, beyondBC, triangle}};
    replaceNeighbour(beyondAD, other, triangle);
    replaceNeighbour(beyondBC, triangle, other);
    m_stack.push_back({triangle, 0});
    m_stack.push_back({triangle, 1});
    m_stack.push_back({other, 0});
    m_stack.push_back({other, 1});
    return true;
}

void ForkTriangulation::legalise()
{
    m_stack.clear();
    for (Index t = 0; t < m_triangles.size(); ++t)
        for (int e = 0; e < 3; ++e)
            m_stack.push_back({t, e});
    while (!m_stack.empty()) {
        const EdgeOfTriangle at = m_stack.back();
        m_stack.pop_back();
        flipIfIllegal(at.triangle, at.edge);
    }
}

void ForkTriangulation::collectHull()
{
    m_hull.clear();
    if (m_triangles.empty()) {
        for (std::size_t i = 0; i + 1 < m_order.size(); ++i)
            m_hull.push_back({m_order[i], m_order[i + 1], noIndex});
        for (std::size_t i = m_order.size(); i-- > 1;)
            m_hull.push_back({m_order[i], m_order[i - 1], noIndex});
        for (std::size_t e = 0; e < m_hull.size(); ++e)
            m_hull[e].partner = static_cast<Index>(m_hull.size() - 1 - e);
        return;
    }
    m_outside.assign(m_sites.size(), noIndex);
    for (Index t = 0; t < m_triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e)
            if (m_triangles[t].neighbour[e] == noIndex)
                m_outside[m_triangles[t].site[e]] = t;
    const Index first = m_order[0]; // the left-most is on the hull
    Index at = first;
    do {
        m_hull.push_back({at, m_next[at], m_outside[at]});
        at = m_next[at];
    } while (at != first);
}

void ForkTriangulation::build(std::span<const glm::dvec2> points)
{
    m_triangles.clear();
    snap(points);
    sweep();
    linkNeighbours();
    legalise();
    collectHull();
}

void ForkTriangulation::buildStar(std::span<const glm::dvec2> points, Index centre)
{
    m_triangles.clear();
    m_hull.clear();
    snap(points);
    std::erase(m_order, centre);
    // Which half of the turn, then which way round in it: the signs are exact.
    const auto upper = [&](Index i) { return m_sites[i].y > 0 || (m_sites[i].y == 0 && m_sites[i].x >= 0); };
    std::stable_sort(m_order.begin(), m_order.end(), [&](Index a, Index b) {
        if (upper(a) != upper(b))
            return upper(a);
        const Site &p = m_sites[a], &q = m_sites[b];
        return p.x * q.y - p.y * q.x > 0;
    });
    for (const Index site : m_order) {
        const auto there = static_cast<Index>(m_hull.size());
        m_hull.push_back({centre, site, noIndex, there + 1});
        m_hull.push_back({site, centre, noIndex, there});
    }
}

/// Sets the neighbour of a triangle across one of its edges.
void ForkTriangulation::setNeighbour(Index triangle, Index from, Index neighbour)
{
    Triangle& t = m_triangles[triangle];
    t.neighbour[t.site[0] == from ? 0 : (t.site[1] == from ? 1 : 2)] = neighbour;
}

/// Takes a triangle out of the list; the last one takes its number.
void ForkTriangulation::removeTriangle(Index triangle)
{
    const auto last = static_cast<Index>(m_triangles.size() - 1);
    if (triangle != last) {
        m_triangles[triangle] = m_triangles[last];
        for (const Index neighbour : m_triangles[triangle].neighbour)
            if (neighbour != noIndex)
                replaceNeighbour(neighbour, last, triangle);
        for (HullEdge& edge : m_hull)
            if (edge.triangle == last)
                edge.triangle = triangle;
    }
    m_triangles.pop_back();
}

void ForkTriangulation::openFlatSides(double mostCosine)
{
    if (m_triangles.empty())
        return;
    m_outside.assign(m_sites.size(), noIndex); // from here on: is the site on the hull?
    for (const HullEdge& edge : m_hull)
        m_outside[edge.from] = 0;
    for (std::size_t e = 0; e < m_hull.size();) {
        const HullEdge edge = m_hull[e];
        const Triangle triangle = m_triangles[edge.triangle];
        const std::size_t i = triangle.site[0] == edge.from ? 0 : (triangle.site[1] == edge.from ? 1 : 2);
        const Index apex = triangle.site[(i + 2) % 3];
        const glm::dvec2 a = place(edge.from) - place(apex), b = place(edge.to) - place(apex);
        if (m_outside[apex] != noIndex || glm::dot(a, b) > mostCosine * glm::length(a) * glm::length(b)) {
            ++e;
            continue;
        }
        const Index after = triangle.neighbour[(i + 1) % 3], before = triangle.neighbour[(i + 2) % 3];
        setNeighbour(before, edge.from, noIndex);
        setNeighbour(after, apex, noIndex);
        m_outside[apex] = 0;
        m_hull[e] = {edge.from, apex, before};
        m_hull.insert(m_hull.begin() + static_cast<std::ptrdiff_t>(e) + 1, {apex, edge.to, after});
        removeTriangle(edge.triangle);
    }
}

} // namespace ramure
