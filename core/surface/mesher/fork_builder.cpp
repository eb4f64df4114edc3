#include "core/surface/mesher/fork_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ramure {

namespace {

// Shares of the radius.
constexpr double roomAboveFront = 0.25; ///< between a fork's highest wall and the first full ring
constexpr double roomInFront = 0.65;    ///< between a wall and a point of a partial ring
constexpr double freeRoom = 0.25;       ///< between a sibling's tube and such a point
constexpr double trimMargin = 0.02;     ///< between a trimmed ring and the plane it is trimmed to
constexpr double leastStretch = 0.35;   ///< see TubeScale
constexpr double leastTrimmed = 0.05;   ///< no point is drawn nearer to the centre
constexpr double usualSoftness = 0.64;  ///< times the reach: up to here tubes keep apart
constexpr double farSoftness = 1.2;     ///< the same: every fork is looked at
constexpr double hopelessShare = 0.12;  ///< pairs in a fork's triangles: no other way is tried
constexpr int allSides = std::numeric_limits<int>::max();

} // namespace

// Coarser walls first: they are the most likely to help, and show the least.
const std::array<ForkBuilder::Way, 8> ForkBuilder::lateWays{{{allSides, true, 1.0},
                                                             {8, true, 1.0},
                                                             {5, true, 1.0},
                                                             {allSides, false, 1.0},
                                                             {8, false, 1.0},
                                                             {5, false, 1.0},
                                                             {8, true, 0.0},
                                                             {5, false, 0.0}}};
const std::array<ForkBuilder::Way, 5> ForkBuilder::softWays{{{allSides, true, 1.0},
                                                             {allSides, true, 0.7},
                                                             {allSides, true, 0.4},
                                                             {allSides, true, 0.2},
                                                             {allSides, true, 0.0}}};

bool ForkBuilder::isFree(Index child, const glm::dvec3& point, double along) const
{
    for (std::size_t j = 0; j < m_count; ++j)
        if (j != child &&
            m_children[j].table.clearance(point, along) <= freeRoom * m_children[j].sections[0].radius)
            return false;
    return true;
}

/// Below the first complete ring a child's tube shows only on the outside of the fork: those points are kept.
void ForkBuilder::insertPartialRings(Index child, std::size_t full)
{
    const ForkChild& tube = m_children[child];
    std::size_t last = 0;
    for (std::size_t k = 1; k < full; ++k) {
        const AxisSection& section = tube.sections[k];
        if (!keeps(tube, last, k) ||
            tube.sections[full].along - section.along < roomAboveFront * section.radius)
            continue;
        last = k;
        const bool swells = m_softener.isOn() && m_softener.comesNear(child, section);
        for (const RingPoint& on : m_context.divisions.ring(tube.branch, section.radius)) {
            if (alongAt(m_front, on.azimuth) + roomInFront * section.radius >= section.along)
                continue;
            glm::dvec3 point = ringPosition(section, on);
            if (!isFree(child, point, section.along) ||
                !m_patch.insert({on.azimuth, section.along, m_context.sink.nextVertex()}))
                continue;
            if (swells) {
                const glm::dvec3 out = (point - section.centre) / section.radius;
                point += m_softener.swelling(section, point, out) * out;
            }
            m_context.sink.addVertex(point, tube.source);
        }
    }
}

/// The first section above the whole front; the end takes that part if no other can.
std::size_t ForkBuilder::firstFullSection(const ForkChild& tube) const
{
    double highest = 0.0;
    for (const UnrolledVertex& vertex : m_front)
        highest = std::max(highest, vertex.along);
    const std::size_t end = tube.sections.size() - 1;
    std::size_t full = 1;
    while (full < end && (tube.sections[full].along < highest + roomAboveFront * tube.sections[full].radius ||
                          !keeps(tube, 0, full)))
        ++full;
    return full;
}

/// The last section below the first full one that can have points: the one the full one follows.
std::size_t ForkBuilder::lastSectionBelow(const ForkChild& tube, std::size_t full) const
{
    std::size_t last = 0;
    for (std::size_t k = 1; k < full; ++k)
        if (keeps(tube, last, k))
            last = k;
    return last;
}

void ForkBuilder::swellRing(const AxisSection& section, Index ring, std::size_t count)
{
    for (std::size_t i = ring; i < ring + count; ++i) {
        glm::vec3& position = m_context.sink.positions[i];
        const glm::dvec3 point(position), out = (point - section.centre) / section.radius;
        if (const double way = m_softener.swelling(section, point, out); way > 0.0)
            position = glm::vec3(point + way * out);
    }
}

/// Complete rings swell as well, as far as a sibling is near; not the last one, which the next fork starts
/// from.
void ForkBuilder::swellRingsAbove(Index child, std::size_t full, Index ring)
{
    const ForkChild& tube = m_children[child];
    std::size_t below = full;
    for (std::size_t k = full; k + 1 < tube.sections.size(); ++k) {
        const AxisSection& section = tube.sections[k];
        if (k != full && !keeps(tube, below, k))
            continue;
        if (!m_softener.comesNear(child, section))
            return;
        const std::size_t count = m_context.divisions.ring(tube.branch, section.radius).size();
        swellRing(section, ring, count);
        ring += static_cast<Index>(count);
        below = k;
    }
}

/// Tubes that never come apart end inside each other: the points of a last ring that lie in a sibling's tube
/// draw back towards the centre, to the plane between the two axes.
void ForkBuilder::trimEndRing(Index child, const AxisSection& section, Index ring, std::size_t count)
{
    std::vector<glm::vec3>& positions = m_context.sink.positions;
    for (std::size_t j = 0; j < m_count; ++j) {
        if (j == child)
            continue;
        const AxisTable& other = m_children[j].table;
        const double foot = other.footOf(section.centre, section.along);
        const AxisTable::Place place = other.at(foot);
        const glm::dvec3 between = place.point - section.centre;
        const double apart = glm::length(between);
        if (apart >= section.radius + place.radius || apart < 1e-3 * section.radius)
            continue;
        const glm::dvec3 direction = between / apart;
        const double plane =
            std::max(leastTrimmed * section.radius,
                     apart * section.radius / (section.radius + place.radius) - trimMargin * section.radius);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 away = glm::dvec3(positions[ring + i]) - section.centre;
            const double along = glm::dot(away, direction);
            if (along > plane && other.clearance(section.centre + away, foot) < 0.0)
                positions[ring + i] = glm::vec3(section.centre + away * (plane / along));
        }
    }
}

/// Distances along a tube count less the longer its plain triangles are.
TubeScale ForkBuilder::scaleOf(const ForkChild& tube) const
{
    const double radius = tube.sections.front().radius;
    const auto sides = static_cast<double>(m_context.divisions.ring(tube.branch, radius).size());
    const double spacing = tube.table.length() / static_cast<double>(tube.sections.size() - 1);
    return {radius, std::clamp(2.0 * std::numbers::pi * radius / (sides * spacing), leastStretch, 1.0)};
}

void ForkBuilder::startTube(Index child, const Way& way, std::vector<TubeEnd>& ends)
{
    const ForkChild& tube = m_children[child];
    const MeshBranch& own = m_context.skeleton.branches[tube.branch];
    const bool isStem = m_context.skeleton.branches[own.parent].isPlate;
    m_context.sink.startTube(
        tube.source, isStem ? noIndex : m_ring.source,
        own.tubeAxis(meshCurve(m_context.skeleton, tube.branch, m_context.clampOvershoot)));
    m_walls.cell(child, m_boundary);
    m_unroller.unroll(m_boundary, tube, child, m_context.skeleton.branches[tube.branch].rollRad, m_front);
    const std::size_t full = firstFullSection(tube);
    const bool atEnd = full + 1 == tube.sections.size();
    const AxisSection& section = tube.sections[full];
    const std::span<const RingPoint> points =
        atEnd ? m_tubes.endRing(tube.branch, section) : m_context.divisions.ring(tube.branch, section.radius);
    const Index ring = addRing(section, points, tube.source, m_context.sink);
    if (atEnd)
        trimEndRing(child, section, ring, points.size());
    m_upper.clear();
    const std::size_t below = lastSectionBelow(tube, full);
    const double twist = below + 1 == full ? 0.0 : twistBetween(tube.sections[below], section);
    for (std::size_t i = 0; i < points.size(); ++i)
        m_upper.push_back({points[i].azimuth + twist, section.along, ring + static_cast<Index>(i)});
    // A wall as high as the end itself would turn the strip upside down in the unrolled plane.
    const double most = section.along - 0.05 * section.radius;
    for (UnrolledVertex& vertex : m_front)
        vertex.along = std::min(vertex.along, most);
    m_patch.zip(m_front, m_upper, scaleOf(tube));
    if (m_count > 2 || m_patch.isCrooked())
        m_patch.relax();
    if (way.partialRings)
        insertPartialRings(child, full);
    m_patch.relax();
    const std::size_t strip = m_context.sink.triangles.size();
    m_patch.write(m_context.sink);
    const std::size_t above = m_context.sink.triangles.size();
    if (atEnd)
        m_tubes.end(tube.branch, section, ring, points.size(), ends);
    else
        m_tubes.finish(tube.branch, tube.sections, full, {ring, points}, ends);
    if (m_softener.isOn())
        swellRingsAbove(child, full, ring);
    if (m_isChecked)
        m_check.add(m_patch, m_context.sink, strip);
    if (m_isChecked && isVerySoft())
        m_check.addBands(m_context.sink, above);
}

/// On the average: what the walls between them are divided by.
int ForkBuilder::sidesOfChildren() const
{
    std::size_t sides = 0;
    for (std::size_t i = 0; i < m_count; ++i)
        sides += m_context.divisions.ring(m_children[i].branch, m_children[i].sections.front().radius).size();
    return static_cast<int>(sides / m_count);
}

void ForkBuilder::attempt(const Way& way, std::vector<TubeEnd>& ends)
{
    const std::span<const ForkChild> children(m_children.data(), m_count);
    const BranchMeshOptions& options = m_context.options;
    m_softener.begin(children, options.forkReach, way.softness * options.forkSoftness);
    m_walls.build(m_layout, m_ring, children, m_softener, std::min(sidesOfChildren(), way.mostSides),
                  m_context.sink);
    // Where tubes come apart late, walls stand close together: fine ones may fold into each other.
    m_isChecked = m_walls.isLate() || isVerySoft();
    m_check.begin();
    for (Index i = 0; i < m_count; ++i)
        startTube(i, way, ends);
}

/// Softer than usual: tubes may swell into each other.
bool ForkBuilder::isVerySoft() const
{
    return m_context.options.forkReach * m_context.options.forkSoftness > usualSoftness;
}

/// So soft that tubes run through each other without being folded.
bool ForkBuilder::swellsFar() const
{
    return m_context.options.forkReach * m_context.options.forkSoftness > farSoftness;
}

void ForkBuilder::takeBack(const Before& before, std::vector<TubeEnd>& ends)
{
    MeshSink& sink = m_context.sink;
    sink.positions.resize(before.vertices);
    sink.owner.resize(before.vertices);
    sink.triangles.resize(before.triangles);
    sink.tubes.resize(before.tubes);
    sink.axes.resize(before.tubes);
    sink.forkVertices.resize(before.forkVertices);
    ends.resize(before.ends);
}

/// A strip is folded: if the fork's tubes run through each other, other ways are tried.
void ForkBuilder::findBetterWay(const Before& before, std::vector<TubeEnd>& ends)
{
    const std::span<const Way> ways = m_walls.isLate() ? std::span<const Way>(lateWays) : softWays;
    std::size_t best = 0, built = 0;
    // Branches as thick as long run through each other whatever is done.
    const auto hopeless = static_cast<std::size_t>(hopelessShare * static_cast<double>(m_check.faceCount()));
    std::size_t least = m_check.count(m_context.sink, hopeless + 1);
    if (least > hopeless)
        return m_untangler.untangle(m_check, m_context.sink, static_cast<Index>(before.vertices));
    for (std::size_t way = 1; way < ways.size() && least > 0; ++way) {
        takeBack(before, ends);
        attempt(ways[way], ends);
        built = way;
        const std::size_t found = m_check.count(m_context.sink, least);
        if (found >= least)
            continue;
        least = found;
        best = way;
    }
    if (built != best) {
        takeBack(before, ends);
        attempt(ways[best], ends);
    }
    if (least > 0)
        m_untangler.untangle(m_check, m_context.sink, static_cast<Index>(before.vertices));
}

void ForkBuilder::build(const TubeEnd& parent, std::vector<TubeEnd>& ends)
{
    const AxisSection& end = parent.section;
    const std::span<const Index> ids = m_context.skeleton.childrenOf(parent.branch);
    m_count = ids.size();
    if (m_children.size() < m_count)
        m_children.resize(m_count);
    for (std::size_t i = 0; i < m_count; ++i) {
        ForkChild& child = m_children[i];
        const MeshBranch& own = m_context.skeleton.branches[ids[i]];
        child.branch = ids[i];
        child.source = own.source;
        m_axes.build(meshCurve(m_context.skeleton, ids[i], m_context.clampOvershoot), own, end.frame,
                     m_context.divisions.sections(ids[i]), child.sections, &child.table);
    }
    planFork(m_context, parent.branch, end, m_planner, m_layout);
    m_ring.centre = end.centre;
    m_ring.frame = end.frame;
    m_ring.radius = end.radius;
    m_ring.firstVertex = parent.ring;
    m_ring.source = m_context.skeleton.branches[parent.branch].source;
    m_ring.points.clear();
    for (std::size_t i = 0; i < m_layout.ring.size(); ++i)
        m_ring.points.emplace_back(m_context.sink.positions[parent.ring + i]);
    const MeshSink& sink = m_context.sink;
    const Before before{sink.positions.size(), sink.triangles.size(), sink.tubes.size(),
                        sink.forkVertices.size(), ends.size()};
    attempt(lateWays.front(), ends);
    if (m_check.isFolded() || (m_isChecked && swellsFar()))
        findBetterWay(before, ends);
}

} // namespace ramure
