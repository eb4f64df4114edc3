#include "core/surface/check/wood_sections.h"

#include "core/math/angle.h"
#include "core/math/hermite.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_map>

namespace ramure {

namespace {

constexpr double limbShare = 0.5;  ///< of its sibling's radius: no more, and it is a limb of that one
constexpr double sideShare = 0.75; ///< the same where it goes to the side
constexpr double sideways = 0.6;   ///< cosine of the angle to its sibling: the same of any thickness
constexpr double outOfStem = 1.6;  ///< of its radius
constexpr double mostReach = 2.5;  ///< of the tube's radius: no wood of it is farther from its axis
constexpr double wide = 1.08;      ///< of the added radii: from there on two tubes are apart

} // namespace

WoodSections::WoodSections(const BranchMesh& mesh)
    : m_mesh(mesh)
    , m_tubes(mesh.tubes.size())
{
    std::unordered_map<Index, std::size_t> tubeOf;
    for (std::size_t i = 0; i < m_tubes.size(); ++i) {
        Tube& tube = m_tubes[i];
        const BranchCurve& curve = mesh.axes[i].curve;
        for (int k = 0; k <= steps; ++k) {
            tube.points.push_back(hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(k) / steps).point);
            tube.along.push_back(
                k == 0 ? 0.0 : tube.along.back() + glm::distance(tube.points[k], tube.points[k - 1]));
        }
        tube.thickness = mesh.axes[i].a0;
        if (const Index parent = mesh.tubes[i].parent; parent == noIndex) {
            m_roots.push_back(i);
        } else if (const auto below = tubeOf.find(parent); below != tubeOf.end()) {
            tube.fork = below->second;
            m_tubes[tube.fork].children.push_back(i);
        }
        tubeOf[mesh.tubes[i].branch] = i; // the upper part of a branch starts from its lower one
    }
    for (Tube& tube : m_tubes) {
        for (const std::size_t child : tube.children)
            if (tube.stem == none || m_tubes[child].thickness > m_tubes[tube.stem].thickness)
                tube.stem = child;
        for (const std::size_t child : tube.children)
            if (child != tube.stem) {
                const double share = m_tubes[child].thickness / m_tubes[tube.stem].thickness;
                const bool isAside = glm::dot(wayOf(child), wayOf(tube.stem)) < sideways;
                m_tubes[child].isLimb = share <= (isAside ? sideShare : limbShare);
            }
    }
}

glm::dvec3 WoodSections::wayOf(std::size_t tube) const
{
    const glm::dvec3 way = m_tubes[tube].points.back() - m_tubes[tube].points.front();
    return way / std::max(glm::length(way), 1e-12);
}

WoodSections::Place WoodSections::at(std::size_t tube, double along) const
{
    const Tube& t = m_tubes[tube];
    const auto above = std::ranges::upper_bound(t.along, std::clamp(along, 0.0, length(tube)));
    const std::size_t cell =
        std::clamp<std::size_t>(std::size_t(above - t.along.begin()), 1, std::size_t(steps)) - 1;
    const double span = t.along[cell + 1] - t.along[cell];
    const double part = span > 0.0 ? std::clamp((along - t.along[cell]) / span, 0.0, 1.0) : 0.0;
    const glm::dvec3 way = t.points[cell + 1] - t.points[cell];
    return {t.points[cell] + part * way, span > 0.0 ? way / span : glm::dvec3(0, 1, 0),
            m_mesh.axes[tube].radiusAt((double(cell) + part) / steps)};
}

std::vector<std::size_t> WoodSections::siblings(std::size_t tube) const
{
    std::vector<std::size_t> out;
    if (m_tubes[tube].fork != none)
        for (const std::size_t other : m_tubes[m_tubes[tube].fork].children)
            if (other != tube)
                out.push_back(other);
    return out;
}

/// m², of the section across a tube's axis: as far as it is nearer to this axis than to those of siblings as
/// thick as it. Where the mesh has no surface of the tube, a limb leaves it, or it leaves a fork: there the
/// tube's own radius counts.
double WoodSections::area(std::size_t tube, double along) const
{
    const Place place = at(tube, along);
    Cut cut;
    cut.place = place;
    cut.u = glm::normalize(glm::cross(place.tangent, std::abs(place.tangent.y) < 0.8 ? glm::dvec3(0, 1, 0)
                                                                                     : glm::dvec3(1, 0, 0)));
    cut.v = glm::cross(place.tangent, cut.u);
    cut.reach.fill(mostReach * place.radius);
    cutThrough(tube, cut);
    const Tube& own = m_tubes[tube];
    if (!own.isLimb) {
        if (own.fork != none)
            cutThrough(own.fork, cut);
        for (const std::size_t other : siblings(tube))
            if (!m_tubes[other].isLimb)
                cutThrough(other, cut);
        for (const std::size_t other : own.children)
            if (!m_tubes[other].isLimb)
                cutThrough(other, cut);
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < rays; ++k) {
        double far = cut.reach[k] < mostReach * place.radius ? cut.reach[k] : place.radius;
        const auto [sine, cosine] = maths::sincos(fullTurn * double(k) / double(rays));
        if (!own.isLimb)
            far = std::min(far, ownReach(tube, along, place, cosine * cut.u + sine * cut.v));
        sum += far * far;
    }
    return 0.5 * sum * fullTurn / double(rays);
}

/// Brings the ends of the rays to where a tube's surface crosses the plane.
void WoodSections::cutThrough(std::size_t tube, Cut& cut) const
{
    const Index first = m_mesh.tubes[tube].firstTriangle;
    const Index end =
        tube + 1 < m_tubes.size() ? m_mesh.tubes[tube + 1].firstTriangle : m_mesh.mesh.faceCount();
    for (Index f = first; f < end; ++f) {
        std::array<glm::dvec3, 3> p;
        std::array<double, 3> height{};
        for (int c = 0; c < 3; ++c) {
            p[c] = glm::dvec3(m_mesh.mesh.positions[m_mesh.mesh.triangles[f][c]]) - cut.place.point;
            height[c] = glm::dot(p[c], cut.place.tangent);
        }
        if ((height[0] < 0.0) == (height[1] < 0.0) && (height[1] < 0.0) == (height[2] < 0.0))
            continue;
        std::array<glm::dvec2, 2> ends;
        int count = 0;
        for (int c = 0; c < 3 && count < 2; ++c) {
            const int d = (c + 1) % 3;
            if ((height[c] < 0.0) == (height[d] < 0.0))
                continue;
            const glm::dvec3 on = p[c] + (height[c] / (height[c] - height[d])) * (p[d] - p[c]);
            ends[count++] = {glm::dot(on, cut.u), glm::dot(on, cut.v)};
        }
        shorten(ends[0], ends[1], cut);
    }
}

/// The rays that meet a piece of the outline end there.
void WoodSections::shorten(glm::dvec2 start, glm::dvec2 end, Cut& cut)
{
    const double turn = start.x * end.y - start.y * end.x;
    if (turn == 0.0)
        return;
    if (turn < 0.0)
        std::swap(start, end);
    const double from = maths::atan2(start.y, start.x);
    double to = maths::atan2(end.y, end.x);
    to += to < from ? fullTurn : 0.0;
    const double step = fullTurn / double(rays);
    for (auto k = std::int64_t(std::ceil(from / step)); double(k) * step < to; ++k) {
        const auto [sine, cosine] = maths::sincos(double(k) * step);
        const glm::dvec2 edge = end - start;
        const double across = cosine * edge.y - sine * edge.x;
        if (across == 0.0)
            continue;
        double& least = cut.reach[std::size_t((k + 2 * std::int64_t(rays)) % std::int64_t(rays))];
        least = std::min(least, std::abs(turn) / std::abs(across));
    }
}

/// m, along a ray: as far as it is nearer to this axis than to those of siblings as thick as it.
double WoodSections::ownReach(std::size_t tube, double along, const Place& place, const glm::dvec3& way) const
{
    double far = std::numeric_limits<double>::max();
    for (const std::size_t other : siblings(tube)) {
        if (m_tubes[other].isLimb)
            continue;
        const Place beside = at(other, std::min(along, length(other)));
        const glm::dvec3 between = beside.point - place.point;
        const double towards = glm::dot(way, between);
        const double share = place.radius / (place.radius + beside.radius);
        if (towards > 0.0)
            far = std::min(far, share * glm::dot(between, between) / towards);
    }
    return far;
}

/// m, from the axis of one tube to the other's, so far from their fork.
double WoodSections::apart(std::size_t one, std::size_t other, double along) const
{
    const glm::dvec3 point = at(one, along).point;
    double least = 1e300;
    for (const glm::dvec3& p : m_tubes[other].points)
        least = std::min(least, glm::distance(p, point));
    return std::min(least, glm::distance(at(other, along).point, point));
}

/// m², of all wood that this place of a tube leads to. Branches thinner than \p thinnest (m), and limbs until
/// they are well out of the wood they leave, are as thick as their axes say.
double WoodSections::woodAt(std::size_t tube, double along, double thinnest) const
{
    const Tube& own = m_tubes[tube];
    if (own.isLimb && along < outOfStem * m_tubes[m_tubes[own.fork].stem].thickness)
        thinnest = std::numeric_limits<double>::max();
    if (along > length(tube) && !own.children.empty()) {
        double sum = 0.0;
        for (const std::size_t child : own.children)
            sum += woodAt(child, along - length(tube), thinnest);
        return sum;
    }
    if (own.thickness >= thinnest)
        return area(tube, std::min(along, length(tube)));
    const double radius = at(tube, along).radius;
    return pi * radius * radius;
}

/// The tube and those of its siblings that are not yet clear of it here.
std::vector<std::size_t> WoodSections::together(std::size_t tube, double along) const
{
    std::vector<std::size_t> out{tube};
    for (const std::size_t other : siblings(tube)) {
        const Place here = at(tube, along), there = at(other, along);
        if (m_tubes[other].isLimb || m_tubes[tube].isLimb
                ? along < outOfStem * here.radius
                : glm::distance(here.point, there.point) < wide * (here.radius + there.radius))
            out.push_back(other);
    }
    return out;
}

/// Does the trunk fork so far from here, or little below, and go on?
bool WoodSections::hasForkWithin(std::size_t tube, double along, double reach) const
{
    bool forks = !siblings(tube).empty() && along < reach;
    double end = along + reach;
    while (end > length(tube)) {
        if (m_tubes[tube].stem == none)
            return false;
        forks = forks || m_tubes[tube].children.size() > 1;
        end -= length(tube);
        tube = m_tubes[tube].stem;
    }
    return forks;
}

WoodLoss WoodSections::lossUpTheTrunk(double thinnest) const
{
    WoodLoss out;
    for (const std::size_t root : m_roots) {
        const double first = at(root, length(root)).radius;
        double below = 0.0; // m, along the trunk
        for (std::size_t tube = root; tube != none; below += length(tube), tube = m_tubes[tube].stem) {
            if (m_tubes[tube].thickness < thinnest * first)
                break;
            double from = 0.02 * m_tubes[tube].thickness;
            if (tube == root)
                from = std::min(length(root), 5.0 * first);
            for (double along = from; along < length(tube);) {
                const double diameter = 2.0 * at(tube, along).radius, thin = 0.05 * diameter;
                const double here = along;
                along += 0.125 * diameter;
                if (!hasForkWithin(tube, here, diameter))
                    continue;
                double before = 0.0, quarter = 0.0, whole = 0.0;
                for (const std::size_t each : together(tube, here)) {
                    before += woodAt(each, here, thin);
                    quarter += woodAt(each, here + 0.25 * diameter, thin);
                    whole += woodAt(each, here + diameter, thin);
                }
                if (1.0 - quarter / before > out.quarter)
                    out.quarter = 1.0 - quarter / before, out.quarterHeight = below + here;
                if (1.0 - whole / before > out.whole)
                    out.whole = 1.0 - whole / before, out.wholeHeight = below + here;
            }
        }
    }
    return out;
}

double WoodSections::meanRadius(std::size_t tube, double along) const
{
    while (along > length(tube) && m_tubes[tube].stem != none) {
        along -= length(tube);
        tube = m_tubes[tube].stem;
    }
    return std::sqrt(area(tube, std::min(along, length(tube))) / pi);
}

std::vector<Swelling> WoodSections::swellings(double thinnest) const
{
    std::vector<Swelling> out;
    for (std::size_t tube = 0; tube < m_tubes.size(); ++tube) {
        const Tube& own = m_tubes[tube];
        if (own.fork == none || own.thickness < thinnest || siblings(tube).empty())
            continue;
        const std::size_t stem = m_tubes[own.fork].stem;
        const double share = own.thickness / m_tubes[stem].thickness;
        double start = -1.0;
        for (int k = 0; k <= steps && start < 0.0; ++k) {
            const double along = length(tube) * k / steps;
            if (own.isLimb ? apart(tube, stem, along) > m_tubes[stem].thickness
                           : together(tube, along).size() == 1)
                start = along;
        }
        const double diameter = 2.0 * own.thickness;
        if (start < 0.0 || start + 2.0 * diameter > length(tube))
            continue;
        out.push_back({m_mesh.tubes[tube].branch, share,
                       meanRadius(tube, start + 0.5 * diameter) / meanRadius(tube, start + 2.0 * diameter)});
    }
    return out;
}

} // namespace ramure
