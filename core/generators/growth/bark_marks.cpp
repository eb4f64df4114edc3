#include "core/generators/growth/bark_marks.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <map>
#include <vector>

namespace ramure::growth {

namespace {

constexpr double leastScar = 0.01, leastHollow = 0.04; ///< m, radii of what was shed
constexpr double healedAway = 3.0; ///< radii of wood over a scar, from which on nothing shows
constexpr double widest = 0.5;     ///< of the wood that carries it

class BarkMarker
{
public:
    BarkMarker(const GrowthHistory& history, int age, std::span<const Index> ends, Skeleton& tree);
    void addScars();
    void addBurrs();

private:
    /// A limb that is gone, in its last year.
    struct Wound
    {
        Index base;        ///< metamer
        double own = 0.0;  ///< m, radius
        double stem = 0.0; ///< m, radius of what carried it
    };
    [[nodiscard]] double radiusOf(std::uint16_t pipes) const;
    [[nodiscard]] std::vector<Wound> wounds() const;
    void put(OrganKind kind, Index metamer, const glm::dvec3& out, double size, double healed);

    const GrowthHistory& m_history;
    const int m_age;
    Skeleton& m_tree;
    std::vector<Index> m_branch;  ///< by metamer: on which it lies; noIndex: none
    std::vector<float> m_share;   ///< by metamer: where it ends there
    std::vector<double> m_radius; ///< m, by metamer, now
};

BarkMarker::BarkMarker(const GrowthHistory& history, int age, std::span<const Index> ends, Skeleton& tree)
    : m_history(history)
    , m_age(age)
    , m_tree(tree)
    , m_branch(history.size(), noIndex)
    , m_share(history.size(), 1.0F)
    , m_radius(history.size(), 0.0)
{
    for (Index branch = 0; branch < tree.size(); ++branch) {
        std::vector<Index> own;
        double length = 0.0;
        for (Index i = ends[branch];
             i != noIndex && m_branch[i] == noIndex && history.axis[i] == history.axis[ends[branch]];
             i = history.parent[i]) {
            m_branch[i] = branch;
            own.push_back(i);
            length += double(history.length[i]);
        }
        double above = 0.0;
        for (const Index i : own) {
            m_share[i] = float(length > 0.0 ? 1.0 - above / length : 1.0);
            above += double(history.length[i]);
        }
    }
    auto pipes = history.pipesAt(age).begin();
    for (Index i = 0; i < history.size() && int(history.birth[i]) < age; ++i)
        if (int(history.death[i]) > age)
            m_radius[i] = radiusOf(*pipes++);
}

double BarkMarker::radiusOf(std::uint16_t pipes) const
{
    return m_history.params.tipRadius *
           maths::pow(double(pipesOf(pipes)), 1.0 / m_history.params.pipeExponent);
}

/// Limbs whose stem stands, by their birth.
std::vector<BarkMarker::Wound> BarkMarker::wounds() const
{
    const GrowthHistory& h = m_history;
    std::map<int, std::vector<Index>> byYear; // the last age at which they stood
    for (Index i = 0; i < h.size() && int(h.birth[i]) < m_age; ++i)
        if (const Index below = h.parent[i];
            below != noIndex && int(h.death[i]) <= m_age && int(h.death[i]) > int(h.birth[i]) + 1 &&
            h.axis[below] != h.axis[i] && m_branch[below] != noIndex && m_radius[below] > leastScar)
            byYear[int(h.death[i]) - 1].push_back(i);
    std::vector<Wound> out;
    std::vector<std::uint16_t> pipes(h.size(), 0);
    for (const auto& [age, bases] : byYear) {
        auto row = h.pipesAt(age).begin();
        for (Index i = 0; i <= bases.back(); ++i)
            if (int(h.birth[i]) < age && int(h.death[i]) > age)
                pipes[i] = *row++;
        for (const Index base : bases)
            if (const double own = radiusOf(pipes[base]); own >= leastScar)
                out.push_back({base, own, radiusOf(pipes[h.parent[base]])});
    }
    return out;
}

void BarkMarker::put(OrganKind kind, Index metamer, const glm::dvec3& out, double size, double healed)
{
    const Index branch = m_branch[metamer];
    const glm::dvec3 way = m_tree.p1[branch] - m_tree.p0[branch];
    const double length = glm::length(way);
    const glm::dvec3 axis = length > 0.0 ? way / length : glm::dvec3(0.0);
    const glm::dvec3 aside = out - glm::dot(out, axis) * axis;
    if (!(length > 0.0) || !(glm::length(aside) > 0.05))
        return;
    m_tree.organs.push_back({.branch = branch,
                             .kind = kind,
                             .share = std::clamp(double(m_share[metamer]), 0.0, 1.0),
                             .axis = axis,
                             .heading = glm::normalize(aside),
                             .up = axis,
                             .size = size,
                             .healed = healed});
}

void BarkMarker::addScars()
{
    const GrowthParams& params = m_history.params;
    std::vector<Wound> all = wounds();
    std::ranges::stable_sort(all, std::greater(), &Wound::own); // where there is no room, the largest stays
    for (const Wound& wound : all) {
        const Index stem = m_history.parent[wound.base];
        const std::uint64_t address = m_history.axisAddress[m_history.axis[wound.base]];
        Random chance(m_history.seed, RandomStream::BarkMarks, address);
        const bool isThere = chance.unit() < params.scars;
        const bool rots = chance.unit() < params.hollows && wound.own >= leastHollow;
        const double size = std::min(wound.own, widest * m_radius[stem]);
        const double healed = std::max(0.0, m_radius[stem] - wound.stem) / size;
        if (isThere && (rots || healed < healedAway))
            put(rots ? OrganKind::Hollow : OrganKind::Scar, stem, glm::dvec3(m_history.direction[wound.base]),
                size, rots ? 0.0 : healed);
    }
}

/// They swell with the wood that they are in.
void BarkMarker::addBurrs()
{
    constexpr double leastWood = 0.06, perMetres = 10.0; // m
    const GrowthHistory& h = m_history;
    std::vector<std::uint64_t> onAxis(h.axisAddress.size(), 0);
    for (Index i = 0; i < h.size() && int(h.birth[i]) < m_age; ++i) {
        const std::uint64_t rank = ++onAxis[h.axis[i]];
        if (m_branch[i] == noIndex || m_radius[i] < leastWood || h.axisOrder[h.axis[i]] > 1)
            continue;
        Random chance(h.seed, RandomStream::BarkMarks, h.axisAddress[h.axis[i]] + 2 * rank);
        if (chance.unit() * perMetres >= h.params.burrs * double(h.length[i]))
            continue;
        const double size = m_radius[i] * chance.range(0.2, widest);
        glm::dvec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] = chance.range(-1.0, 1.0);
        put(OrganKind::Burr, i, out, size, 0.0);
    }
}

} // namespace

void markBark(const GrowthHistory& history, int age, std::span<const Index> ends, Skeleton& tree)
{
    if (!(history.params.scars > 0.0) && !(history.params.burrs > 0.0))
        return;
    BarkMarker marker(history, age, ends, tree);
    if (history.params.scars > 0.0)
        marker.addScars();
    if (history.params.burrs > 0.0)
        marker.addBurrs();
}

} // namespace ramure::growth
