#include "core/lod/life_pose.h"

#include <algorithm>

namespace ramure {
namespace {

/// m: how thick wood is that is not there, and how long a branch of it. Edges of its cross-sections are 0.12
/// mm or longer up to ten sides.
constexpr double goneRadius = 0.0005, goneLength = 0.002;
/// Radii of the wood below it, or above it, from its node: what of a branch belongs to a fork.
constexpr double forkReach = 1.3;
constexpr double leastSine = 0.5;

/// The smallest rotation between two unit vectors.
glm::dquat turnBetween(const glm::dvec3& from, const glm::dvec3& to)
{
    const double cosine = glm::dot(from, to);
    if (cosine < -0.999999) { // half a turn about any normal
        const glm::dvec3 aside =
            std::abs(from.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 axis = glm::normalize(glm::cross(from, aside));
        return {0.0, axis.x, axis.y, axis.z};
    }
    const glm::dvec3 axis = glm::cross(from, to);
    return glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
}

} // namespace

glm::dvec3 LifePose::Branch::point(const glm::dvec3& rest) const
{
    const glm::dvec3 way = rest - from;
    const double d = glm::dot(way, along);
    const glm::dvec3 aside = way - d * along;
    const double scale = std::lerp(footScale, endScale, std::clamp(d / restLength, 0.0, 1.0));
    const double restTop = restLength - restCrotch, top = length - crotch;
    double height = 0.0;
    if (d < restCover)
        height = d * (restCover > 0.0 ? cover / restCover : footScale);
    else if (d < restTop)
        height = cover + (d - restCover) * (top - cover) / (restTop - restCover);
    else
        height = top + (d - restTop) * (d < restLength ? crotch / restCrotch : endScale);
    return foot + turn * (height * along + scale * aside);
}

std::vector<LifePose::End> LifePose::Placed::ends() const
{
    std::vector<End> out;
    out.reserve(branches.size());
    for (const Branch& branch : branches)
        out.push_back({branch.end(), branch.reach});
    return out;
}

void LifePose::Placed::move(std::span<const glm::vec3> points, const Skin& skin,
                            std::span<glm::vec3> places) const
{
    for (std::size_t r = 0; r < skin.runs.size(); ++r) {
        const Index end = r + 1 < skin.runs.size() ? skin.runs[r + 1].firstVertex : skin.vertices;
        const SkinInfluence& influence = skin.runs[r].influence;
        for (Index v = skin.runs[r].firstVertex; v < end; ++v) {
            glm::dvec3 place(0.0);
            for (std::size_t i = 0; i < influence.bone.size(); ++i)
                if (influence.weight[i] > 0.0F)
                    place += double(influence.weight[i]) *
                             branches[influence.bone[i]].point(glm::dvec3(points[v]));
            places[v] = glm::vec3(place);
        }
    }
}

LifePose::LifePose(const GrowthHistory& history, const WholeLife& life, const PrunedTree& wood)
    : m_history(history)
    , m_life(life)
    , m_wood(wood)
{
    const Skeleton& tree = wood.skeleton;
    for (Index b = 0; b < tree.size(); ++b) {
        const Index parent = tree.parent[b];
        const Index end = life.metamer[wood.run(b).back()];
        const Index below = parent == noIndex ? noIndex : m_end[parent];
        Index first = end;
        while (history.parent[first] != noIndex && history.parent[first] != below &&
               history.axis[history.parent[first]] == history.axis[end])
            first = history.parent[first];
        m_end.push_back(end);
        m_first.push_back(first);
        m_goesOn.push_back(below != noIndex && history.axis[below] == history.axis[end]);
        Branch rest;
        rest.from = tree.p0[b];
        rest.restLength = std::max(tree.length(b), 1e-9);
        rest.along = (tree.p1[b] - tree.p0[b]) / rest.restLength;
        if (below != noIndex) {
            const double sine = glm::length(glm::cross(rest.along, m_rest[parent].along));
            rest.restCover = forkReach * tree.a1[parent] / (m_goesOn[b] ? 1.0 : std::max(sine, leastSine));
        }
        rest.restCrotch = forkReach * tree.a1[b];
        const double most = 0.9 * rest.restLength, both = rest.restCover + rest.restCrotch;
        if (both > most) {
            rest.restCover *= most / both;
            rest.restCrotch *= most / both;
        }
        m_rest.push_back(rest);
    }
}

double LifePose::scaleOf(Index metamer, const WoodAtAge& wood) const
{
    const double rest = m_life.radius[metamer];
    return std::max(wood.radius[metamer], goneRadius) / std::max(rest, goneRadius);
}

/// The last metamer of a branch that stands; noIndex: none does.
Index LifePose::lastAlive(Index branch, const WoodAtAge& wood) const
{
    for (Index i = m_end[branch];; i = m_history.parent[i]) {
        if (wood.radius[i] > 0.0)
            return i;
        if (i == m_first[branch])
            return noIndex;
    }
}

void LifePose::place(Index b, const WoodAtAge& wood, Placed& placed) const
{
    Branch& now = placed.branches.emplace_back(m_rest[b]);
    const Index parent = m_wood.skeleton.parent[b];
    const Branch* const below = parent == noIndex ? nullptr : &placed.branches[parent];
    now.foot = below ? below->end() : now.from;
    now.turn = below ? below->turn : now.turn;
    const Index last = !below || below->isWhole ? lastAlive(b, wood) : noIndex;
    now.cover = below ? now.restCover * below->endScale : 0.0;
    if (last == noIndex)
        return hide(b, below, now);
    const glm::dvec3 way = wood.at[last] - now.foot;
    const double length = glm::length(way);
    if (length > goneLength)
        now.turn = turnBetween(now.along, way / length);
    now.reach = last + 1;
    now.isWhole = last == m_end[b];
    now.footScale = m_goesOn[b] && below ? below->endScale : scaleOf(m_first[b], wood);
    now.endScale = wood.radius[last] / std::max(m_life.radius[m_end[b]], goneRadius);
    now.crotch = now.restCrotch * now.endScale;
    now.length = std::max(length, m_goesOn[b] || !below ? goneLength : now.cover + goneLength);
    // Where forks are close together they share what there is between them.
    const double both = now.cover + now.crotch, most = 0.9 * now.length;
    if (both > most) {
        now.cover *= most / both;
        now.crotch *= most / both;
    }
}

/// What does not stand lies where it leaves the wood, folded to and fro.
void LifePose::hide(Index b, const Branch* below, Branch& now) const
{
    now.footScale = now.endScale = goneRadius / std::max(m_life.radius[m_first[b]], goneRadius);
    if (m_goesOn[b] && below)
        now.footScale = below->endScale;
    now.crotch = now.restCrotch * now.endScale;
    now.length = now.cover + now.crotch + goneLength;
    if (below && below->reach == 0 && below->length > 0.0) {
        now.cover = -now.cover;
        now.crotch = -now.crotch;
        now.length = -now.length;
    }
}

LifePose::Placed LifePose::at(double age) const
{
    const WoodAtAge wood = woodAtAge(m_history, age);
    Placed placed;
    placed.branches.reserve(m_rest.size());
    for (Index b = 0; b < m_rest.size(); ++b)
        place(b, wood, placed);
    return placed;
}

} // namespace ramure
