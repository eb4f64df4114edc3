#include "core/mesh/fork_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double roomBeforeEnd = 0.25; ///< of the radius, between a section and the end
constexpr double roomBetween = 0.02;   ///< of the radius, between two sections
constexpr double roomAboveFront =
    0.25;                           ///< of the radius, between a fork's highest wall and the first full ring
constexpr double roomInFront = 0.5; ///< of the radius, between a wall and a point of a partial ring

glm::dvec3 ringPoint(const AxisSection& section, double azimuth)
{
    return section.centre + section.radius * (std::cos(azimuth) * section.frame.normal +
                                              std::sin(azimuth) * section.frame.binormal);
}

/// Would the rings of two sections, the second further on, cut through each other?
bool cross(const AxisSection& first, const AxisSection& second)
{
    const glm::dvec3 way = second.centre - first.centre;
    const double bend = glm::length(glm::cross(first.frame.tangent, second.frame.tangent));
    return glm::dot(way, first.frame.tangent) < second.radius * bend ||
           glm::dot(way, second.frame.tangent) < first.radius * bend;
}

} // namespace

double regularAzimuth(Index k, int radialDivisions)
{
    return turn * static_cast<double>(k) / radialDivisions;
}

Index addRing(const AxisSection& section, std::span<const double> azimuths, Index owner, MeshSink& sink)
{
    const auto first = static_cast<Index>(sink.positions.size());
    for (const double azimuth : azimuths)
        sink.addVertex(ringPoint(section, azimuth), owner);
    return first;
}

bool keepsSection(const std::vector<AxisSection>& sections, std::size_t last, std::size_t k)
{
    if (k + 1 >= sections.size())
        return true;
    const AxisSection &section = sections[k], &end = sections.back();
    return end.along - section.along >= roomBeforeEnd * section.radius &&
           section.along - sections[last].along >= roomBetween * section.radius &&
           !cross(sections[last], section) && !cross(section, end);
}

bool EndPlanner::plan(const MesherContext& context, Index branch, const AxisSection& end)
{
    const std::span<const Index> children = context.skeleton.childrenOf(branch);
    if (children.size() >= 2) {
        m_directions.clear();
        for (const Index child : children) {
            const MeshBranch& c = context.skeleton.branches[child];
            m_directions.push_back(glm::normalize(c.p1 - c.p0));
        }
        m_planner.plan(end.frame, m_directions, context.options.radialDivisions, m_layout);
        m_azimuths = m_layout.azimuths;
        return true;
    }
    m_azimuths.clear();
    for (Index k = 0; k < static_cast<Index>(context.options.radialDivisions); ++k)
        m_azimuths.push_back(regularAzimuth(k, context.options.radialDivisions));
    return false;
}

bool ForkBuilder::isFree(Index child, const glm::dvec3& point, double along) const
{
    for (std::size_t j = 0; j < m_count; ++j)
        if (j != child && m_children[j].table.clearance(point, along) <= 0.0)
            return false;
    return true;
}

/// Below the first complete ring a child's tube shows only on the outside of the fork: those points are kept.
void ForkBuilder::insertPartialRings(Index child, std::size_t full)
{
    const ForkChild& tube = m_children[child];
    const int n = m_context.options.radialDivisions;
    std::size_t last = 0;
    for (std::size_t k = 1; k < full; ++k) {
        const AxisSection& section = tube.sections[k];
        if (!keepsSection(tube.sections, last, k) ||
            tube.sections[full].along - section.along < roomAboveFront * section.radius)
            continue;
        last = k;
        for (Index i = 0; i < static_cast<Index>(n); ++i) {
            const double azimuth = regularAzimuth(i, n);
            if (alongAt(m_front, azimuth) + roomInFront * section.radius >= section.along)
                continue;
            const glm::dvec3 point = ringPoint(section, azimuth);
            if (!isFree(child, point, section.along))
                continue;
            const auto vertex = static_cast<Index>(m_context.sink.positions.size());
            if (m_patch.insert({azimuth, section.along, vertex}))
                m_context.sink.addVertex(point, tube.source);
        }
    }
}

TubeStart ForkBuilder::startTube(Index child, const Frame& frame)
{
    const ForkChild& tube = m_children[child];
    const MeshBranch& branch = m_context.skeleton.branches[tube.branch];
    m_walls.cell(child, m_boundary);
    m_unroller.unroll(m_boundary, tube, branch.rollRad, m_front);
    double highest = 0.0;
    for (const UnrolledVertex& vertex : m_front)
        highest = std::max(highest, vertex.along);

    const std::size_t end = tube.sections.size() - 1;
    std::size_t full = 1;
    while (full < end && (tube.sections[full].along < highest + roomAboveFront * tube.sections[full].radius ||
                          !keepsSection(tube.sections, 0, full)))
        ++full;
    const AxisSection& section = tube.sections[full];
    std::vector<double> azimuths;
    if (full == end) {
        m_ends.plan(m_context, tube.branch, section);
        azimuths = m_ends.azimuths();
    } else {
        for (Index i = 0; i < static_cast<Index>(m_context.options.radialDivisions); ++i)
            azimuths.push_back(regularAzimuth(i, m_context.options.radialDivisions));
    }
    const Index first = addRing(section, azimuths, tube.source, m_context.sink);
    m_upper.clear();
    for (std::size_t i = 0; i < azimuths.size(); ++i)
        m_upper.push_back({azimuths[i], section.along, first + static_cast<Index>(i)});
    // A wall as high as the end itself would turn the strip upside down in the unrolled plane.
    const double most = section.along - 0.05 * section.radius;
    for (UnrolledVertex& vertex : m_front)
        vertex.along = std::min(vertex.along, most);
    m_patch.zip(m_front, m_upper, tube.sections.front().radius);
    insertPartialRings(child, full);
    m_patch.write(m_context.sink);
    return {tube.branch, frame, first, static_cast<Index>(full)};
}

void ForkBuilder::build(Index branch, const AxisSection& end, const ForkLayout& layout, Index firstVertex,
                        std::vector<TubeStart>& starts)
{
    const std::span<const Index> ids = m_context.skeleton.childrenOf(branch);
    m_count = ids.size();
    if (m_children.size() < m_count)
        m_children.resize(m_count);
    for (std::size_t i = 0; i < m_count; ++i) {
        ForkChild& child = m_children[i];
        const MeshBranch& own = m_context.skeleton.branches[ids[i]];
        child.branch = ids[i];
        child.source = own.source;
        m_axes.build(meshCurve(m_context.skeleton, ids[i], m_context.options.clampOvershoot), own, end.frame,
                     m_context.options.lengthDivisions, child.sections, &child.table);
    }
    m_ring.centre = end.centre;
    m_ring.frame = end.frame;
    m_ring.radius = end.radius;
    m_ring.firstVertex = firstVertex;
    m_ring.points.clear();
    for (const double azimuth : layout.azimuths)
        m_ring.points.push_back(ringPoint(end, azimuth));
    m_walls.build(layout, m_ring, {m_children.data(), m_count}, m_context.options.radialDivisions,
                  m_context.sink);
    starts.clear();
    for (Index i = 0; i < m_count; ++i)
        starts.push_back(startTube(i, end.frame));
}

} // namespace ramure
