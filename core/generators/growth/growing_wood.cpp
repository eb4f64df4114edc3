// Shedding, thickness, and what the weight leaves in the wood.
#include "core/generators/growth/growing_tree.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure::growth {

namespace {

int rowBend(float bend)
{
    const double steps = 1e4 * double(bend);
    return int(steps < 0.0 ? steps - 0.5 : steps + 0.5);
}

} // namespace

glm::dquat bendOf(const glm::dvec3& direction, double angle)
{
    const double flat = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    if (angle == 0.0 || flat < 1e-6)
        return {1.0, 0.0, 0.0, 0.0};
    // Half the angle's tangent by two terms: what is stored is an angle by name only, and the same
    // everywhere.
    const double half = 0.5 * angle, t = half * (1.0 + half * half / 3.0);
    const double scale = 1.0 / std::sqrt(1.0 + t * t);
    return {scale, scale * t * direction.z / flat, 0.0, -scale * t * direction.x / flat};
}

/// \param below what carried it
void GrowingTree::remove(const Node& base, Node& below)
{
    if (below.axis != base.axis)
        below.lost += float(m_params.girth) * base.pipes;
    else if (!below.dead)
        below.bare = 0;
}

/// Years that wood without life above it stays: what was dead already lasts, the thicker the longer, and
/// breaks from its end.
int GrowingTree::bareYears(const Node& node)
{
    constexpr int twigYears = 3;
    constexpr double yearsAMetre = 200.0; // of radius
    if (!node.dead)
        return twigYears;
    const int years = twigYears + int(yearsAMetre * std::sqrt(thicknessOf(node.pipes)));
    return m_params.deadWood > 0.0 ? int(m_params.deadWood * double(years)) : years;
}

/// It dies and stands on.
void GrowingTree::wither(Node& node, int age)
{
    node.dead = true;
    node.tip = node.woken = false;
    node.buds = node.dormant = 0;
    node.bare = 0;
    m_axes[node.axis].tipLives = false;
    if (node.metamer >= m_history.withered.size())
        m_history.withered.resize(std::size_t(node.metamer) + 1, GrowthHistory::lives);
    m_history.withered[node.metamer] = std::uint16_t(age);
}

/// Of a node that is older than a year, after the light that it had. \param parent where what carries it lies
/// now \param least light that keeps an axis
GrowingTree::Fate GrowingTree::fateOf(Index i, Index parent, double least, int age)
{
    constexpr std::uint8_t darkYears = 2;
    constexpr double shadeLine = 0.8;
    Node& node = m_nodes[i];
    const Flow& flow = m_flow[i];
    AxisState& axis = m_axes[node.axis];
    node.bare = flow.active == 0 ? std::uint8_t(std::min(255, node.bare + 1)) : std::uint8_t(0);
    bool falls = int(node.bare) >= bareYears(node), dies = false;
    if (node.twin != noIndex) {
        falls = int(m_uncut->death[node.twin]) == age;
        dies = m_uncut->isDead(node.twin, age);
    }
    if (axis.base == node.metamer && parent != noIndex) {
        const double mean = flow.active > 0 ? double(flow.light) / double(flow.active) : 0.0;
        axis.dark = mean < least ? std::uint8_t(axis.dark + 1) : std::uint8_t(0);
        if (axis.dark >= darkYears && node.twin == noIndex && !node.dead) {
            // What reaches into the top of the crown falls, as if the wind had taken it.
            const bool stands = i < m_highest.size() && m_highest[i] < shadeLine * m_highest.front();
            (stands ? dies : falls) = true;
        }
    }
    if (node.parent == noIndex)
        return Fate::Lives;
    return falls ? Fate::Falls : dies ? Fate::Dies : Fate::Lives;
}

/// How high what each node carries is, with itself; nothing where no dead wood stands.
void GrowingTree::measureHeights()
{
    m_highest.clear();
    if (!(m_params.deadWood > 0.0))
        return;
    m_highest.resize(m_nodes.size());
    double top = 0.0;
    for (Index i = living(); i-- > 0;) {
        m_highest[i] = std::max(m_highest[i], m_site.above(m_poses[i].at));
        if (const Index parent = m_nodes[i].parent; parent != noIndex)
            m_highest[parent] = std::max(m_highest[parent], m_highest[i]);
        top = std::max(top, m_highest[i]);
    }
    if (!m_highest.empty())
        m_highest.front() = top; // of several stems the highest
}

void GrowingTree::shed(const YearFactors& factors)
{
    measureHeights();
    // Of the mean light of the whole tree, so that no setting sheds all of it.
    double light = 0.0, active = 0.0;
    for (Index i = 0; i < living(); ++i)
        if (m_nodes[i].parent == noIndex && i < m_flow.size()) {
            light += double(m_flow[i].light);
            active += double(m_flow[i].active);
        }
    const double least = active > 0.0 ? 0.55 * m_params.shedding * light / active : 0.0;
    const int age = factors.year + 1;
    Index kept = 0;
    m_place.resize(m_nodes.size());
    for (Index i = 0; i < living(); ++i) {
        Node& node = m_nodes[i];
        m_place[i] = noIndex;
        const bool isRoot = node.parent == noIndex;
        const Index parent = isRoot ? noIndex : m_place[node.parent];
        bool goes = !isRoot && parent == noIndex; // with what carried it
        const bool isNew = int(node.birth) == factors.year;
        // What is carried dies with what carries it.
        bool withers = m_params.deadWood > 0.0 && parent != noIndex && m_nodes[parent].dead;
        if (!goes && !isNew) {
            const Fate fate = fateOf(i, parent, least, age);
            goes = fate == Fate::Falls;
            withers = withers || fate == Fate::Dies;
            if (goes)
                remove(node, m_nodes[parent]);
        }
        if (withers && !goes && !node.dead)
            wither(node, age);
        if (node.cut && !goes) { // what it carries goes with it
            remove(node, m_nodes[parent]);
            wake(parent);
            goes = true;
        }
        if (goes) {
            if (node.cut)
                opened(m_poses[i].at);
            if (m_wasCut && m_room)
                m_room->release(m_poses[i].at, occupied * m_params.internode);
            m_history.death[node.metamer] = std::uint16_t(age);
            ++m_year.shed;
            continue;
        }
        node.parent = parent;
        m_place[i] = kept;
        if (kept != i) {
            m_nodes[kept] = node;
            m_poses[kept] = m_poses[i];
        }
        ++kept;
    }
    m_nodes.resize(kept);
    m_poses.resize(kept);
}

void GrowingTree::die(int age)
{
    for (Index i = 0; i < living(); ++i)
        m_history.death[m_nodes[i].metamer] = std::uint16_t(age);
    m_nodes.clear();
    m_poses.clear();
}

/// Pipes are never lost: what shed branches carried stays in the wood in part, and no section gets thinner.
/// They are lost all the way down: nodes below see them through their children.
void GrowingTree::thicken(const YearFactors& factors)
{
    constexpr float leafTrace = 0.12f;
    const bool bends = m_params.droop > 0.0 || m_params.reaction > 0.0;
    m_load.assign(m_nodes.size(), {});
    for (Index i = living(); i-- > 0;) {
        Node& node = m_nodes[i];
        const double carried = m_load[i].pipes;
        const float own = carried > 0.0 ? leafTrace : 1.0f;
        const float now = std::max({float(carried) + own + node.lost, node.pipes, 1.0f});
        const double girth = double(now) / std::max(double(node.pipes), 1.0) - 1.0;
        node.pipes = now;
        if (node.parent != noIndex)
            m_load[node.parent].pipes += double(now);
        if (bends)
            bend(i, girth, factors);
    }
    if (bends)
        place();
}

/// m2, the square of the radius of a section with so many pipes, as the rows keep them.
double GrowingTree::thicknessOf(float pipes)
{
    const std::uint16_t packed = packedPipes(pipes);
    if (packed >= m_thickness.size())
        m_thickness.resize(std::size_t(packed) + 1, 0.0f);
    float& known = m_thickness[packed];
    if (known == 0.0f)
        known = float(m_params.tipRadius * m_params.tipRadius *
                      maths::pow(double(pipesOf(packed)), 2.0 / m_params.pipeExponent));
    return double(known);
}

/// The new weight of a year bends the wood by M / (E I), and the ring that grows over it keeps a share; wood
/// that grows in girth turns up again (reaction wood).
/// \param girth what it grew, over what it was
void GrowingTree::bend(Index i, double girth, const YearFactors& factors)
{
    constexpr double elasticity = 8e9, density = 900.0, leaf = 0.012, gravity = 9.81; // Pa, kg/m3, kg, m/s2
    constexpr double mostAYear = 0.012, most = 0.4;
    Node& node = m_nodes[i];
    const Pose& pose = m_poses[i];
    const double r2 = thicknessOf(node.pipes);
    const double length = double(pose.length);
    const bool leafy = factors.year - int(node.birth) <= 1;
    const double mass = density * std::numbers::pi * r2 * length + (leafy ? leaf : 0.0);
    const glm::dvec4 load =
        m_load[i].weight + glm::dvec4(mass * (pose.at - 0.5 * length * pose.direction), mass);
    if (node.parent != noIndex)
        m_load[node.parent].weight += load;
    const glm::dvec3 d = pose.direction;
    const double flat = std::sqrt(d.x * d.x + d.z * d.z);
    if (flat < 1e-6 || node.order == 0)
        return;
    const glm::dvec3 foot = pose.at - length * d;
    const double arm = ((load.x - load.w * foot.x) * d.x + (load.z - load.w * foot.z) * d.z) / flat;
    const double moment = gravity * arm;
    const double stiff = elasticity * 0.25 * std::numbers::pi * r2 * r2;
    double turn = m_params.droop * (moment - double(node.moment)) / stiff * length;
    turn = std::clamp(turn, 0.0, mostAYear * length / 0.2);
    node.moment = float(std::max(moment, double(node.moment)));
    // Limbs turn to where they were born and a little higher.
    const double wants = std::max(0.0, double(node.bend)) * 0.5 + 0.02 * flat;
    turn -= m_params.reaction * std::min(1.0, girth * 2.0) * wants * 0.3 * std::min(1.0, length / 0.2);
    if (turn == 0.0)
        return;
    // The angle counts about the horizontal at birth, from which bends below may have turned it.
    const glm::dvec3 rest(pose.rest);
    const glm::dvec3 born = pose.frame * glm::dvec3(rest.z, 0.0, -rest.x);
    const double same = (born.x * d.z - born.z * d.x) / (flat * std::max(glm::length(born), 1e-6));
    node.bend = float(std::clamp(double(node.bend) + turn * same, -0.25 * most, most));
}

/// Where everything stands, from the ground up.
void GrowingTree::place()
{
    for (Index i = 0; i < living(); ++i) {
        const Index parent = m_nodes[i].parent;
        Pose& pose = m_poses[i];
        const glm::dvec3 rest(pose.rest);
        const glm::dquat below = parent == noIndex ? glm::dquat(1.0, 0.0, 0.0, 0.0) : m_poses[parent].frame;
        const int bend = rowBend(m_nodes[i].bend); // as the rows keep it
        pose.frame = bend == 0 ? below : below * bendOf(rest, 1e-4 * double(bend));
        pose.direction = pose.frame * rest;
        const glm::dvec3 foot = parent == noIndex ? m_history.footOf(m_nodes[i].metamer) : m_poses[parent].at;
        pose.at = foot + pose.direction * double(pose.length);
    }
}

void GrowingTree::record()
{
    for (Index i = 0; i < living(); ++i) {
        m_history.pipes.push_back(packedPipes(m_nodes[i].pipes));
        m_history.bends.push_back(std::int16_t(rowBend(m_nodes[i].bend)));
    }
    m_history.rowStart.push_back(m_history.pipes.size());
    m_year.living = Index(m_nodes.size());
    m_history.years.push_back(m_year);
}

} // namespace ramure::growth
