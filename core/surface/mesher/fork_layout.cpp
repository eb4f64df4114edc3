#include "core/surface/mesher/fork_layout.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/math/ring.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double farthest = 12.7; ///< a child straight back has no stereographic place
constexpr int spreadRounds = 60;
// A stem and the limbs that leave it.
constexpr double mostLimb = 0.7;      ///< of the stem's radius
constexpr double stemCosine = 0.82;   ///< of the angle between the parent and the stem
constexpr double limbCosine = 0.94;   ///< of the angle between the stem and a limb, either way
constexpr double slantCosine = 0.985; ///< the same, where limbs may run along the stem
constexpr double limbWidth = 1.06;    ///< of its diameter, on the ring
constexpr double leastLimbGap = 0.15; ///< of the ring's pitch, at least, for a limb's foot
constexpr double roomOnRing = 1.1;    ///< of the width, from limb to limb
constexpr double flatCosine = -0.94;  ///< of the angle at a child that stands between two others

/// A direction's place in the plane of the fork: stereographic, so that circles of directions stay circles.
glm::dvec2 stereographic(const Frame& frame, const glm::dvec3& direction)
{
    const glm::dvec2 lateral(glm::dot(direction, frame.normal), glm::dot(direction, frame.binormal));
    const double across = glm::length(lateral);
    // The tangent of half the angle to the parent's direction.
    const double ahead = glm::dot(direction, frame.tangent);
    const double far = ahead > 0.0 ? across / (1.0 + ahead)
                                   : (1.0 - ahead < farthest * across ? (1.0 - ahead) / across : farthest);
    return across > 1e-12 ? lateral * (far / across) : glm::dvec2(far, 0.0);
}

double wrapped(double angle)
{
    return angle - fullTurn * std::floor(angle / fullTurn);
}

} // namespace

double ForkPlanner::gapAfter(std::size_t split) const
{
    return split + 1 < m_splits.size() ? m_splits[split + 1] - m_splits[split]
                                       : m_splits[0] + fullTurn - m_splits[split];
}

double ForkPlanner::narrowestGap() const
{
    double least = fullTurn;
    for (std::size_t i = 0; i < m_splits.size(); ++i)
        least = std::min(least, gapAfter(i));
    return least;
}

/// Pushes the split points apart until neighbours are at least \p gap from each other; where that does not
/// come about, they are spaced evenly.
void ForkPlanner::spread(double gap)
{
    const std::size_t count = m_splits.size();
    for (int round = 0; round < spreadRounds && narrowestGap() < 0.999 * gap; ++round)
        for (std::size_t i = 0; i < count; ++i) {
            const double lack = gap - gapAfter(i);
            if (lack <= 0.0)
                continue;
            m_splits[i] -= 0.5 * lack;
            m_splits[i + 1 < count ? i + 1 : 0] += 0.5 * lack;
        }
    if (narrowestGap() >= 0.3 * gap)
        return;
    double shift = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        shift += m_splits[i] - fullTurn * static_cast<double>(i) / static_cast<double>(count);
    shift /= static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i)
        m_splits[i] = shift + fullTurn * static_cast<double>(i) / static_cast<double>(count);
}

static RingPoint ringPoint(double azimuth)
{
    const auto [sine, cosine] = maths::sincos(azimuth);
    return {azimuth, {cosine, sine}};
}

/// Adds the regular points of the ring that are not too near to a split point.
void ForkPlanner::fillRing(std::span<const RingPoint> regular, ForkLayout& layout)
{
    const double pitch = fullTurn / static_cast<double>(regular.size());
    const double keepOff = 0.42 * pitch;
    const std::size_t count = m_splits.size();
    const auto add = [&](double azimuth) { layout.ring.push_back(ringPoint(azimuth)); };
    layout.ring.clear();
    layout.splitPoint.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const double from = m_splits[i];
        const double to = i + 1 < count ? m_splits[i + 1] : m_splits[0] + fullTurn;
        layout.splitPoint.push_back(static_cast<Index>(layout.ring.size()));
        add(from);
        const auto last = static_cast<std::int64_t>(regular.size());
        for (auto k = static_cast<std::int64_t>(std::ceil((from + keepOff) / pitch));
             static_cast<double>(k) * pitch < to - keepOff; ++k)
            layout.ring.push_back({static_cast<double>(k) * pitch,
                                   regular[static_cast<std::size_t>((k % last + last) % last)].direction});
    }
    while (layout.ring.size() < 3) { // two split points and no room beside them: halve the wider side
        const double first = layout.ring[0].azimuth, second = layout.ring[1].azimuth;
        if (second - first >= pi) {
            add(second);
            const double middle = 0.5 * (first + second);
            layout.ring[1] = ringPoint(middle);
            layout.splitPoint[1] = 2;
        } else {
            add(0.5 * (second + first + fullTurn));
        }
    }
}

void ForkPlanner::addChild(const Frame& frame, const glm::dvec3& direction)
{
    m_sites.push_back(stereographic(frame, direction));
}

void ForkPlanner::addChild(const Frame& frame, const glm::dvec3& direction, const glm::dvec3& chord,
                           double radius)
{
    addChild(frame, direction);
    m_limbs.push_back(
        {{glm::dot(chord, frame.normal), glm::dot(chord, frame.binormal), glm::dot(chord, frame.tangent)},
         radius});
}

/// Half the angle that a limb takes of the ring.
static double halfWidth(double radius)
{
    return maths::asin(std::min(0.98, limbWidth * radius));
}

static double azimuthOf(const glm::dvec3& chord)
{
    return wrapped(maths::atan2(chord.y, chord.x));
}

/// The thickest child, where it goes straight on and all others are thin beside it, leave it to the side and
/// have room on the ring beside each other.
Index ForkPlanner::findStem() const
{
    Index stem = 0;
    for (Index i = 1; i < m_limbs.size(); ++i)
        if (m_limbs[i].radius > m_limbs[stem].radius)
            stem = i;
    if (m_limbs.empty() || m_limbs[stem].radius < leastStem || m_limbs[stem].chord.z < stemCosine)
        return noIndex;
    std::vector<std::pair<double, double>> taken; // azimuth, half the width
    for (Index i = 0; i < m_limbs.size(); ++i) {
        const Limb& limb = m_limbs[i];
        if (i == stem)
            continue;
        if (limb.radius > mostLimb * m_limbs[stem].radius ||
            std::abs(glm::dot(limb.chord, m_limbs[stem].chord)) > (m_maySlant ? slantCosine : limbCosine))
            return noIndex;
        taken.emplace_back(azimuthOf(limb.chord), halfWidth(limb.radius));
    }
    std::ranges::sort(taken);
    for (std::size_t i = 0; i < taken.size(); ++i) {
        const auto& [azimuth, half] = taken[i];
        const auto& [next, nextHalf] = taken[i + 1 < taken.size() ? i + 1 : 0];
        if (const double way = next - azimuth + (i + 1 < taken.size() ? 0.0 : fullTurn);
            way < roomOnRing * (half + nextHalf))
            return noIndex;
    }
    return stem;
}

/// Every limb between its own two points of the ring.
void ForkPlanner::planStar(ForkLayout& layout)
{
    std::vector<glm::dvec2> ways;
    for (const Limb& limb : m_limbs)
        ways.push_back(glm::dvec2(limb.chord) / std::max(glm::length(glm::dvec2(limb.chord)), 1e-9));
    layout.triangulation.buildStar(ways, layout.stem);
    m_splits.clear();
    for (const ForkTriangulation::HullEdge& edge : layout.triangulation.hull()) {
        const bool begins = edge.from == layout.stem;
        const Limb& limb = m_limbs[begins ? edge.to : edge.from];
        const double half = halfWidth(limb.radius), azimuth = azimuthOf(limb.chord);
        m_splits.push_back(begins ? azimuth - half : azimuth + half);
    }
}

/// A point of the ring for every edge of the hull, where it looks.
void ForkPlanner::splitHull(const ForkTriangulation& triangulation)
{
    m_splits.clear();
    for (const ForkTriangulation::HullEdge& edge : triangulation.hull()) {
        const glm::dvec2 along = triangulation.place(edge.to) - triangulation.place(edge.from);
        double azimuth = wrapped(maths::atan2(-along.x, along.y)); // of the outward normal (y, -x)
        // The hull is nearly convex: its normals turn one way, once around, but for small steps back.
        if (!m_splits.empty()) {
            const double step = wrapped(azimuth - m_splits.back());
            azimuth = m_splits.back() + (step > 1.3 * pi ? step - fullTurn : step);
        }
        m_splits.push_back(azimuth);
    }
}

void ForkPlanner::plan(std::span<const RingPoint> regular, ForkLayout& layout)
{
    layout.stem = findStem();
    if (layout.stem != noIndex) {
        planStar(layout);
    } else {
        layout.triangulation.build(m_sites);
        layout.triangulation.openFlatSides(flatCosine);
        splitHull(layout.triangulation);
    }
    const auto edges = static_cast<double>(layout.triangulation.hull().size());
    double gap = std::min(pi / static_cast<double>(regular.size()), 0.8 * fullTurn / edges);
    if (layout.stem != noIndex) // the foot of a limb is as wide as the limb
        gap = std::clamp(narrowestGap(), leastLimbGap * gap, gap);
    spread(gap);
    fillRing(regular, layout);
}

std::vector<RingPoint> regularRing(int count)
{
    std::vector<RingPoint> ring;
    for (int k = 0; k < count; ++k)
        ring.push_back({fullTurn * k / count, ringDirection(k, count)});
    return ring;
}

} // namespace ramure
