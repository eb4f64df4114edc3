// Shoots: who grows, how long and where to.
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

const glm::dvec3 up(0.0, 1.0, 0.0);

glm::dvec3 unit(const glm::dvec3& v, const glm::dvec3& otherwise)
{
    const double length = glm::length(v);
    return length > 1e-9 ? v / length : otherwise;
}

/// What of \p side stands square on \p direction.
glm::dvec3 square(const glm::dvec3& side, const glm::dvec3& direction)
{
    const glm::dvec3 other =
        std::abs(direction.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 across = side - glm::dot(side, direction) * direction;
    const double length = glm::length(across);
    return length > 1e-9 ? across / length : unit(glm::cross(direction, other), other);
}

} // namespace

void GrowingTree::growShoots(const YearFactors& factors)
{
    if (m_history.parent.empty()) {
        for (unsigned k = 0; k < unsigned(m_params.stems); ++k) {
            const Index axis = newAxis(noIndex, k, 0, false, factors.year);
            const std::uint64_t address = m_history.axisAddress[axis];
            const double turn =
                2.0 * std::numbers::pi * (double(k) / double(m_params.stems) + 0.5 * chance(address, 2));
            const auto [sine, cosine] = maths::sincos(turn);
            const double lean = m_params.stems > 1 ? 0.25 + 0.2 * chance(address, 3) : 0.0;
            const glm::dvec3 side(cosine, 0.0, sine);
            const auto [down, upright] = maths::sincos(m_params.lean);
            const glm::dvec3 stem = upright * up + down * m_site.downhill;
            grow({noIndex, axis, glm::dvec3(0.0), unit(stem + lean * side, up), side, true}, 1, 1.0, factors);
        }
        return;
    }
    if (m_uncut != nullptr) {
        noteTwins();
        const Index all = living();
        for (Index i = 0; i < all; ++i)
            if (m_nodes[i].twin != noIndex)
                growAsTwin(i, factors);
    }
    for (const Index i : m_active)
        if (m_nodes[i].twin == noIndex)
            growFrom(i, factors);
}

void GrowingTree::growFrom(Index metamer, const YearFactors& factors)
{
    const Flow& flow = m_flow[metamer];
    const bool tip = m_nodes[metamer].tip;
    const double main = flow.tipVigour, side = flow.sideVigour;
    m_year.vigourSpent += main + side;
    if (tip && main > 0.0)
        growTip(metamer, main, factors);
    if (m_nodes[metamer].buds != 0 && side > 0.0)
        growSide(metamer, side / double(std::popcount(m_nodes[metamer].buds)), factors);
    if (m_nodes[metamer].woken)
        sprout(metamer, factors);
    if (m_nodes[metamer].dormant != 0 && m_params.reiteration > 0.0)
        reiterate(metamer, factors);
}

/// \param stretch becomes the length of each metamer over the usual one.
int GrowingTree::shootLength(double vigour, unsigned order, double& stretch, const YearFactors& factors) const
{
    const double pays = std::min(vigour, std::max(1.0, factors.sideLongest[order]));
    if (pays >= 1.0) {
        const int nodes = std::min(250, int(pays));
        stretch = std::min(1.5, pays / double(nodes));
        return nodes;
    }
    stretch = std::max(pays * pays, 0.15);
    constexpr double weakest = 0.1; // what a bud costs is never nothing, or buds without end would shoot
    return vigour >= std::max(weakest, 1.0 - m_params.shortShoots) ? 1 : 0;
}

void GrowingTree::growTip(Index metamer, double vigour, const YearFactors& factors)
{
    const Index axis = m_nodes[metamer].axis;
    const unsigned order = m_nodes[metamer].order;
    AxisState& state = m_axes[axis];
    const std::uint64_t address = m_nodes[metamer].address;
    const bool leads = order == 0 && double(factors.year) < m_params.leaderUntil;
    if (m_params.sympodial > 0.0 && !leads && factors.year > 2 && state.nodes > 3 &&
        chance(address, 4 + 8 * std::uint64_t(factors.year)) < m_params.sympodial) {
        state.tipLives = m_nodes[metamer].tip = false;
        return;
    }
    double stretch = 1.0;
    const int nodes = shootLength(vigour, order, stretch, factors);
    if (nodes == 0)
        return;
    // Twigs that only ever make short shoots do not get old, the sooner the less light they have.
    state.weak = nodes > 1 ? std::uint8_t(0) : std::uint8_t(std::min(255, state.weak + 1));
    constexpr int weakYears = 5;
    if (order > 1 && state.weak > weakYears &&
        chance(address, 3 + 8 * std::uint64_t(factors.year)) < 0.3 * (1.1 - double(m_nodes[metamer].light))) {
        state.tipLives = m_nodes[metamer].tip = false;
        return;
    }
    const Pose& pose = m_poses[metamer];
    const glm::dvec3 side = pose.frame * glm::dvec3(m_nodes[metamer].side);
    const glm::dvec3 next =
        nextCosine(order) * side + nextSine(order) * glm::cross(pose.direction, side); // of the next bud
    grow({metamer, axis, pose.at, pose.direction, next, false}, nodes, stretch, factors);
}

void GrowingTree::growSide(Index metamer, double vigour, const YearFactors& factors)
{
    const Index axis = m_nodes[metamer].axis;
    const unsigned order = m_nodes[metamer].order + 1u;
    if (order >= unsigned(m_params.orders))
        return;
    double stretch = 1.0;
    const int nodes = shootLength(vigour, order, stretch, factors);
    if (nodes == 0)
        return;
    const unsigned buds = m_nodes[metamer].buds;
    m_nodes[metamer].buds = 0;
    const int all = std::popcount(buds);
    for (int k = 0; k < all; ++k) {
        const Pose pose = m_poses[metamer]; // the arrays move
        const glm::dvec3 first = pose.frame * glm::dvec3(m_nodes[metamer].side);
        const Index child = newAxis(metamer, unsigned(k), order, false, factors.year);
        const std::uint64_t address = m_history.axisAddress[child];
        const auto [turnSine, turnCosine] = maths::sincos(2.0 * std::numbers::pi * double(k) / double(all) +
                                                          m_params.wander * (chance(address, 5) - 0.5));
        const glm::dvec3 side = turnCosine * first + turnSine * glm::cross(pose.direction, first);
        double axil = m_params.axil * (0.8 + 0.4 * chance(address, 6));
        if (!m_axes[axis].tipLives && m_axes[axis].tip == m_nodes[metamer].metamer)
            axil *= 0.5; // it takes the place of the end
        else if (m_params.whorl > 0 && order > 1)
            axil *= 0.65; // limbs of pines and spruces fork less widely than the stem
        const auto [sine, cosine] = maths::sincos(std::clamp(axil, 0.05, 2.6));
        const glm::dvec3 direction = unit(cosine * pose.direction + sine * side, side);
        // The buds of a side shoot begin outside and beside it.
        const glm::dvec3 beside = square(glm::cross(pose.direction, side), direction);
        grow({metamer, child, pose.at, direction, beside, true}, nodes, stretch, factors);
    }
}

/// A bud that slept on an old limb in the light begins the tree anew (Oldeman 1974; Halle et al. 1978).
void GrowingTree::reiterate(Index metamer, const YearFactors& factors)
{
    constexpr int oldEnough = 8;
    constexpr float lit = 0.45f;
    const std::uint64_t address = m_nodes[metamer].address;
    if (factors.year - int(m_nodes[metamer].birth) < oldEnough || m_nodes[metamer].light < lit ||
        chance(address, 7 + 8 * std::uint64_t(factors.year)) >= m_params.reiteration)
        return;
    const Pose pose = m_poses[metamer];
    m_nodes[metamer].dormant = 0;
    const unsigned order = m_nodes[metamer].order + 1u;
    if (order >= unsigned(m_params.orders))
        return;
    const Index child = newAxis(metamer, 7, order, true, factors.year);
    const glm::dvec3 side = pose.frame * glm::dvec3(m_nodes[metamer].side);
    const glm::dvec3 direction = unit(0.8 * up + 0.6 * square(side, pose.direction), up);
    const int nodes = std::max(1, int(0.6 * factors.longest));
    grow({metamer, child, pose.at, direction, square(side, direction), true}, nodes, 1.0, factors);
}

Index GrowingTree::newAxis(Index parent, unsigned bud, unsigned order, bool upright, int year)
{
    const auto axis = Index(m_axes.size());
    const std::uint64_t below = parent == noIndex ? 0x52616D757265ull : m_nodes[parent].address;
    m_history.axisAddress.push_back(
        mixBits(mixBits(below + 0x9E3779B97F4A7C15ull * (std::uint64_t(year) + 1)) + bud));
    m_history.axisOrder.push_back(std::uint8_t(std::min(order, 255u)));
    m_axes.push_back({});
    m_axes.back().upright = upright;
    if (parent != noIndex)
        m_axes.back().foot =
            order > 1 ? m_axes[m_nodes[parent].axis].foot : float(m_site.above(m_poses[parent].at));
    return axis;
}

/// Between two whorls a stem bears the fewer shoots, the more acrotonic it is: pines none, spruces many.
std::uint8_t GrowingTree::budsOf(unsigned order, int rank, int nodes, std::uint64_t address) const
{
    if (m_params.whorl > 0) {
        if (rank + 1 < nodes)
            return order > 1 || chance(address, 15) >= m_params.acrotony ? std::uint8_t(1) : std::uint8_t(0);
        const auto most = order == 0 ? m_params.whorl : std::max<std::int64_t>(2, m_params.whorl / 2);
        return std::uint8_t((1u << std::min<std::int64_t>(most, 8)) - 1u);
    }
    const unsigned usual = m_params.phyllotaxis == Phyllotaxis::Opposite ? 2u : 1u;
    const unsigned buds = rank + 1 < nodes ? usual : std::max(usual, unsigned(m_params.endBuds));
    return std::uint8_t((1u << buds) - 1u);
}

/// How wind and light from one side turn a shoot: the more, the higher it grows.
glm::dvec3 GrowingTree::blown(const glm::dvec3& at) const
{
    const double up = std::clamp(m_site.above(at) / (0.5 * m_params.height), 0.2, 1.0);
    return 0.9 * up * m_site.wind + 0.3 * m_site.light;
}

/// Where an internode grows: on, to the light, up or down, and by chance.
/// \param strength of its shoot, 0 to 1: weak limbs hang as twigs do
glm::dvec3 GrowingTree::turned(const ShootStart& start, const glm::dvec3& light, double strength,
                               std::uint64_t address) const
{
    const GrowthParams& p = m_params;
    const unsigned order = m_history.axisOrder[start.axis];
    const bool erect = order == 0 || m_axes[start.axis].upright;
    const double share = p.internode / 0.2; // of what an internode of 0.2 m turns
    const glm::dvec3 random(chance(address, 11) - 0.5, chance(address, 12) - 0.5, chance(address, 13) - 0.5);
    glm::dvec3 sum = start.direction + p.wander * 1.2 * random * (erect ? 0.5 : 1.0);
    const double weak = 1.0 - strength;
    const double rise = erect ? 0.25 : p.upright - p.weeping * (order > 1 ? 0.5 : 0.12 + 0.38 * weak * weak);
    sum += share * rise * up;
    sum += share * (erect ? 0.35 : 1.0) * p.light * light;
    sum += share * (erect ? 0.35 : 1.0) * blown(start.at);
    glm::dvec3 direction = unit(sum, start.direction);
    if (!erect && p.plagiotropy > 0.0) {
        direction.y *= 1.0 - 0.35 * p.plagiotropy;
        direction = unit(direction, start.direction);
    }
    // Nothing grows into the ground.
    const double low = 0.02 * p.height;
    const double above = m_site.above(start.at);
    const double sinks = direction.y + m_site.grade * glm::dot(direction, m_site.downhill);
    if (above < 3.0 * low && sinks < 0.0)
        direction =
            unit({direction.x, direction.y - sinks + sinks * std::max(0.0, (above - low) / (2.0 * low)),
                  direction.z},
                 start.direction);
    return direction;
}

/// Where a shoot turns to: unit or shorter.
glm::dvec3 GrowingTree::lightAt(const ShootStart& start, const YearFactors& factors)
{
    glm::dvec3 light(0.0);
    if (start.from != noIndex) {
        light = m_shadows.lighter(start.at, factors.shade) * glm::dvec3(1.0, 0.35, 1.0);
        light /= std::max(glm::length(light), 0.25);
        if (m_room && start.from < m_towards.size() && m_towards[start.from] != glm::dvec3(0.0))
            light = m_towards[start.from];
    }
    if (glm::dvec3 open; m_params.space.space() != nullptr && openSky(m_params, start.at, open) < 1.0)
        light += open;
    if (glm::dvec3 away; !m_neighbours.empty()) {
        (void)m_neighbours.lightAt(start.at, away);
        light += away;
    }
    return light;
}

void GrowingTree::grow(ShootStart start, int nodes, double stretch, const YearFactors& factors)
{
    const GrowthSpace* space = m_params.space.space();
    glm::dvec3 light(0.0);
    if (nodes > 1 || !start.isNew)
        light = lightAt(start, factors);
    const unsigned order = m_history.axisOrder[start.axis];
    const double strength = std::min(1.0, double(nodes) / factors.sideLongest[std::min(order, 15u)]);
    for (int rank = 0; rank < nodes; ++rank) {
        AxisState& axis = m_axes[start.axis];
        const std::uint64_t address =
            mixBits(m_history.axisAddress[start.axis] + m_salt +
                    0x9E3779B97F4A7C15ull * (std::uint64_t(factors.year) * 256 + std::uint64_t(rank) + 1));
        glm::dvec3 direction =
            start.isNew && rank == 0 ? start.direction : turned(start, light, strength, address);
        double length = m_params.internode * stretch * (0.8 + 0.4 * chance(address, 14));
        if (start.twin != noIndex) {
            direction = m_poses[start.from].frame * glm::dvec3(m_uncut->direction[start.twin]);
            length = double(m_uncut->length[start.twin]);
        }
        if (space != nullptr && space->blocks(start.at, start.at + 1.5 * length * direction))
            return;
        start.side = square(start.side, direction);
        const Index metamer = addMetamer(start, direction, length, factors.year);
        Node& node = m_nodes[metamer];
        node.buds = budsOf(order, rank, nodes, address);
        node.address = address;
        node.rank = std::uint8_t(rank);
        node.of = std::uint8_t(nodes);
        if (!start.isNew || rank > 0)
            m_nodes[start.from].tip = false;
        node.tip = true;
        node.twin = start.twin;
        if (start.twin != noIndex)
            start.twin = twinOnAxis(start.twin, factors.year);
        axis.tip = node.metamer;
        axis.tipLives = true;
        axis.tipDark = 0;
        axis.nodes = std::uint16_t(std::min(65535, axis.nodes + 1));
        if (axis.base == noIndex)
            axis.base = node.metamer;
        start.from = metamer;
        start.at = m_poses[metamer].at;
        start.direction = direction;
        start.side = nextCosine(order) * start.side + nextSine(order) * glm::cross(direction, start.side);
    }
}

Index GrowingTree::addMetamer(const ShootStart& start, const glm::dvec3& direction, double length, int year)
{
    const Index slot = living();
    const glm::dquat frame =
        start.from == noIndex ? glm::dquat(1.0, 0.0, 0.0, 0.0) : m_poses[start.from].frame;
    const glm::dquat back = glm::conjugate(frame);
    m_history.parent.push_back(start.from == noIndex ? noIndex : m_nodes[start.from].metamer);
    m_history.axis.push_back(start.axis);
    m_history.birth.push_back(std::uint16_t(year));
    m_history.death.push_back(GrowthHistory::lives);
    m_history.direction.push_back(glm::vec3(back * direction));
    m_history.length.push_back(float(length));
    Node node;
    node.metamer = Index(m_history.parent.size() - 1);
    node.parent = start.from;
    node.axis = start.axis;
    node.birth = std::uint16_t(year);
    node.order = m_history.axisOrder[start.axis];
    Pose pose;
    pose.length = float(length);
    pose.rest = m_history.direction.back();
    pose.at = start.at + direction * double(pose.length);
    pose.direction = direction;
    pose.frame = frame;
    node.side = glm::vec3(back * start.side);
    node.outline = float(outline(pose.at));
    if (glm::dvec3 open; m_params.space.space() != nullptr)
        node.sky = float(openSky(m_params, pose.at, open));
    m_nodes.push_back(node);
    m_poses.push_back(pose);
    ++m_year.born;
    return slot;
}

} // namespace ramure::growth
