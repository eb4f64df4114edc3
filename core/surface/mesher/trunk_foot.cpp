#include "core/surface/mesher/trunk_foot.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/params/steep_ground.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace ramure {

namespace {

constexpr std::int64_t fewestRoots = 3;
constexpr Index forkedSides = 14; ///< of a trunk whose roots fork
constexpr Index sidesOfPair = 8;  ///< of the trunk, for a pair of columns beside each crest
constexpr Index mostPairs = 6, mostPoints = 160;
constexpr double mostVertices = 1500.0;
constexpr double mostOfTrunk = 0.7;  ///< the foot's share of the trunk's first branch
constexpr double steepest = 0.5;     ///< the least rise of a trunk that stands
constexpr double sunkShare = 0.2;    ///< of the foot's height, or of the trunk's diameter if that is less
constexpr double lowest = 0.5;       ///< of what is sunk: what is left of it at the last ring but one
constexpr double skirt = 0.5;        ///< of the radius: how deep the foot ends under the ground
constexpr double valleyFlare = 0.25; ///< how much wider the trunk is at the ground between roots
constexpr double fallShare = 0.25;   ///< of a root's length, on which its crest comes down the trunk
constexpr double fallPower = 0.75;   ///< under 1, crests leave the trunk along it instead of at an angle
constexpr double ridgeShare = 0.35;  ///< of the trunk's radius: how high roots run over the ground
constexpr double divePower = 2.5;    ///< of the way, by which they sink
constexpr double sideSpacing = 0.75; ///< power that brings columns from the crest to the long flanks
constexpr double bluntness = 1.8;    ///< over 1, the ends of roots are rounder
constexpr double jitter = 0.25;      ///< of the angle between roots
constexpr double mostWander = 0.22;  ///< the same, less for longer ones: roots never meet
constexpr double leastHeight = 0.7;  ///< of the height: the lowest root
constexpr double leastLength = 0.65; ///< of the length: the shortest root, which is as rare as the longest
constexpr double liftRoom = 1.25; ///< of what the ground moves the trunk's foot by: height for it to fade out
constexpr double mostOffset = 2.0;  ///< of the radius: how far the ground may be from where the trunk begins
constexpr double liftShare = 0.5;   ///< of what a slope adds to the foot's height: for roots on all sides
constexpr double forkPlace = 0.45;  ///< across a root, the crests of its two tongues
constexpr double leastTongue = 0.6; ///< of the root's length

/// m from the trunk, of a place where the height of a crest is kept.
double crestPlace(double length, std::ptrdiff_t step)
{
    const double share = static_cast<double>(step) / TrunkFoot::crestSteps;
    return 2.0 * length * share * share;
}

double smooth(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// 1 on the crest of a tongue, 0 in the valley, level in both.
double profile(double beside)
{
    const double c = maths::cos(0.5 * pi * maths::pow(beside, bluntness));
    return c * c;
}

glm::dvec3 gradeOf(const GroundPlane& ground)
{
    const glm::dvec2 grade = eased(ground).grade;
    return {grade.x, 0.0, grade.y};
}

} // namespace

double footHeight(const MeshParams& params, double radius, const std::optional<GroundPlane>& ground,
                  const glm::dvec3& place)
{
    const double own = 2.0 * params.rootHeight * radius;
    if (!ground)
        return own;
    const double offset = std::min(std::abs(ground->above(place)), mostOffset * radius);
    return own + liftRoom * (radius * glm::length(gradeOf(*ground)) + offset);
}

/// As many vertices as the square of the sides asks for, however they divide into rings and columns: budgets
/// do not know steps. Half of the roots fork.
FootSize footSize(const MeshParams& params, Index sides)
{
    if (params.roots <= 0)
        return {};
    const auto roots = static_cast<Index>(std::max(params.roots, fewestRoots));
    const Index tongues = roots + (sides >= forkedSides ? roots / 2 : 0);
    const Index pairs = std::min({sides / sidesOfPair, mostPairs, mostPoints / (2 * tongues) - 1});
    const Index points = tongues * (2 * pairs + 2);
    const double vertices = std::min(0.8 * sides * sides, mostVertices);
    return {std::clamp<Index>(static_cast<Index>(std::lround(vertices / points)), 4, 16), points, tongues};
}

TrunkFoot::TrunkFoot(const MeshBranch& trunk, const MeshParams& params, Index sides, std::uint64_t seed,
                     const std::optional<GroundPlane>& ground)
{
    const glm::dvec3 way = trunk.p1 - trunk.p0;
    const double length = glm::length(way);
    if (trunk.foot == noIndex || !(length > 0.0) || way.y < steepest * length)
        return;
    // The radius at the top of the foot, which is as high as the radius there says.
    double top = 0.0, radius = trunk.radiusAt(0.0);
    for (int round = 0; round < 4; ++round) {
        top = std::min(footHeight(params, radius, ground, trunk.p0) / length, mostOfTrunk);
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
    m_sunk = sunkShare * std::min(m_height, 2.0 * m_radius);
    if (ground)
        standOn(*ground);
    placeRoots(params, seed);
    placeTongues(m_size.roots - static_cast<Index>(m_roots.size()), seed);
    placeColumns();
}

void TrunkFoot::standOn(const GroundPlane& ground)
{
    m_grade = gradeOf(ground);
    m_offset = std::clamp(-ground.above(m_start), -mostOffset * m_radius, mostOffset * m_radius);
    if (const double moved = m_radius * glm::length(m_grade) + std::abs(m_offset); moved > 0.0)
        m_follow = std::min(1.0, m_height / (liftRoom * moved));
}

void TrunkFoot::placeRoots(const MeshParams& params, std::uint64_t seed)
{
    const auto count = static_cast<std::size_t>(std::max(params.roots, fewestRoots));
    const double lifted = std::max(m_height - 2.0 * params.rootHeight * m_radius, 0.0);
    const double height = isLevel() ? m_height : m_height - (1.0 - liftShare) * lifted;
    const double apart = fullTurn / static_cast<double>(count);
    m_roots.resize(count);
    Random turn(seed, RandomStream::Roots);
    const double first = turn.range(0.0, fullTurn);
    for (std::size_t k = 0; k < count; ++k) {
        Random random(seed, RandomStream::Roots, k + 1);
        Root& root = m_roots[k];
        root.azimuth = first + apart * (static_cast<double>(k) + random.range(-jitter, jitter));
        root.height = height * random.range(leastHeight, 1.0);
        const double length =
            2.0 * m_radius * params.rootLength * maths::pow(leastLength, random.range(-1.0, 1.0));
        root.length = length;
        root.ridge = std::min(ridgeShare * m_radius, 0.5 * root.height) * random.range(0.7, 1.2);
        root.wander = apart * random.range(-mostWander, mostWander) / std::max(params.rootLength, 1.0);
        root.lag = length * random.range(0.3, 0.6);
        root.back = -root.wander * random.range(0.0, 1.6);
        root.backLag = length * random.range(0.8, 1.2);
        root.fork = length * random.range(0.25, 0.5);
        for (std::size_t step = 0; step <= crestSteps; ++step)
            root.crest[step] = crestHeight(root, crestPlace(length, std::ptrdiff_t(step)));
    }
    for (std::size_t k = 0; k < count; ++k) {
        const double next = m_roots[(k + 1) % count].azimuth + (k + 1 == count ? fullTurn : 0.0);
        m_roots[k].after = m_roots[(k + 1) % count].before = 0.5 * (next - m_roots[k].azimuth);
    }
}

/// The widest roots fork.
void TrunkFoot::placeTongues(Index forks, std::uint64_t seed)
{
    std::vector<Index> widest(m_roots.size());
    std::iota(widest.begin(), widest.end(), 0);
    const auto width = [&](Index k) { return m_roots[k].before + m_roots[k].after; };
    std::ranges::stable_sort(widest, [&](Index a, Index b) { return width(a) > width(b); });
    for (Index k = 0; k < m_roots.size(); ++k) {
        if (std::ranges::find(widest, k) - widest.begin() >= std::ptrdiff_t(forks)) {
            m_tongues.push_back({k, 0.0, -1.0, 1.0});
            continue;
        }
        Random random(seed, RandomStream::Roots, m_roots.size() + k + 1);
        const double shorter = random.range(leastTongue, 1.0);
        const bool isFirst = random.unit() < 0.5;
        m_tongues.push_back({k, -forkPlace, -1.0, 0.0, isFirst ? shorter : 1.0});
        m_tongues.push_back({k, forkPlace, 0.0, 1.0, isFirst ? 1.0 : shorter});
    }
}

/// Each tongue has its crest, pairs of columns beside it, and the valley after it.
void TrunkFoot::placeColumns()
{
    const Index perTongue = pointsOfRoot(), pairs = (perTongue - 2) / 2;
    for (Index k = 0; k < m_tongues.size(); ++k)
        for (Index i = 0; i < perTongue; ++i) {
            const double even = (static_cast<double>(i) - pairs) / (pairs + 1.0);
            const double beside = maths::pow(std::abs(even), sideSpacing);
            const Column column{k, std::copysign(beside, even), profile(beside)};
            const double azimuth = azimuthOf(column, 0.0);
            m_columnOf.push_back(column);
            m_turned = m_columns.empty() ? azimuth : m_turned;
            m_columns.push_back({azimuth - m_turned, {maths::cos(azimuth), maths::sin(azimuth)}});
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

/// m over the ground, of the root's crest so far from the trunk: it falls along the trunk, goes out as a low
/// ridge and dives.
double TrunkFoot::crestHeight(const Root& root, double out)
{
    const double away = out / root.length;
    return (root.height - root.ridge) * maths::exp(-maths::pow(away / fallShare, fallPower)) +
           root.ridge * (1.0 - maths::pow(away, divePower));
}

/// m, how far from the trunk's surface the root's crest is at that height.
double TrunkFoot::crestOf(const Root& root, double height)
{
    const auto below = std::ranges::lower_bound(root.crest, -height, {}, [](double at) { return -at; });
    if (below == root.crest.begin())
        return 0.0;
    const auto step = std::min<std::ptrdiff_t>(below - root.crest.begin(), crestSteps);
    const double before = root.crest[std::size_t(step - 1)], after = root.crest[std::size_t(step)];
    const double part = std::clamp((before - height) / (before - after), 0.0, 1.0);
    const double from = crestPlace(root.length, step - 1);
    return from + part * (crestPlace(root.length, step) - from);
}

/// m, how far from the trunk's surface the column is. The crotch of a fork follows the crest down to where
/// the tongues part; these begin on its flanks.
double TrunkFoot::outOf(const Column& column, double height) const
{
    const Tongue& tongue = m_tongues[column.tongue];
    const Root& root = m_roots[tongue.root];
    const double own = column.profile, crest = crestOf(root, height);
    if (tongue.crest == 0.0)
        return crest * own;
    const double over = crest / root.fork;
    const double crotch = crest * maths::pow(1.0 + over * over * over, -1.0 / 3.0);
    static const double flank = profile(forkPlace);
    const double parted = smooth(over - 0.5);
    const double tip = crest * (flank + (tongue.reach - flank) * parted);
    const bool toCrotch = column.side * tongue.crest < 0.0;
    const double valley = toCrotch ? crotch : 0.0;
    return valley + (tip - valley) * own;
}

/// Roots keep about their width, and those of a fork go straight away from the trunk.
double TrunkFoot::azimuthOf(const Column& column, double out) const
{
    const Tongue& tongue = m_tongues[column.tongue];
    const Root& root = m_roots[tongue.root];
    const auto offset = [&root](double across) { return across * (across < 0.0 ? root.before : root.after); };
    const double crest = offset(tongue.crest), beside = std::abs(column.side);
    const double valley = column.side < 0.0 ? tongue.from : tongue.to;
    const double far = out / (m_radius + root.fork);
    const double narrow = valley != 0.0  ? m_radius / (m_radius + out)
                          : beside < 1.0 ? maths::pow(1.0 + far * far * far, -1.0 / 3.0)
                                         : 1.0;
    const double square = out * out;
    const double turned = root.wander * square / (square + root.lag * root.lag) +
                          root.back * square / (square + root.backLag * root.backLag);
    return root.azimuth + crest + beside * (offset(valley) - crest) * narrow + turned;
}

glm::dvec3 TrunkFoot::at(Index ring, Index column, const Frame& frame) const
{
    const Column& own = m_columnOf[column];
    const double height = heightOf(ring, std::abs(own.side)), out = outOf(own, height);
    const double below = std::clamp(1.0 - height / m_height, 0.0, 1.0);
    const double trunk = m_radius * (1.0 + valleyFlare * below * below);
    const double azimuth = azimuthOf(own, out);
    // Around the trunk rings lie across it at the top and level at the ground; roots are level everywhere.
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const Frame across = transported(frame, glm::normalize(m_way + (up - m_way) * below));
    const Frame level = transported(frame, up);
    const double x = maths::cos(azimuth), y = maths::sin(azimuth);
    const glm::dvec3 centre = ring == 0      ? pole()
                              : height < 0.0 ? m_start + glm::dvec3(0.0, height, 0.0)
                                             : m_start + height * m_way;
    const glm::dvec3 around = x * across.normal + y * across.binormal;
    const glm::dvec3 away = x * level.normal + y * level.binormal;
    if (isLevel())
        return centre + trunk * around + out * away;
    // What leaves the trunk is as long along the ground as on a level one, and moves with it. The trunk's own
    // surface moves along the trunk, less and less further up: so nothing folds.
    const double rise = glm::dot(m_grade, away), reach = out / std::sqrt(1.0 + rise * rise);
    const double ofTrunk = m_follow * below * (m_offset + m_radius * glm::dot(m_grade, around));
    const double moved = ofTrunk + (trunk - m_radius) * glm::dot(m_grade, around) + reach * rise;
    const glm::dvec3 along = m_way + (up - m_way) * below;
    // The lowest ring is around the pole, which has moved already.
    const double before = ring == 0 ? m_follow * m_offset : 0.0;
    return centre + trunk * around + reach * away + (moved - before) / along.y * along;
}

glm::dvec3 TrunkFoot::pole() const
{
    return m_start - glm::dvec3(0.0, skirt * m_radius + m_sunk - m_follow * m_offset, 0.0);
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
