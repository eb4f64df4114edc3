#include "core/mesh/fork_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ramure {

namespace {

constexpr double pi = std::numbers::pi;
/// Of the shortest child: where the search for a valley looks.
constexpr std::array<double, 7> searchShares{0.08, 0.16, 0.28, 0.44, 0.62, 0.8, 0.95};
constexpr double growth = 1.3; ///< of the steps away from a guess
constexpr int mostRefinements = 5;
constexpr double closeEnough = 0.02; ///< of the radius: a wall vertex needs no more room than that
constexpr double wallMargin = 0.06;  ///< of a tube's radius: how far outside its own tubes a wall lies
constexpr double innerReach = 0.6;   ///< of the radius: how far aside the middle of an inner wall may lie

/// Where the search for a valley stands: inside the tubes below, outside above.
struct Stretch
{
    double inside, roomInside;
    double outside, roomOutside;

    /// The upper place is inside as well: a higher one takes its part.
    void rise(double higher)
    {
        inside = outside;
        roomInside = roomOutside;
        outside = higher;
    }
    void narrow(double middle, double roomThere)
    {
        (roomThere < 0.0 ? inside : outside) = middle;
        (roomThere < 0.0 ? roomInside : roomOutside) = roomThere;
    }
};

/// Weights of a triangle's circumcentre, kept positive: at obtuse angles the true one lies outside.
std::array<double, 3> circumcentreWeights(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const auto square = [](const glm::dvec2& v) { return glm::dot(v, v); };
    const double aa = square(b - c), bb = square(c - a), cc = square(a - b);
    std::array<double, 3> weight{aa * (bb + cc - aa), bb * (cc + aa - bb), cc * (aa + bb - cc)};
    const double sum = weight[0] + weight[1] + weight[2];
    if (!(sum > 0.0))
        return {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    double kept = 0.0;
    for (double& w : weight) {
        w = std::clamp(w / sum, 0.05, 0.9);
        kept += w;
    }
    for (double& w : weight)
        w /= kept;
    return weight;
}

} // namespace

/// Across the wall between two children, to the right of the way from one to the other: out of the hull.
glm::dvec3 ForkWalls::outward(Index from, Index to) const
{
    const auto& sites = m_layout->triangulation;
    const glm::dvec2 way = glm::normalize(sites.place(to) - sites.place(from));
    return m_ring->frame.normal * way.y - m_ring->frame.binormal * way.x;
}

double ForkWalls::pairRadius(Index u, Index v) const
{
    return 0.5 * (m_children[u].sections.front().radius + m_children[v].sections.front().radius);
}

glm::dvec3 ForkWalls::onPath(const Between& between, const glm::dvec3& offset, double along) const
{
    glm::dvec3 point = offset;
    for (std::size_t i = 0; i < between.count; ++i)
        point += between.weight[i] * m_children[between.child[i]].table.pointAt(along);
    return point;
}

/// How far the path's point at an arc length is outside the tubes it lies between, margin included, and, if
/// wanted, all others; negative inside.
double ForkWalls::room(const Between& between, const glm::dvec3& offset, double along, Tubes tubes) const
{
    std::array<AxisTable::Place, 3> places;
    glm::dvec3 point = offset;
    for (std::size_t i = 0; i < between.count; ++i) {
        places[i] = m_children[between.child[i]].table.at(along);
        point += between.weight[i] * places[i].point;
    }
    // The foot of a point is at most as far as the axis at the same arc length: most points are found inside
    // so.
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < between.count; ++i) {
        const glm::dvec3 away = point - places[i].point;
        least = std::min(least, std::sqrt(glm::dot(away, away)) - (1.0 + wallMargin) * places[i].radius);
    }
    if (least < 0.0)
        return least;
    for (std::size_t i = 0; i < between.count; ++i) {
        const double clear = m_children[between.child[i]].table.clearanceFrom(places[i], point, along);
        least = std::min(least, clear - wallMargin * places[i].radius);
    }
    if (tubes == Tubes::Between)
        return least;
    for (std::size_t j = 0; j < m_children.size() && least >= 0.0; ++j)
        if (j != between.child[0] && j != between.child[1] && j != between.child[2])
            least = std::min(least, m_children[j].table.clearance(point, along));
    return least;
}

/// Goes up along the mean of the children's axes until the point leaves the tubes: in growing steps, or from
/// a guess up or down, then by false position between the last place inside and the first one outside.
/// \returns the arc length, or nothing if the point never leaves.
std::optional<double> ForkWalls::exitHeight(const Between& between, const glm::dvec3& offset, double reach,
                                            double guess, Tubes tubes) const
{
    const double radius = pairRadius(between.child[0], between.child[1]), enough = closeEnough * radius;
    const double most = reach * searchShares.back();
    Stretch stretch{0.0, -radius, std::min(guess, most), -1.0};
    if (guess > 0.0) {
        stretch.roomOutside = room(between, offset, stretch.outside, tubes);
        while (stretch.roomOutside < 0.0 && stretch.outside < most) {
            stretch.rise(std::min(most, stretch.outside * growth));
            stretch.roomOutside = room(between, offset, stretch.outside, tubes);
        }
        if (stretch.inside == 0.0 && stretch.roomOutside > enough) { // the guess was too high
            const double lower = stretch.outside / growth;
            const double roomThere = room(between, offset, lower, tubes);
            stretch.narrow(lower, roomThere);
        }
    } else {
        for (const double share : searchShares) {
            stretch.outside = reach * share;
            stretch.roomOutside = room(between, offset, stretch.outside, tubes);
            if (stretch.roomOutside >= 0.0)
                break;
            stretch.rise(stretch.outside);
        }
    }
    if (stretch.roomOutside < 0.0)
        return std::nullopt;
    for (int round = 0; round < mostRefinements && stretch.roomOutside > enough; ++round) {
        const double part =
            std::clamp(stretch.roomInside / (stretch.roomInside - stretch.roomOutside), 0.1, 0.9);
        const double middle = stretch.inside + (stretch.outside - stretch.inside) * part;
        stretch.narrow(middle, room(between, offset, middle, tubes));
    }
    return stretch.outside;
}

/// Where a point's path leaves all tubes; tubes that never come apart there end their wall where the shorter
/// one ends. \param guess the height found last for a vertex of the same kind: forks are often symmetric.
CellVertex ForkWalls::lift(const Between& between, const glm::dvec3& offset, double& guess)
{
    double reach = m_children[between.child[0]].table.length();
    for (std::size_t i = 1; i < between.count; ++i)
        reach = std::min(reach, m_children[between.child[i]].table.length());
    // Seldom does a third tube cover the place where two come apart: it is asked only there.
    std::optional<double> along = exitHeight(between, offset, reach, guess, Tubes::Between);
    if (along && m_children.size() > between.count && room(between, offset, *along, Tubes::All) < 0.0)
        along = exitHeight(between, offset, reach, 0.0, Tubes::All);
    if (along)
        guess = *along;
    else
        ++m_withoutExit;
    const double height = along.value_or(reach);
    return {noIndex, onPath(between, offset, height), height};
}

/// Returns the vertex' number in m_vertices.
Index ForkWalls::add(CellVertex vertex, const Between& between)
{
    vertex.vertex = m_sink->addVertex(vertex.position, m_children[between.child[0]].source);
    ForkVertex shared{vertex.vertex, m_ring->source, {noIndex, noIndex, noIndex}, {}, float(vertex.lifted)};
    for (std::size_t i = 0; i < between.count; ++i) {
        shared.branch[i] = m_children[between.child[i]].source;
        shared.weight[i] = float(between.weight[i]);
    }
    m_sink->forkVertices.push_back(shared);
    m_vertices.push_back(vertex);
    return static_cast<Index>(m_vertices.size() - 1);
}

void ForkWalls::makeCorners()
{
    const auto& sites = m_layout->triangulation;
    double guess = 0.0;
    for (const ForkTriangulation::Triangle& triangle : sites.triangles()) {
        const auto& s = triangle.site;
        const Between between{s, circumcentreWeights(sites.place(s[0]), sites.place(s[1]), sites.place(s[2])),
                              3};
        add(lift(between, glm::dvec3(0.0), guess), between);
    }
}

/// Walls that begin on the ring. They end at their triangle's corner, or, where all children lie in one
/// plane, at the other side of the ring.
void ForkWalls::makeHullWalls()
{
    const auto& hull = m_layout->triangulation.hull();
    m_hullWall.assign(hull.size(), {});
    m_guesses.assign(2 * m_midsPerWall + 2, 0.0);
    for (std::size_t e = 0; e < hull.size(); ++e) {
        const ForkTriangulation::HullEdge& edge = hull[e];
        const std::size_t opposite = hull.size() - 1 - e;
        const bool across = edge.triangle == noIndex;
        if (across && e > opposite) {
            m_hullWall[e] = m_hullWall[opposite];
            continue;
        }
        const std::size_t count = across ? 2 * m_midsPerWall + 1 : m_midsPerWall;
        const glm::dvec3 aside = outward(edge.from, edge.to);
        const Between between = pair(edge.from, edge.to);
        const double reach = pairRadius(edge.from, edge.to);
        m_hullWall[e].first = static_cast<Index>(m_vertices.size());
        for (std::size_t i = 1; i <= count; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(count + 1);
            const double out = reach * std::cos(part * (across ? pi : 0.5 * pi));
            double& guess = m_guesses[across ? std::min(i, count + 1 - i) : i];
            add(lift(between, aside * out, guess), between);
        }
        m_hullWall[e].count = static_cast<Index>(m_vertices.size()) - m_hullWall[e].first;
    }
}

/// Walls from corner to corner.
void ForkWalls::makeInnerWalls()
{
    const auto& triangles = m_layout->triangulation.triangles();
    m_innerWall.assign(triangles.size(), {noIndex, noIndex, noIndex});
    double guess = 0.0;
    for (Index t = 0; t < triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const Index other = triangles[t].neighbour[e];
            if (other == noIndex || other < t)
                continue;
            const Index u = triangles[t].site[e], v = triangles[t].site[(e + 1) % 3];
            const glm::dvec3 aside = outward(u, v);
            double offset = 0.0;
            for (const Index corner : {t, other}) {
                const CellVertex& at = m_vertices[corner];
                offset += 0.5 * glm::dot(at.position - onPath(pair(u, v), glm::dvec3(0.0), at.lifted), aside);
            }
            const double most = innerReach * pairRadius(u, v);
            const Between between = pair(u, v);
            const Index mid = add(lift(between, aside * std::clamp(offset, -most, most), guess), between);
            m_innerWall[t][e] = mid;
            const auto& back = triangles[other].site;
            for (std::size_t i = 0; i < 3; ++i)
                if (back[i] == v && back[(i + 1) % 3] == u)
                    m_innerWall[other][i] = mid;
        }
}

void ForkWalls::build(const ForkLayout& layout, const ForkRing& ring, std::span<const ForkChild> children,
                      int radialDivisions, MeshSink& sink)
{
    m_layout = &layout;
    m_ring = &ring;
    m_children = children;
    m_sink = &sink;
    m_midsPerWall = static_cast<std::size_t>(std::clamp((radialDivisions + 1) / 4, 1, 12));
    m_withoutExit = 0;
    m_vertices.clear();
    makeCorners();
    makeHullWalls();
    makeInnerWalls();

    m_hullFrom.assign(children.size(), noIndex);
    m_hullTo.assign(children.size(), noIndex);
    m_triangleOf.assign(children.size(), noIndex);
    const auto& hull = layout.triangulation.hull();
    for (Index e = 0; e < hull.size(); ++e) {
        m_hullFrom[hull[e].from] = e;
        m_hullTo[hull[e].to] = e;
    }
    const auto& triangles = layout.triangulation.triangles();
    for (Index t = 0; t < triangles.size(); ++t)
        for (const Index site : triangles[t].site)
            m_triangleOf[site] = t;
}

void ForkWalls::appendRing(Index point, std::vector<CellVertex>& boundary) const
{
    boundary.push_back(
        {m_ring->firstVertex + point, m_ring->points[point], 0.0, m_layout->ring[point].azimuth, true});
}

/// The ring from the split point of a hull edge to that of the next.
void ForkWalls::appendArc(std::size_t edge, std::vector<CellVertex>& boundary) const
{
    const auto& split = m_layout->splitPoint;
    const auto count = static_cast<Index>(m_ring->points.size());
    const Index last = edge + 1 < split.size() ? split[edge + 1] : count;
    for (Index point = split[edge]; point <= last; ++point)
        appendRing(point % count, boundary);
}

/// The mids of a hull edge's wall, from the ring (\p inwards) or towards it.
void ForkWalls::appendWall(std::size_t edge, bool inwards, std::vector<CellVertex>& boundary) const
{
    const Wall& wall = m_hullWall[edge];
    for (Index i = 0; i < wall.count; ++i)
        boundary.push_back(m_vertices[wall.first + (inwards ? i : wall.count - 1 - i)]);
}

/// Walls and corners around a child, from the hull edge that leaves it to one that reaches it, which is
/// returned.
std::size_t ForkWalls::appendAround(Index child, std::size_t edge, std::vector<CellVertex>& boundary) const
{
    const auto& hull = m_layout->triangulation.hull();
    const auto& triangles = m_layout->triangulation.triangles();
    if (hull[edge].triangle == noIndex) {
        const std::size_t opposite = hull.size() - 1 - edge;
        appendWall(edge, edge < opposite, boundary);
        return opposite;
    }
    appendWall(edge, true, boundary);
    Index at = hull[edge].triangle;
    while (true) {
        const ForkTriangulation::Triangle& triangle = triangles[at];
        boundary.push_back(m_vertices[at]);
        std::size_t i = 0;
        while (triangle.site[i] != child)
            ++i;
        const std::size_t back = (i + 2) % 3; // the edge that comes back to the child
        if (triangle.neighbour[back] == noIndex) {
            const std::size_t reached = m_hullFrom[triangle.site[back]];
            appendWall(reached, false, boundary);
            return reached;
        }
        boundary.push_back(m_vertices[m_innerWall[at][back]]);
        at = triangle.neighbour[back];
    }
}

void ForkWalls::cell(Index child, std::vector<CellVertex>& boundary) const
{
    boundary.clear();
    const std::size_t edges = m_layout->triangulation.hull().size();
    if (m_hullTo[child] != noIndex) {
        const std::size_t start = m_hullTo[child];
        std::size_t edge = start;
        do {
            appendArc(edge, boundary);
            edge = appendAround(child, (edge + 1) % edges, boundary);
        } while (edge != start);
        return;
    }
    const auto& triangles = m_layout->triangulation.triangles();
    const Index start = m_triangleOf[child];
    Index at = start;
    do {
        std::size_t i = 0;
        while (triangles[at].site[i] != child)
            ++i;
        const std::size_t back = (i + 2) % 3;
        boundary.push_back(m_vertices[at]);
        boundary.push_back(m_vertices[m_innerWall[at][back]]);
        at = triangles[at].neighbour[back];
    } while (at != start);
}

} // namespace ramure
