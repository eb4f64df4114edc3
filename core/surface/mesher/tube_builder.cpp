#include "core/surface/mesher/tube_builder.h"

#include "core/math/angle.h"
#include "core/math/hermite.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {

namespace {

constexpr double cutRing = 0.88;    ///< radius of the ring on a cut, of the branch's
constexpr double leastTorn = 0.004; ///< m: thinner wood breaks without splinters
constexpr double tipHeight = 0.35;  ///< of the radius: how far a tip is rounded beyond the branch's end
constexpr double siteShare =
    0.4; ///< of the shortest child: where the children's neighbourhoods are looked at
constexpr double roomBeforeEnd = 0.25; ///< of the radius, between a section and the end
constexpr double roomBetween = 0.02;   ///< of the radius, between two sections

/// Would the rings of two sections, the second further on, cut through each other?
bool ringsCross(const AxisSection& first, const AxisSection& second)
{
    const glm::dvec3 way = second.centre - first.centre;
    const glm::dvec3 axis = glm::cross(first.frame.tangent, second.frame.tangent);
    const double bend = std::sqrt(glm::dot(axis, axis));
    return glm::dot(way, first.frame.tangent) < second.radius * bend ||
           glm::dot(way, second.frame.tangent) < first.radius * bend;
}

} // namespace

glm::dvec3 ringPosition(const AxisSection& section, const RingPoint& point)
{
    return section.centre + (section.radius * point.direction.x) * section.frame.normal +
           (section.radius * point.direction.y) * section.frame.binormal;
}

Index addRing(const AxisSection& section, std::span<const RingPoint> points, Index owner, MeshSink& sink)
{
    const Index first = sink.nextVertex();
    glm::vec3* out = sink.addVertices(points.size(), owner);
    const glm::dvec3 u = section.radius * section.frame.normal, v = section.radius * section.frame.binormal;
    for (const RingPoint& point : points)
        *out++ = glm::vec3(section.centre + point.direction.x * u + point.direction.y * v);
    return first;
}

bool keepsSection(const std::vector<AxisSection>& sections, std::size_t last, std::size_t k, double leastGap)
{
    if (k + 1 >= sections.size())
        return true;
    const AxisSection &section = sections[k], &end = sections.back();
    return end.along - section.along >= std::max(roomBeforeEnd * section.radius, leastGap) &&
           section.along - sections[last].along >= std::max(roomBetween * section.radius, leastGap) &&
           !ringsCross(sections[last], section) && !ringsCross(section, end);
}

double twistBetween(const AxisSection& first, const AxisSection& second)
{
    const Frame carried = transported(first.frame, second.frame.tangent);
    return maths::atan2(glm::dot(second.frame.normal, carried.binormal),
                        glm::dot(second.frame.normal, carried.normal));
}

/// The tubes' neighbourhoods are those they have part of the way up the shortest of them: a long child bends
/// away from its parent's direction later than a short one.
void planFork(const MesherContext& context, Index branch, const AxisSection& end, ForkPlanner& planner,
              ForkLayout& layout)
{
    double shortest = std::numeric_limits<double>::max(), thickest = 0.0;
    int stems = 0;
    for (const Index child : context.skeleton.childrenOf(branch)) {
        const MeshBranch& c = context.skeleton.branches[child];
        shortest = std::min(shortest, glm::length(c.p1 - c.p0));
        thickest = std::max(thickest, c.a0);
        stems += c.isLimb ? 0 : 1;
    }
    planner.begin(context.options.forkLength > 0.0 && thickest >= leastStem * end.radius);
    for (const Index child : context.skeleton.childrenOf(branch)) {
        const MeshBranch& c = context.skeleton.branches[child];
        const BranchCurve curve = meshCurve(context.skeleton, child, context.clampOvershoot);
        const double t = siteShare * shortest / glm::length(c.p1 - c.p0);
        const glm::dvec3 way = hermite(curve.h0, curve.h1, curve.v0, curve.v1, t).point - c.p0;
        const double length = glm::length(way);
        const glm::dvec3 chord = glm::normalize(c.p1 - c.p0);
        planner.addChild(end.frame, length > 1e-6 * shortest ? way / length : chord, chord,
                         (c.isLimb || stems > 1 ? c.a0 : c.radiusAt(0.0)) / end.radius);
    }
    planner.plan(context.divisions.ring(branch, end.radius), layout);
}

std::span<const RingPoint> TubeBuilder::endRing(Index branch, const AxisSection& end)
{
    if (m_context.skeleton.branches[branch].childCount < 2)
        return m_context.divisions.ring(branch, end.radius);
    planFork(m_context, branch, end, m_planner, m_layout);
    return m_layout.ring;
}

/// Two regular rings whose points face each other.
void TubeBuilder::evenStrip(Index lower, Index upper, Index n)
{
    glm::uvec3* out = m_context.sink.addTriangles(2 * std::size_t(n));
    for (Index k = 0; k + 1 < n; ++k) {
        *out++ = {lower + k, lower + k + 1, upper + k};
        *out++ = {lower + k + 1, upper + k + 1, upper + k};
    }
    *out++ = {lower + n - 1, lower, upper + n - 1};
    *out = {lower, upper, upper + n - 1};
}

/// A regular ring, turned, and any other: the next triangle takes the row whose diagonal spans less of the
/// azimuth. No row can advance all around in one go, which would make edges twice: neither has a gap of more
/// than half a turn that the other's points could all lie in.
void TubeBuilder::looseStrip(const TubeStart& lower, std::span<const RingPoint> upperPoints, Index upper)
{
    const auto n = static_cast<Index>(lower.points.size()), m = static_cast<Index>(upperPoints.size());
    const double first = lower.points[0].azimuth + lower.turned;
    const auto away = [&](Index j) {
        const double d = upperPoints[j].azimuth - first;
        return d - fullTurn * std::round(d / fullTurn);
    };
    Index start = 0;
    for (Index j = 1; j < m; ++j)
        if (std::abs(away(j)) < std::abs(away(start)))
            start = j;
    glm::uvec3* out = m_context.sink.addTriangles(std::size_t(n) + m);
    Index i = 0, j = start, taken = 0;
    double a = 0.0, u = away(start), shift = u - upperPoints[start].azimuth;
    while (i < n || taken < m) {
        const Index nextI = i + 1 < n ? i + 1 : 0, nextJ = j + 1 < m ? j + 1 : 0;
        const double b = i + 1 < n ? lower.points[nextI].azimuth : fullTurn;
        const double v = upperPoints[nextJ].azimuth + shift + (nextJ == 0 ? fullTurn : 0.0);
        const bool advanceLower = i < n && (taken == m || std::abs(b - u) < std::abs(v - a));
        const Index l = lower.ring + (i < n ? i : 0);
        if (advanceLower) {
            *out++ = {l, lower.ring + nextI, upper + j};
            a = b;
            ++i;
        } else {
            *out++ = {l, upper + nextJ, upper + j};
            u = v;
            if (nextJ == 0)
                shift += fullTurn;
            j = nextJ;
            ++taken;
        }
    }
}

Index TubeBuilder::startRoot(const AxisSection& section, std::span<const RingPoint> points,
                             const glm::dvec3& pole, Index owner)
{
    MeshSink& sink = m_context.sink;
    const Index centre = sink.addVertex(pole, owner);
    const Index ring = addRing(section, points, owner, sink);
    const auto count = static_cast<Index>(points.size());
    for (Index k = 0; k < count; ++k)
        sink.addTriangle(ring + (k + 1 < count ? k + 1 : 0), ring + k, centre);
    return ring;
}

Index TubeBuilder::startFoot(const TrunkFoot& foot, const Frame& frame, Index owner)
{
    MeshSink& sink = m_context.sink;
    const Index pole = sink.addVertex(foot.pole(), owner);
    const Index rings = foot.size().rings, points = foot.size().points, perRoot = foot.pointsOfRoot();
    for (Index ring = 0; ring < rings; ++ring) {
        const Index first = sink.nextVertex();
        for (Index column = 0; column < points; ++column)
            sink.addVertex(foot.at(ring, column, frame), owner);
        for (Index column = 0; ring > 0 && column < points; ++column) {
            // Diagonals go up from the valleys to the crests: the others would bridge the valleys.
            const Index next = column + 1 < points ? column + 1 : 0, a = first - points + column;
            const Index b = first - points + next, c = first + next, d = first + column;
            const bool toCrest = (column + 1) % perRoot < perRoot / 2;
            sink.addTriangle(a, b, toCrest ? c : d);
            sink.addTriangle(toCrest ? a : b, c, d);
        }
    }
    closeFoot(foot, pole);
    return sink.nextVertex() - points;
}

/// Each root has a sole of its own, from its crest back to the valleys beside it: roots that turn aside would
/// fold one fan around the pole.
void TubeBuilder::closeFoot(const TrunkFoot& foot, Index pole)
{
    MeshSink& sink = m_context.sink;
    const Index first = pole + 1, points = foot.size().points, perRoot = foot.pointsOfRoot();
    const Index pairs = (perRoot - 2) / 2;
    for (Index begin = 0; begin < points; begin += perRoot) {
        const Index crest = first + begin + pairs;
        sink.addTriangle(crest + 1, crest, begin == 0 && pairs == 0 ? first + points - 1 : crest - 1);
        for (Index i = 1; i <= pairs; ++i) {
            const bool atValley = i == pairs && begin == 0;
            const Index before = atValley ? first + points - 1 : crest - i - 1;
            sink.addTriangle(crest + i + 1, crest + i, crest - i);
            sink.addTriangle(crest + i + 1, crest - i, before);
        }
        const Index valley = first + begin + perRoot - 1;
        sink.addTriangle(valley, begin == 0 ? first + points - 1 : first + begin - 1, pole);
    }
}

void TubeBuilder::end(Index branch, const AxisSection& section, Index ring, std::size_t points,
                      std::vector<TubeEnd>& ends)
{
    const MeshBranch& own = m_context.skeleton.branches[branch];
    const auto count = static_cast<Index>(points);
    if (own.childCount > 0) {
        ends.push_back({branch, ring, count, section});
        return;
    }
    if (own.torn != 0 && section.radius >= leastTorn && m_context.options.splinters > 0.0)
        return closeTorn(section, ring, count, own);
    if (own.isSawn)
        return closeCut(section, ring, count, own.source);
    MeshSink& sink = m_context.sink;
    const Index pole =
        sink.addVertex(section.centre + tipHeight * section.radius * section.frame.tangent, own.source);
    for (Index k = 0; k < count; ++k)
        sink.addTriangle(ring + k, ring + (k + 1 < count ? k + 1 : 0), pole);
}

/// Flat, with a ring of its own inside the edge.
void TubeBuilder::closeCut(const AxisSection& section, Index ring, Index count, Index owner)
{
    MeshSink& sink = m_context.sink;
    const Index inner = sink.nextVertex();
    for (Index k = 0; k < count; ++k)
        sink.addVertex(section.centre + cutRing * (glm::dvec3(sink.positions[ring + k]) - section.centre),
                       owner);
    evenStrip(ring, inner, count);
    const Index pole = sink.addVertex(section.centre, owner);
    for (Index k = 0; k < count; ++k)
        sink.addTriangle(inner + k, inner + (k + 1 < count ? k + 1 : 0), pole);
}

/// Broken: splinters around a hollow, longest on the side that tore last. Above the end's disc every place
/// has one height, so that the wood cannot cross itself.
void TubeBuilder::closeTorn(const AxisSection& section, Index ring, Index count, const MeshBranch& own)
{
    constexpr double rim = 0.96, inner = 0.55, least = 0.12; // of the radius; of the splinters' length
    MeshSink& sink = m_context.sink;
    Random chance(m_context.options.seed, RandomStream::Splinters, own.torn);
    const double longest = 2.0 * section.radius * m_context.options.splinters;
    const double side = chance.range(0.0, fullTurn);
    const Index points = 2 * count, edge = sink.nextVertex();
    const auto base = [&](Index k) { // on the ring, or between two of its points
        const glm::dvec3 a(sink.positions[ring + k / 2]), b(sink.positions[ring + (k / 2 + k % 2) % count]);
        return 0.5 * (a + b) - section.centre;
    };
    std::vector<double> heights(points);
    for (Index k = 0; k < points; ++k) {
        const double tear = 0.5 + 0.5 * maths::cos(fullTurn * k / points - side);
        const double splinter = k % 2 == 0 ? chance.range(0.1, 0.4) : chance.range(0.4, 1.0);
        heights[k] = longest * (least + (1.0 - least) * splinter * (0.3 + 0.7 * tear * tear));
    }
    for (Index k = 0; k < points; ++k)
        sink.addVertex(section.centre + rim * base(k) + heights[k] * section.frame.tangent, own.source);
    for (Index k = 0; k < count; ++k) {
        const Index next = k + 1 < count ? k + 1 : 0, a = edge + 2 * k, b = a + 1, c = edge + 2 * next;
        sink.addTriangle(ring + k, b, a);
        sink.addTriangle(ring + k, ring + next, b);
        sink.addTriangle(ring + next, c, b);
    }
    const Index within = sink.nextVertex();
    for (Index k = 0; k < points; ++k) {
        const double low =
            std::min({heights[k], heights[(k + 1) % points], heights[(k + points - 1) % points]});
        sink.addVertex(section.centre + inner * base(k) +
                           chance.range(0.2, 1.0) * low * section.frame.tangent,
                       own.source);
    }
    evenStrip(edge, within, points);
    const Index pole = sink.addVertex(
        section.centre + chance.range(0.1, 0.5) * least * longest * section.frame.tangent, own.source);
    for (Index k = 0; k < points; ++k)
        sink.addTriangle(within + k, within + (k + 1 < points ? k + 1 : 0), pole);
}

void TubeBuilder::finish(Index branch, const std::vector<AxisSection>& sections, std::size_t from,
                         const TubeStart& start, std::vector<TubeEnd>& ends)
{
    const MeshBranch& own = m_context.skeleton.branches[branch];
    const std::size_t last = sections.size() - 1;
    std::size_t below = from;
    TubeStart at = start;
    for (std::size_t k = from + 1; k <= last; ++k) {
        if (!keepsSection(sections, below, k, m_context.skeleton.leastGap))
            continue;
        below = k;
        const std::span<const RingPoint> regular = m_context.divisions.ring(branch, sections[k].radius);
        const std::span<const RingPoint> points = k == last ? endRing(branch, sections[k]) : regular;
        const Index next = addRing(sections[k], points, own.source, m_context.sink);
        if (at.turned != 0.0 || points.data() != at.points.data())
            looseStrip(at, points, next);
        else
            evenStrip(at.ring, next, static_cast<Index>(points.size()));
        at = {next, points};
    }
    end(branch, sections[last], at.ring, at.points.size(), ends);
}

} // namespace ramure
