#include "core/surface/mesher/fork_walls.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

constexpr std::size_t mostPerWall = 48; ///< vertices
constexpr double leastAngle = 0.04;     ///< rad, between vertices added where a wall is steep
constexpr double leastStepShare = 0.1;  ///< of the height between two neighbours: a vertex between them
constexpr double leastCosine = 0.97;    ///< how near to the outside, or the far side, a wall may end
/// Does a wall from side to side have a vertex in the middle, where the valley is highest? Found by trial: on
/// tubes of 5, 7 or 8 sides, plane forks fold in fewer places without it.
constexpr bool isPeaked(int sides)
{
    return sides < 5 || sides == 6 || sides > 8;
}
constexpr double lateShare = 0.6; ///< of the shortest child: a corner above makes the fork a late one
constexpr int cornerRounds = 4;
constexpr double cornerGap = 0.1; ///< of the radius, between two corners
/// A wall leans to its point of the ring up to this height, of the radius, at least, and to where it is this
/// far aside, of its reach.
constexpr double leanHeight = 0.75, leanReach = 0.7;

} // namespace

/// Across the wall between two children, to the right of the way from one to the other: out of the hull.
glm::dvec3 ForkWalls::outward(Index from, Index to) const
{
    const auto& sites = m_layout->triangulation;
    const glm::dvec2 way = glm::normalize(sites.place(to) - sites.place(from));
    return m_ring->frame.normal * way.y - m_ring->frame.binormal * way.x;
}

/// Returns the vertex' number in m_vertices.
Index ForkWalls::add(const ForkLift::Lifted& lifted, const WallPath& path)
{
    CellVertex vertex;
    vertex.position = lifted.position;
    vertex.lifted = lifted.along;
    vertex.cells = path.child;
    vertex.vertex = m_sink->addVertex(vertex.position, m_children[path.child[0]].source);
    ForkVertex shared{vertex.vertex, m_ring->source, {noIndex, noIndex, noIndex}, {}, float(vertex.lifted)};
    std::array<double, 3> weight = m_lift.weightsAt(path, lifted.along);
    double sum = 0.0;
    for (double& w : weight) {
        w = std::max(w, 0.0);
        sum += w;
    }
    for (std::size_t i = 0; i < path.count; ++i) {
        shared.branch[i] = m_children[path.child[i]].source;
        shared.weight[i] = float(weight[i] / sum);
    }
    m_sink->forkVertices.push_back(shared);
    m_vertices.push_back(vertex);
    return static_cast<Index>(m_vertices.size() - 1);
}

void ForkWalls::makeCorners()
{
    m_corners.clear();
    double guess = 0.0; // the corners of a fork are often about as high as each other
    for (const ForkTriangulation::Triangle& triangle : m_layout->triangulation.triangles()) {
        WallPath path;
        path.child = triangle.site;
        path.count = 3;
        m_corners.push_back({path, m_lift.lift(path, guess)});
        guess = m_corners.back().at.along;
    }
    for (int round = 0; round < cornerRounds && partCorners(); ++round)
        ;
    for (const Corner& corner : m_corners)
        add(corner.at, corner.path);
}

bool ForkWalls::standsLate() const
{
    double highest = 0.0, shortest = std::numeric_limits<double>::max();
    for (const Corner& corner : m_corners)
        highest = std::max(highest, corner.at.along);
    for (const ForkChild& child : m_children)
        shortest = std::min(shortest, child.table.length());
    return highest > lateShare * shortest;
}

/// Where four tubes are about as far from one point, two corners lie there, and perhaps in the wrong order:
/// pushes neighbours apart. Returns whether that was necessary.
bool ForkWalls::partCorners()
{
    const auto& triangles = m_layout->triangulation.triangles();
    bool moved = false;
    for (Index t = 0; t < triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const Index other = triangles[t].neighbour[e];
            if (other == noIndex || other < t)
                continue;
            WallPath path;
            path.child = {triangles[t].site[e], triangles[t].site[(e + 1) % 3], noIndex};
            path.aside = outward(path.child[0], path.child[1]);
            const double along = 0.5 * (m_corners[t].at.along + m_corners[other].at.along);
            const glm::dvec3 centre = m_lift.pointAt(path, along);
            path.out = 1.0;
            const glm::dvec3 aside = m_lift.pointAt(path, along) - centre;
            const double lack = cornerGap * m_lift.meanRadius(path) -
                                glm::dot(m_corners[other].at.position - m_corners[t].at.position, aside);
            if (lack <= 0.0)
                continue;
            m_corners[other].at.position += (0.5 * lack) * aside;
            m_corners[t].at.position -= (0.5 * lack) * aside;
            moved = true;
        }
    return moved;
}

/// The wall between two children, without its ends.
ForkWalls::WallPlan ForkWalls::planWall(Index from, Index to) const
{
    WallPlan plan;
    plan.path.child = {from, to, noIndex};
    plan.path.aside = outward(from, to);
    plan.reach = (1.0 + ForkLift::margin) *
                 std::max(m_children[from].sections.front().radius, m_children[to].sections.front().radius);
    plan.step = std::numeric_limits<double>::max();
    for (const Index child : {from, to}) {
        const ForkChild& tube = m_children[child];
        const double spacing = tube.table.length() / static_cast<double>(tube.sections.size() - 1);
        const double pitch = 2.0 * pi * tube.sections.front().radius / m_radialDivisions;
        plan.step = std::min(plan.step, std::max(spacing, pitch));
    }
    return plan;
}

/// A wall that begins at a point of the ring, or, if \p far, ends there.
void ForkWalls::leanToRing(WallPlan& plan, std::size_t edge, bool far) const
{
    const RingPoint& point = m_layout->ring[m_layout->splitPoint[edge]];
    const glm::dvec3 direction =
        m_ring->frame.normal * point.direction.x + m_ring->frame.binormal * point.direction.y;
    (far ? plan.farRing : plan.nearRing) = direction;
    (far ? plan.endsOnRing : plan.beginsOnRing) = true;
}

/// Angle on the circle of a pair's tubes, seen along them from the middle between: 0 on the outside, where
/// the ring is; half a turn at the far side.
ForkWalls::WallSample ForkWalls::cornerOf(const WallPlan& plan, Index corner) const
{
    const ForkLift::Lifted& at = m_corners[corner].at;
    WallPath middle = plan.path;
    middle.out = 0.0;
    WallPath aside = plan.path;
    aside.out = 1.0;
    const glm::dvec3 centre = m_lift.pointAt(middle, at.along);
    const double out = glm::dot(at.position - centre, m_lift.pointAt(aside, at.along) - centre);
    return {maths::acos(std::clamp(out / plan.reach, -leastCosine, leastCosine)), at};
}

WallPath ForkWalls::pathAt(const WallPlan& plan, double angle)
{
    WallPath path = plan.path;
    const auto [sine, cosine] = maths::sincos(angle);
    path.out = plan.reach * cosine;
    path.up = plan.reach * sine;
    if (path.onLimb)
        return path;
    const bool far = cosine < 0.0;
    if (far ? plan.endsOnRing : plan.beginsOnRing) {
        path.leansUpTo = plan.leansUpTo;
        path.atRing = far ? -plan.farRing : plan.nearRing;
    }
    return path;
}

ForkLift::Lifted ForkWalls::liftAt(const WallPlan& plan, double angle, double most) const
{
    const WallPath path = pathAt(plan, angle);
    if (path.onLimb)
        return m_lift.liftOnLimb(path, plan.from);
    return m_lift.lift(path, m_guess.exitAt(path.out), most);
}

/// A vertex between two neighbours that are too far apart in height. None where the wall jumps.
std::optional<ForkWalls::WallSample> ForkWalls::sampleBetween(const WallPlan& plan, const WallSample& from,
                                                              const WallSample& to) const
{
    const auto [low, high] = std::minmax(from.at.along, to.at.along);
    const double least = leastStepShare * (high - low);
    double lowAngle = from.at.along < to.at.along ? from.angle : to.angle;
    double highAngle = from.at.along < to.at.along ? to.angle : from.angle;
    while (std::abs(highAngle - lowAngle) >= 2.0 * leastAngle) {
        const double angle = 0.5 * (lowAngle + highAngle);
        const ForkLift::Lifted middle = liftAt(plan, angle, high);
        if (middle.along < low + least)
            lowAngle = angle;
        else if (middle.along > high - least)
            highAngle = angle;
        else
            return WallSample{angle, middle};
    }
    return std::nullopt;
}

/// A wall's vertices, first at even angles, then more where it is steep: no two neighbours should be further
/// apart in height than the sections of the tubes beside it.
ForkWalls::Wall ForkWalls::makeWall(WallPlan plan, const WallSample& from, const WallSample& to)
{
    if (!plan.path.onLimb) {
        m_guess.build(plan.path);
        plan.leansUpTo = std::max(leanHeight * plan.reach, m_guess.exitAt(leanReach * plan.reach));
    }
    const double highest = std::max(from.at.along, to.at.along), range = to.angle - from.angle;
    const bool peaked = plan.endsOnRing && isPeaked(m_radialDivisions);
    const long mids =
        std::max<long>(1, std::lround(2.0 / pi * std::abs(range) * m_midsPerQuarter) + (peaked ? 1 : 0));
    m_samples.clear();
    m_samples.push_back(from);
    for (long i = 1; i <= mids; ++i) {
        const double angle = from.angle + range * static_cast<double>(i) / static_cast<double>(mids + 1);
        m_samples.push_back({angle, liftAt(plan, angle, highest)});
        plan.from = m_samples.back().at.along;
    }
    m_samples.push_back(to);
    for (std::size_t i = 0; i + 1 < m_samples.size() && m_samples.size() < mostPerWall;) {
        const WallSample &a = m_samples[i], &b = m_samples[i + 1];
        const std::optional<WallSample> middle =
            std::abs(b.at.along - a.at.along) > plan.step ? sampleBetween(plan, a, b) : std::nullopt;
        if (middle)
            m_samples.insert(m_samples.begin() + static_cast<std::ptrdiff_t>(i) + 1, *middle);
        else
            ++i;
    }
    const Wall wall{static_cast<Index>(m_vertices.size()), static_cast<Index>(m_samples.size() - 2)};
    for (std::size_t i = 1; i + 1 < m_samples.size(); ++i)
        add(m_samples[i].at, plan.path);
    return wall;
}

/// The wall over a limb that leaves a stem to its side: an arch on the stem's surface, from the one point of
/// the ring beside the limb to the other.
ForkWalls::WallPlan ForkWalls::planArch(std::size_t edge) const
{
    const ForkTriangulation::HullEdge& hull = m_layout->triangulation.hull()[edge];
    WallPlan plan = planWall(hull.to, hull.from);
    const auto direction = [&](std::size_t e) {
        const glm::dvec2 on = m_layout->ring[m_layout->splitPoint[e]].direction;
        return m_ring->frame.normal * on.x + m_ring->frame.binormal * on.y;
    };
    plan.path.aside = glm::normalize(direction(edge) - direction(hull.partner));
    plan.path.onLimb = true;
    plan.reach = (1.0 + ForkLift::margin) * m_children[hull.to].sections.front().radius;
    plan.endsOnRing = true;
    const std::vector<AxisSection>& sections = m_children[hull.to].sections;
    const glm::dvec3 end = sections.back().centre - sections.front().centre;
    const glm::dvec3 aside = glm::cross(end, m_ring->frame.tangent);
    plan.from = m_ring->radius * glm::length(end) / std::max(glm::length(aside), 0.1 * glm::length(end));
    return plan;
}

/// Walls that begin on the ring. They end at their triangle's corner, or, where all children lie in one
/// plane, at the other side of the ring.
void ForkWalls::makeHullWalls()
{
    const auto& hull = m_layout->triangulation.hull();
    m_hullWall.assign(hull.size(), {});
    for (std::size_t e = 0; e < hull.size(); ++e) {
        const ForkTriangulation::HullEdge& edge = hull[e];
        const std::size_t opposite = edge.partner;
        const bool across = edge.triangle == noIndex;
        if (across && e > opposite) {
            m_hullWall[e] = m_hullWall[opposite];
            continue;
        }
        if (m_layout->stem != noIndex) {
            m_hullWall[e] = makeWall(planArch(e), {0.0, {}}, {pi, {}});
            continue;
        }
        WallPlan plan = planWall(edge.from, edge.to);
        leanToRing(plan, e, false);
        if (across)
            leanToRing(plan, opposite, true);
        m_hullWall[e] =
            makeWall(plan, {0.0, {}}, across ? WallSample{pi, {}} : cornerOf(plan, edge.triangle));
    }
}

/// Walls from corner to corner.
void ForkWalls::makeInnerWalls()
{
    const auto& triangles = m_layout->triangulation.triangles();
    m_innerWall.assign(triangles.size(), {});
    for (Index t = 0; t < triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const Index other = triangles[t].neighbour[e];
            if (other == noIndex || other < t)
                continue;
            const Index u = triangles[t].site[e], v = triangles[t].site[(e + 1) % 3];
            const WallPlan plan = planWall(u, v);
            const Wall wall = makeWall(plan, cornerOf(plan, other), cornerOf(plan, t));
            m_innerWall[t][e] = wall;
            const auto& back = triangles[other].site;
            for (std::size_t i = 0; i < 3; ++i)
                if (back[i] == v && back[(i + 1) % 3] == u)
                    m_innerWall[other][i] = wall;
        }
}

/// Moves the walls' vertices out of the valleys, once all of them are known.
void ForkWalls::soften(ForkSoftener& softener)
{
    double highest = 0.0;
    for (const CellVertex& vertex : m_vertices)
        highest = std::max(highest, vertex.lifted);
    softener.limit(highest);
    if (!softener.isOn())
        return;
    const std::size_t first = m_sink->forkVertices.size() - m_vertices.size();
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        CellVertex& vertex = m_vertices[i];
        if (!softener.soften(vertex.cells, vertex.position, vertex.lifted))
            continue;
        m_sink->positions[vertex.vertex] = glm::vec3(vertex.position);
        m_sink->forkVertices[first + i].along = float(vertex.lifted);
    }
}

void ForkWalls::build(const ForkLayout& layout, const ForkRing& ring, std::span<const ForkChild> children,
                      ForkSoftener& softener, int radialDivisions, MeshSink& sink)
{
    m_layout = &layout;
    m_ring = &ring;
    m_children = children;
    m_sink = &sink;
    m_radialDivisions = radialDivisions;
    m_midsPerQuarter = std::clamp((radialDivisions + 1) / 4, 1, 12);
    m_lift.begin(children);
    m_guess.begin(children);
    m_vertices.clear();
    makeCorners();
    m_isLate = standsLate();
    makeHullWalls();
    makeInnerWalls();
    soften(softener);

    m_hullFrom.assign(children.size(), noIndex);
    m_hullTo.assign(children.size(), noIndex);
    m_triangleOf.assign(children.size(), noIndex);
    const auto& hull = layout.triangulation.hull();
    for (Index e = 0; e < hull.size(); ++e) {
        m_hullFrom[hull[e].from] = e;
        m_hullTo[hull[e].to] = e;
    }
    m_ringCells.assign(ring.points.size(), {noIndex, noIndex, noIndex});
    for (Index e = 0; e < hull.size(); ++e)
        m_ringCells[layout.splitPoint[e]] = {hull[e].from, hull[e].to, noIndex};
    const auto& triangles = layout.triangulation.triangles();
    for (Index t = 0; t < triangles.size(); ++t)
        for (const Index site : triangles[t].site)
            m_triangleOf[site] = t;
}

void ForkWalls::appendRing(Index point, std::vector<CellVertex>& boundary) const
{
    boundary.push_back({m_ring->firstVertex + point, m_ring->points[point], 0.0,
                        m_layout->ring[point].azimuth, true, m_ringCells[point]});
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

/// The mids of a wall between two corners, away from that of \p triangle.
void ForkWalls::appendInner(Index triangle, std::size_t edge, std::vector<CellVertex>& boundary) const
{
    const Wall& wall = m_innerWall[triangle][edge];
    const bool forwards = m_layout->triangulation.triangles()[triangle].neighbour[edge] < triangle;
    for (Index i = 0; i < wall.count; ++i)
        boundary.push_back(m_vertices[wall.first + (forwards ? i : wall.count - 1 - i)]);
}

/// Walls and corners around a child, from the hull edge that leaves it to one that reaches it, which is
/// returned.
std::size_t ForkWalls::appendAround(Index child, std::size_t edge, std::vector<CellVertex>& boundary) const
{
    const auto& hull = m_layout->triangulation.hull();
    const auto& triangles = m_layout->triangulation.triangles();
    if (hull[edge].triangle == noIndex) {
        const std::size_t opposite = hull[edge].partner;
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
        appendInner(at, back, boundary);
        at = triangle.neighbour[back];
    }
}

/// To a limb the ring is a part of the stem it leaves, like the wall: no place where its own azimuths begin.
void ForkWalls::leaveRing(std::vector<CellVertex>& boundary)
{
    double lowest = std::numeric_limits<double>::max();
    for (const CellVertex& vertex : boundary)
        if (!vertex.onRing)
            lowest = std::min(lowest, vertex.lifted);
    for (CellVertex& vertex : boundary)
        if (vertex.onRing) {
            vertex.onRing = false;
            vertex.lifted = lowest;
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
        if (m_layout->stem != noIndex && child != m_layout->stem)
            leaveRing(boundary);
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
        appendInner(at, back, boundary);
        at = triangles[at].neighbour[back];
    } while (at != start);
}

} // namespace ramure
