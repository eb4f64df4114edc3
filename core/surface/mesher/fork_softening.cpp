#include "core/surface/mesher/fork_softening.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double fullest = 0.9; ///< of the smooth minimum
/// Tubes that part at a small angle have a long, shallow valley: a vertex in it moves along it no further
/// than one over this times what it moves away from them.
constexpr double leastGain = 0.35;
/// Of the shortest child, where the highest wall stands: from there on a fork is not softened at all, and
/// less and less over the way up to there.
constexpr double noSoftness = 0.75, noSoftnessOfTwo = 0.95, softnessFades = 0.25;
/// Surfaces that face each other each swell no further than this share of the way between them.
constexpr double facingShare = 0.3;
constexpr double highest = 0.95; ///< of the shortest tube: no vertex is moved beyond

} // namespace

void ForkSoftener::begin(std::span<const ForkChild> children, double reach, double softness)
{
    m_children = children;
    m_reach = reach;
    m_softness = reach > 0.0 ? fullest * softness : 0.0;
}

double ForkSoftener::bulge(double reach, double away, double cosine) const
{
    const double part = 1.0 - std::max(away, 0.0) / reach;
    return part > 0.0 ? m_softness * 0.25 * reach * part * part * std::min(1.0, 1.0 - cosine) : 0.0;
}

void ForkSoftener::limit(double ringHeight)
{
    double shortest = std::numeric_limits<double>::max();
    for (const ForkChild& child : m_children)
        shortest = std::min(shortest, child.table.length());
    const double share = shortest > 0.0 ? ringHeight / shortest : 1.0;
    const double most = m_children.size() == 2 ? noSoftnessOfTwo : noSoftness;
    m_softness *= std::clamp((most - share) / softnessFades, 0.0, 1.0);
}

bool ForkSoftener::soften(const std::array<Index, 3>& child, glm::dvec3& position, double& along)
{
    double radius = std::numeric_limits<double>::max(), length = radius, clear = radius;
    m_away.clear();
    for (const Index i : child) {
        if (i == noIndex)
            continue;
        const AxisTable& table = m_children[i].table;
        const AxisTable::Away& away = m_away.emplace_back(table.awayFrom(position, along));
        clear = std::min(clear, away.clearance);
        radius = std::min(radius, away.radius);
        length = std::min(length, table.length());
    }
    if (clear < 0.0) // tubes that never come apart have no valley to fill
        return false;
    // All tubes count by how near they are: between a wall and the corner it ends at nothing jumps.
    const double reach = m_reach * radius;
    for (Index i = 0; i < m_children.size(); ++i)
        if (i != child[0] && i != child[1] && i != child[2] &&
            m_children[i].table.mayBeNear(position, along, clear + reach))
            m_away.push_back(m_children[i].table.awayFrom(position, along));
    glm::dvec3 out(0.0), ahead(0.0);
    double weights = 0.0;
    for (const AxisTable::Away& away : m_away) {
        const double near = 1.0 - std::max(away.clearance - clear, 0.0) / reach;
        if (near <= 0.0)
            continue;
        weights += near * near;
        out += near * near * away.out;
        ahead += near * near * away.tangent;
    }
    const double pull = glm::length(out), gain = pull / weights;
    // Of two directions, an angle a apart, gain is the cosine of its half.
    const double fill = bulge(reach, 0.0, 2.0 * gain * gain - 1.0);
    if (!(pull > 1e-6) || fill <= clear)
        return false;
    out *= 1.0 / pull;
    double way = (fill - clear) / std::max(gain, leastGain);
    const double rise = glm::dot(out, ahead) / weights;
    if (const double room = highest * length - along; rise * way > room)
        way = room > 0.0 ? room / rise : 0.0;
    position += way * out;
    along = std::max(0.0, along + way * rise);
    return true;
}

bool ForkSoftener::comesNear(Index child, const AxisSection& section)
{
    m_near.clear();
    const double reach = (1.0 + m_reach) * section.radius;
    for (Index j = 0; j < m_children.size(); ++j)
        if (j != child && m_children[j].table.clearance(section.centre, section.along) < reach)
            m_near.push_back(j);
    return !m_near.empty();
}

double ForkSoftener::swelling(const AxisSection& section, const glm::dvec3& point,
                              const glm::dvec3& out) const
{
    double most = 0.0, room = std::numeric_limits<double>::max();
    for (const Index j : m_near) {
        if (!m_children[j].table.mayBeNear(point, section.along, m_reach * section.radius))
            continue;
        const AxisTable::Away other = m_children[j].table.awayFrom(point, section.along);
        const double reach = m_reach * std::min(section.radius, other.radius);
        if (other.clearance >= reach)
            continue;
        const double cosine = glm::dot(out, other.out);
        most = std::max(most, bulge(reach, other.clearance, cosine));
        if (cosine < 0.0)
            room = std::min(room, facingShare * std::max(other.clearance, 0.0) / -cosine);
    }
    return std::min(most, room);
}

} // namespace ramure
