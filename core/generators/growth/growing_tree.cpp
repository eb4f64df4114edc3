// Light.
#include "core/generators/growth/growing_tree.h"

#include "core/generators/colonisation/growth_space.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace ramure::growth {

namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
constexpr int leafWeight = 16, woodWeight = 3; // in the shadows
constexpr int leafYears = 2;
constexpr double profileStep = 1.2 / 240.0;
constexpr double gale = 14.0; ///< m/s, mean: more forms a tree no further

/// \param turnRad about the vertical axis: 0 along X, a quarter turn against Z
glm::dvec3 levelWay(double turnRad)
{
    const auto [sine, cosine] = maths::sincos(turnRad);
    return {cosine, 0.0, -sine};
}

} // namespace

Site::Site(const GrowthParams& params)
    : downhill(levelWay(params.slopeDirection))
    , grade(params.slope > 0.0 ? maths::tan(params.slope) : 0.0)
{
    wind = std::min(1.0, params.wind / gale) * levelWay(params.windDirection);
    light = params.sideLight * levelWay(params.lightDirection) + 0.5 * maths::sin(params.slope) * downhill;
    light /= std::max(1.0, glm::length(light));
}

double Site::aside(const glm::dvec3& at, double up, double wide) const
{
    constexpr double moved = 0.3, lee = 0.3, windward = 0.85;
    const glm::dvec3 pull = wind + 0.7 * light;
    const glm::dvec3 away = at - moved * wide * std::clamp(up, 0.0, 1.0) * pull;
    const double distance = std::sqrt(away.x * away.x + away.z * away.z);
    const double along = distance > 0.0 ? glm::dot(away, pull) / distance : 0.0; // the cosine times the pull
    return distance / std::max(0.2, 1.0 + (along < 0.0 ? windward : lee) * along);
}

double openSky(const GrowthParams& params, const glm::dvec3& at, glm::dvec3& towards)
{
    constexpr double half = 0.70710678118654752;
    constexpr double across[] = {1.0, half, 0.0, -half, -1.0, -half, 0.0, half};
    const double reach = 2.0 * params.height;
    const GrowthSpace& space = *params.space.space();
    towards = glm::dvec3(0.0);
    double open = space.blocks(at, at + glm::dvec3(0.0, reach, 0.0)) ? 0.0 : 1.0;
    for (unsigned k = 0; k < 8; ++k) {
        const glm::dvec3 level(across[k], 0.0, across[(k + 6) % 8]);
        if (space.blocks(at, at + reach * half * (level + glm::dvec3(0.0, 1.0, 0.0))))
            continue;
        open += 1.0;
        towards += level;
    }
    towards /= 4.0;
    return open / 9.0;
}

GrowingTree::GrowingTree(GrowthHistory& history, std::uint64_t seed)
    : m_history(history)
    , m_params(history.params)
    , m_site(history.params)
    , m_neighbours(history.params.space.neighbours)
    , m_seed(mixBits(seed * golden + 0x47726F777468ull))
{
    drawProfile();
    m_corners.reserve(std::size_t(cornersHigh * cornersWide * cornersWide));
    for (int y = 63; y < 63 + cornersHigh; ++y)
        for (int z = 64 - cornersWide / 2; z < 64 + cornersWide / 2; ++z)
            for (int x = 64 - cornersWide / 2; x < 64 + cornersWide / 2; ++x)
                m_corners.push_back(
                    chance(std::uint64_t(x) << 32 | std::uint64_t(y) << 16 | std::uint64_t(z), 21));
    const double turns[] = {m_params.divergence, std::numbers::pi / 2.0, std::numbers::pi};
    for (const std::size_t kind : {0u, 1u}) {
        const bool spirals = kind == 0 && m_params.phyllotaxis == Phyllotaxis::Alternate;
        const auto [sine, cosine] =
            maths::sincos(spirals ? turns[0] : turns[std::size_t(m_params.phyllotaxis)]);
        m_turnSine[kind] = sine;
        m_turnCosine[kind] = cosine;
    }
}

double GrowingTree::chance(std::uint64_t address, std::uint64_t purpose) const
{
    return double(mixBits(mixBits(address + purpose * golden) ^ m_seed) >> 11) * 0x1.0p-53;
}

/// Crowns are no solids of revolution: 0.75 to 1.15, by smooth chance in space.
double GrowingTree::outline(const glm::dvec3& at) const
{
    const glm::dvec3 p = at / (0.22 * m_params.height) + 64.0;
    const glm::dvec3 cell = glm::floor(p), in = p - cell, ease = in * in * (3.0 - 2.0 * in);
    double sum = 0.0;
    for (unsigned k = 0; k < 8; ++k) {
        const unsigned x = k & 1u, y = k >> 1 & 1u, z = k >> 2;
        const double weight =
            (x ? ease.x : 1.0 - ease.x) * (y ? ease.y : 1.0 - ease.y) * (z ? ease.z : 1.0 - ease.z);
        sum += weight * corner(int(cell.x) + int(x), int(cell.y) + int(y), int(cell.z) + int(z));
    }
    return 0.72 + 0.46 * sum;
}

double GrowingTree::corner(int x, int y, int z) const
{
    const int from = 64 - cornersWide / 2; // tree space begins at 64
    const int i = x - from, j = y - 63, k = z - from;
    if (i >= 0 && i < cornersWide && j >= 0 && j < cornersHigh && k >= 0 && k < cornersWide)
        return m_corners[std::size_t((j * cornersWide + k) * cornersWide + i)];
    return chance(std::uint64_t(x) << 32 | std::uint64_t(y) << 16 | std::uint64_t(z), 21);
}

/// Widths of the crown by height, of its widest place.
void GrowingTree::drawProfile()
{
    const double widest = std::clamp(m_params.crownWidest, 0.05, 0.95);
    for (std::size_t k = 0; k < m_profile.size(); ++k) {
        const double up = profileStep * double(k);
        const double left = 1.0 - std::min(1.0, (up - widest) / (1.04 - widest));
        m_profile[k] = up > widest ? maths::pow(std::max(0.0, left), m_params.crownTop)
                                   : 0.55 + 0.45 * std::sqrt(up / widest);
    }
}

/// How much of the light counts near the limits of the crown, which the grown tree fills.
/// \param foot m, height at which its limb leaves the trunk
double GrowingTree::envelope(const glm::dvec3& at, float outline, unsigned order, double foot) const
{
    const GrowthParams& p = m_params;
    // The outline is that of the top as well, in part: no crown ends in a plane.
    constexpr double dwarfed = 0.6;
    const double tall =
        p.height * (0.7 + 0.32 * double(outline)) * (1.0 - dwarfed * glm::length(m_site.wind));
    const double above = m_site.above(at);
    const double y = std::min(above, std::max(at.y, 0.3 * above)) / tall; // it rises from its foot
    if (m_history.standing > 0) // a tree that stands has a crown of its own
        return std::clamp(7.0 * (1.03 - y), 0.0, 1.0);
    const double share = std::min(1.0, m_top / p.height); // young trees are slim, and green to the ground
    const double base = p.crownBase * share * share;
    const double up = std::clamp((y - base) / std::max(1.0 - base, 0.05), 0.0, 1.2) / profileStep;
    const auto step = std::min(std::size_t(up), m_profile.size() - 2);
    double wide = m_profile[step] + (up - double(step)) * (m_profile[step + 1] - m_profile[step]);
    wide *= double(outline);
    const double aside = m_site.aside(at, y, p.crownWidth) / (0.5 * p.crownWidth * (0.35 + 0.65 * share));
    double room = std::min(4.0 * (wide + 0.04 - aside), 7.0 * (1.03 - y));
    // Limbs that leave the trunk below the crown die as a whole, though their ends have risen into it.
    if (order > 0)
        room =
            std::min(room, (std::min(y, 0.3 * y + 0.7 * foot / tall) - 0.75 * base) / (0.25 * base + 0.01));
    return std::clamp(room, 0.0, 1.0);
}

/// Buds near the end of a year's shoot come first; those that wait lose their rank.
double GrowingTree::budWeight(Index metamer) const
{
    const Node& node = m_nodes[metamer];
    const double share = double(node.rank + 1) / double(node.of);
    const double acrotony = 1.0 - m_params.acrotony * (1.0 - share * share);
    return m_params.branching * acrotony / double(std::max<int>(1, node.budYears));
}

/// The share of buds that wind leaves alive: those that face it dry out, but near the ground.
double GrowingTree::lives(const Pose& pose) const
{
    const double faces = -glm::dot(pose.direction, m_site.wind);
    const double exposed = std::clamp(m_site.above(pose.at) / (0.25 * m_params.height), 0.0, 1.0);
    return 1.0 - std::max(faces, 0.0) * exposed;
}

void GrowingTree::lightOf(Index metamer, const YearFactors& factors)
{
    Node& node = m_nodes[metamer];
    Flow& flow = m_flow[metamer];
    const Pose& pose = m_poses[metamer];
    if (node.buds == 0 && !m_nodes[metamer].tip) {
        if (node.dormant != 0)
            node.light =
                float(std::clamp(m_params.sunlight - m_shadows.shadowAt(pose.at, factors.shade), 0.0, 1.0));
        return;
    }
    const double sky = std::clamp(m_params.sunlight, 0.0, 1.0) * double(node.sky);
    const double shadow = m_shadows.shadowAt(pose.at, factors.shade);
    const std::uint64_t address = node.address;
    const double jitter = 0.85 + 0.3 * chance(address, 1 + 8 * std::uint64_t(factors.year));
    double own = std::clamp(sky - shadow + factors.shade, 0.0, sky) * jitter;
    const unsigned order = m_nodes[metamer].order;
    own *= lives(pose);
    if (glm::dvec3 away; !m_neighbours.empty())
        own *= m_neighbours.lightAt(pose.at, away);
    if (!m_room)
        own *= envelope(pose.at, node.outline, order, m_axes[node.axis].foot);
    else if (m_towards[metamer] != glm::dvec3(0.0))
        own = sky * jitter;
    else if (order > 0)
        own *= 0.15; // what fills its room lives on
    else             // leaders look for it
        own *= m_params.space.top() > 0.0
                   ? (pose.at.y < m_params.space.top() ? 0.5 : 0.15)
                   : 0.15 + 0.35 * envelope(pose.at, node.outline, order, m_site.above(pose.at));
    node.light = float(own);
    age(metamer);
    if (node.buds == 0 && !m_nodes[metamer].tip)
        return;
    if (m_nodes[metamer].tip)
        flow.main = own;
    flow.ownSide = own * double(std::popcount(node.buds)) * budWeight(metamer);
    flow.side = flow.ownSide;
    flow.light = float(own);
    flow.active = 1;
}

/// Buds that wait too long fall asleep, ends that see no light die.
void GrowingTree::age(Index metamer)
{
    constexpr int waits = 4, darkYears = 3;
    constexpr float dark = 0.03f;
    Node& node = m_nodes[metamer];
    if (node.buds != 0 && ++node.budYears > waits) {
        node.dormant |= node.buds;
        node.buds = 0;
    }
    if (node.tip) {
        AxisState& axis = m_axes[node.axis];
        axis.tipDark = node.light < dark ? std::uint8_t(axis.tipDark + 1) : std::uint8_t(0);
        axis.tipLives = node.tip = axis.tipDark < darkYears;
    }
}

bool GrowingTree::gatherLight(const YearFactors& factors)
{
    m_flow.assign(m_nodes.size(), {});
    m_neighbours.grow(factors.year);
    glm::dvec3 min(0.0), max(0.0);
    for (Index i = 0; i < living(); ++i) {
        min = glm::min(min, m_poses[i].at);
        max = glm::max(max, m_poses[i].at);
    }
    m_top = max.y;
    const double voxel = std::max(m_params.internode, m_params.height / 80.0);
    if (!m_shadows.reset(min, max, voxel))
        return false;
    for (Index i = 0; i < living(); ++i) {
        const Node& node = m_nodes[i];
        const bool isOld = node.metamer < m_history.standing && node.buds == 0; // its twigs have the leaves
        const bool leafy = (factors.year - int(node.birth) <= leafYears && !isOld) || node.tip;
        const double size = std::min(1.0, double(m_poses[i].length) / m_params.internode);
        m_shadows.add(m_poses[i].at, std::max(1, int(size * (leafy ? leafWeight : woodWeight))));
    }
    m_shadows.sum();
    if (m_room)
        lookForRoom();
    m_year = {};
    m_active.clear();
    for (Index i = 0; i < living(); ++i) {
        const Node& node = m_nodes[i];
        if (node.buds == 0 && !m_nodes[i].tip &&
            (node.dormant == 0 || (m_params.reiteration <= 0.0 && !node.woken)))
            continue;
        m_active.push_back(i);
        lightOf(i, factors);
        m_year.light += m_flow[i].main + m_flow[i].ownSide;
    }
    sumLight();
    return true;
}

Expected<void> GrowingTree::findRoom(const Progress& progress)
{
    const GrowthParams& p = m_params;
    if (p.sees != GrowthLight::Space)
        return {};
    constexpr double reach = 4.5, apart = 2.2, most = 400'000.0; // internodes; points
    const double step = apart * p.internode;
    std::vector<glm::dvec3> points;
    if (p.space.space() != nullptr && p.space.top() > 0.0) {
        if (auto checked = p.space.space()->checkEnvelope(); !checked)
            return checked;
        const double size = p.space.top() * p.space.top() * p.space.top() / (step * step * step);
        auto inside = p.space.space()->points(std::int64_t(std::clamp(p.density * size, 500.0, most)), 0.3,
                                              m_seed, progress);
        RAMURE_TRY(inside);
        points = std::move(*inside);
    } else {
        const double box = p.height * p.crownWidth * p.crownWidth / (step * step * step);
        m_top = p.height;
        const auto count = std::uint64_t(std::min(p.density * box, most));
        for (std::uint64_t k = 0; k < count; ++k) {
            const glm::dvec3 at((chance(k, 31) - 0.5) * p.crownWidth, chance(k, 32) * p.height,
                                (chance(k, 33) - 0.5) * p.crownWidth);
            if (envelope(at, float(outline(at)), 1, m_site.above(at)) > 0.3)
                points.push_back(at);
        }
    }
    m_room.emplace(std::move(points), reach * p.internode);
    return {};
}

void GrowingTree::lookForRoom()
{
    m_towards.assign(m_nodes.size(), glm::dvec3(0.0));
    const auto newest = m_nodes.empty() ? std::uint16_t(0) : m_nodes.back().birth;
    for (Index i = 0; i < living(); ++i)
        if (m_wasCut || m_nodes[i].birth == newest)
            m_room->occupy(m_poses[i].at, occupied * m_params.internode);
    m_wasCut = false;
    for (Index i = 0; i < living(); ++i)
        if (m_nodes[i].buds != 0 || m_nodes[i].tip)
            m_room->look(i, m_poses[i].at, m_poses[i].direction);
    m_room->sum(m_towards);
}

void GrowingTree::sumLight()
{
    for (Index i = living(); i-- > 0;) {
        const Index parent = m_nodes[i].parent;
        if (parent == noIndex)
            continue;
        const Flow& own = m_flow[i];
        Flow& below = m_flow[parent];
        (m_nodes[i].axis == m_nodes[parent].axis ? below.main : below.side) += own.main + own.side;
        below.light += own.light;
        below.active += own.active;
    }
}

} // namespace ramure::growth
