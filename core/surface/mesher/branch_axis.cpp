#include "core/surface/mesher/branch_axis.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

constexpr double overshootLimit = 1.5;
constexpr double onCollar = 0.6; ///< of the length within which a collar falls to 1/e

/// The Hermite curve's position alone, as a cubic in powers of t: the tables need many points and no
/// tangents.
struct Cubic
{
    glm::dvec3 c0, c1, c2, c3;

    explicit Cubic(const BranchCurve& curve)
        : c0(curve.h0)
        , c1(curve.v0)
        , c2(3.0 * (curve.h1 - curve.h0) - 2.0 * curve.v0 - curve.v1)
        , c3(2.0 * (curve.h0 - curve.h1) + curve.v0 + curve.v1)
    {
    }
    [[nodiscard]] glm::dvec3 at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
};

/// Sections are spread evenly, but along a limb with a collar: the first stands on the collar, and each is so
/// many times as far from the stem as the one before. \param part k of the spans
double sectionAt(const MeshBranch& branch, double part, int spans)
{
    if (branch.spreadStart <= 0.0 || part <= 0.0 || part >= 1.0)
        return part;
    const double even = 1.0 / spans, length = 1.0 - branch.spreadStart;
    const double first = onCollar / std::max(branch.spreadDecay * length, 1e-12);
    return first >= even ? part
                         : branch.spreadStart + length * maths::pow(first, (1.0 - part) / (1.0 - even));
}

} // namespace

BranchCurve meshCurve(const NormalSkeleton& skeleton, Index branch, bool clampOvershoot)
{
    const MeshBranch& own = skeleton.branches[branch];
    BranchCurve curve{own.p0, own.p1, own.p1 - own.p0, own.p1 - own.p0};
    if (own.parent != noIndex && !own.isLimb && !own.isPiece) {
        const MeshBranch& parent = skeleton.branches[own.parent];
        Index whole = own.parent;
        while (skeleton.branches[whole].isPiece)
            whole = skeleton.branches[whole].parent;
        curve.v0 = parent.p1 - skeleton.branches[whole].p0;
        if (clampOvershoot || parent.isLimb) { // a limb is longer than what shows of it
            const double most = overshootLimit * glm::length(curve.v1);
            const double has = glm::length(curve.v0);
            if (has > most)
                curve.v0 *= most / has;
        }
    }
    return curve;
}

void AxisTable::build(const std::vector<glm::dvec3>& points, const std::vector<double>& distances,
                      const MeshBranch& branch)
{
    const std::size_t last = points.size() - 1;
    m_length = distances[last];
    m_stepsPerMetre = m_length > 0.0 ? steps / m_length : 0.0;
    std::size_t at = 0;
    for (int i = 0; i <= steps; ++i) {
        const auto step = static_cast<std::size_t>(i);
        const double wanted = i == steps ? m_length : m_length * i / steps;
        while (at + 1 < last && distances[at + 1] < wanted)
            ++at;
        const double span = distances[at + 1] - distances[at];
        const double part = span > 0.0 ? std::min((wanted - distances[at]) / span, 1.0) : 0.0;
        m_places[step].point = points[at] + (points[at + 1] - points[at]) * part;
        const double t = (static_cast<double>(at) + part) / static_cast<double>(last);
        m_places[step].radius = branch.radiusAt(t);
    }
    for (std::size_t i = 0; i <= steps; ++i) {
        const glm::dvec3 way =
            m_places[std::min<std::size_t>(i + 1, steps)].point - m_places[i > 0 ? i - 1 : 0].point;
        const double square = glm::dot(way, way);
        m_places[i].tangent = square > 0.0 ? way * (1.0 / std::sqrt(square))
                                           : (i > 0 ? m_places[i - 1].tangent : glm::dvec3(0.0, 1.0, 0.0));
    }
}

void AxisBuilder::build(const BranchCurve& curve, const MeshBranch& branch, const Frame& start,
                        int lengthDivisions, std::vector<AxisSection>& sections, AxisTable* table)
{
    const int spans = lengthDivisions - 1;
    sections.resize(static_cast<std::size_t>(lengthDivisions));
    Frame frame = start;
    if (branch.rollRad != 0.0)
        frame = rolled(frame, branch.rollRad);
    for (int k = 0; k <= spans; ++k) {
        AxisSection& section = sections[static_cast<std::size_t>(k)];
        section.t = sectionAt(branch, static_cast<double>(k) / spans, spans);
        const CurvePoint at = hermite(curve.h0, curve.h1, curve.v0, curve.v1, section.t);
        section.centre = at.point;
        section.frame = frame = transported(frame, at.tangent);
        section.radius = branch.radiusAt(section.t);
        section.along = k == 0 ? 0.0
                               : sections[static_cast<std::size_t>(k - 1)].along +
                                     glm::length(at.point - sections[static_cast<std::size_t>(k - 1)].centre);
    }
    if (!table)
        return;

    const int perSpan = std::max(1, (AxisTable::steps + spans - 1) / spans);
    const auto count = static_cast<std::size_t>(perSpan * spans);
    m_points.resize(count + 1);
    m_distances.resize(count + 1);
    const Cubic cubic(curve);
    m_points[0] = curve.h0;
    m_distances[0] = 0.0;
    for (std::size_t i = 1; i <= count; ++i) {
        m_points[i] = i == count ? curve.h1 : cubic.at(static_cast<double>(i) / static_cast<double>(count));
        m_distances[i] = m_distances[i - 1] + glm::length(m_points[i] - m_points[i - 1]);
    }
    if (branch.spreadStart <= 0.0) // else it is straight: distances grow as t does
        for (int k = 0; k <= spans; ++k)
            sections[static_cast<std::size_t>(k)].along = m_distances[static_cast<std::size_t>(k * perSpan)];
    table->build(m_points, m_distances, branch);
}

} // namespace ramure
