#include "core/surface/mesher/trunk_foot.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr std::int64_t fewestRoots = 3;
constexpr double mostOfTrunk = 0.7;  ///< the foot's share of the trunk's first branch
constexpr double steepest = 0.5;     ///< the least rise of a trunk that stands
constexpr double sunkShare = 0.06;   ///< of the foot's height
constexpr double lowest = 0.35;      ///< of what is sunk: what is left of it at the last ring but one
constexpr double skirt = 0.5;        ///< of the radius: how deep the foot ends under the ground
constexpr double valleyFlare = 0.12; ///< how much wider the trunk is at the ground between roots
constexpr double narrowing = 1.35;   ///< power of the distance by which roots get narrower
constexpr double sideSpacing = 0.75; ///< power that brings columns from the crest to the long flanks
constexpr double roundness = 2.0;    ///< power that makes crests round
constexpr double jitter = 0.2;       ///< of the angle between roots
constexpr double mostWander = 0.2;   ///< the same: roots never meet
constexpr double leastShare = 0.55;  ///< of the length and the height: the shortest and the lowest root

} // namespace

FootSize footSize(const MeshParams& params, Index sides)
{
    if (params.roots <= 0)
        return {};
    const auto roots = static_cast<Index>(std::max(params.roots, fewestRoots));
    const Index pairs = std::clamp<Index>((4 * sides / (5 * roots)), 0, 12);
    return {std::clamp<Index>(sides / 2, 4, 16), roots * (2 * pairs + 2), roots};
}

TrunkFoot::TrunkFoot(const MeshBranch& trunk, const MeshParams& params, Index sides, std::uint64_t seed)
{
    const glm::dvec3 way = trunk.p1 - trunk.p0;
    const double length = glm::length(way);
    if (trunk.foot == noIndex || !(length > 0.0) || way.y < steepest * length)
        return;
    // The radius at the top of the foot, which is as high as the radius there says.
    double top = 0.0, radius = trunk.radiusAt(0.0);
    for (int round = 0; round < 4; ++round) {
        top = std::min(2.0 * params.rootHeight * radius / length, mostOfTrunk);
        radius = trunk.radiusAt(top);
    }
    m_size = footSize(params, sides);
    if (!(top > 0.0) || !(radius > 0.0) || !isThere())
        return;
    m_start = trunk.p0;
    m_way = way / length;
    m_top = top;
    m_height = top * length;
    m_radius = radius;
    m_sunk = sunkShare * m_height;
    placeRoots(params, seed);
    placeColumns();
}

void TrunkFoot::placeRoots(const MeshParams& params, std::uint64_t seed)
{
    const std::size_t count = m_size.roots;
    const double apart = fullTurn / static_cast<double>(count);
    m_roots.resize(count);
    Random turn(seed, RandomStream::Roots);
    const double first = turn.range(0.0, fullTurn);
    for (std::size_t k = 0; k < count; ++k) {
        Random random(seed, RandomStream::Roots, k + 1);
        Root& root = m_roots[k];
        root.azimuth = first + apart * (static_cast<double>(k) + random.range(-jitter, jitter));
        root.height = m_height * random.range(leastShare, 1.0);
        const double length = 2.0 * m_radius * params.rootLength * random.range(leastShare, 1.0 / leastShare);
        root.decay = length / maths::log((root.height + m_sunk) / m_sunk);
        root.wander = apart * random.range(-mostWander, mostWander);
        root.wanderLag = length * random.range(0.4, 0.8);
    }
    for (std::size_t k = 0; k < count; ++k) {
        const double next = m_roots[(k + 1) % count].azimuth + (k + 1 == count ? fullTurn : 0.0);
        m_roots[k].after = m_roots[(k + 1) % count].before = 0.5 * (next - m_roots[k].azimuth);
    }
}

/// Each root has its crest, pairs of columns beside it, and the valley after it.
void TrunkFoot::placeColumns()
{
    const Index perRoot = pointsOfRoot(), pairs = (perRoot - 2) / 2;
    for (Index k = 0; k < m_roots.size(); ++k) {
        const Root& root = m_roots[k];
        for (Index i = 0; i < perRoot; ++i) {
            const double even = (static_cast<double>(i) - pairs) / (pairs + 1.0);
            const double side = std::copysign(maths::pow(std::abs(even), sideSpacing), even);
            const double azimuth = root.azimuth + side * (side < 0.0 ? root.before : root.after);
            m_columnOf.push_back({k, side});
            m_turned = m_columns.empty() ? azimuth : m_turned;
            m_columns.push_back({azimuth - m_turned, {maths::cos(azimuth), maths::sin(azimuth)}});
        }
    }
}

/// m over the ground. Crests fall in equal shares, which makes them run out in equal steps; valleys fall in
/// equal steps.
double TrunkFoot::heightOf(Index ring, double beside) const
{
    const double part = std::min(static_cast<double>(m_size.rings - 1 - ring) / (m_size.rings - 2), 1.0);
    const double whole = m_height + m_sunk, least = lowest * m_sunk / whole;
    const double onCrest = maths::pow(least, part), inValley = 1.0 + (least - 1.0) * part;
    return whole * (onCrest + (inValley - onCrest) * beside) - m_sunk;
}

/// m, how far from the trunk's surface the root's crest is at that height.
double TrunkFoot::crestOf(const Root& root, double height) const
{
    return root.decay * std::max(maths::log((root.height + m_sunk) / (height + m_sunk)), 0.0);
}

glm::dvec3 TrunkFoot::at(Index ring, Index column, const Frame& frame) const
{
    const Column& own = m_columnOf[column];
    const Root& root = m_roots[own.root];
    const double beside = std::abs(own.side), height = heightOf(ring, beside);
    const double below = std::clamp(1.0 - height / m_height, 0.0, 1.0);
    const double out = crestOf(root, height) * (1.0 - maths::pow(beside, roundness));
    const double trunk = m_radius * (1.0 + valleyFlare * below * below);
    const double spread = own.side < 0.0 ? root.before : root.after;
    const double narrow = maths::pow(m_radius / (m_radius + out), narrowing);
    const double turned = root.wander * out * out / (out * out + root.wanderLag * root.wanderLag);
    const double azimuth = root.azimuth + own.side * spread * narrow + turned;
    // Around the trunk rings lie across it at the top and level at the ground; roots are level everywhere.
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const Frame across = transported(frame, glm::normalize(m_way + (up - m_way) * below));
    const Frame level = transported(frame, up);
    const double x = maths::cos(azimuth), y = maths::sin(azimuth);
    const glm::dvec3 centre = ring == 0      ? pole()
                              : height < 0.0 ? m_start + glm::dvec3(0.0, height, 0.0)
                                             : m_start + height * m_way;
    return centre + trunk * (x * across.normal + y * across.binormal) +
           out * (x * level.normal + y * level.binormal);
}

glm::dvec3 TrunkFoot::pole() const
{
    return m_start - glm::dvec3(0.0, skirt * m_radius + m_sunk, 0.0);
}

void TrunkFoot::cutOff(std::vector<AxisSection>& sections) const
{
    const auto above =
        std::ranges::find_if(sections, [this](const AxisSection& section) { return section.t > m_top; });
    AxisSection top = sections.front(); // the first branch of a tree is straight
    top.t = m_top;
    top.centre = m_start + m_height * m_way;
    top.along = m_height;
    top.radius = m_radius;
    sections.erase(sections.begin(), above);
    sections.insert(sections.begin(), top);
}

} // namespace ramure
