#include "core/surface/foliage/venation.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr std::array stages{0.22, 0.34, 0.5, 0.72, 1.0}; ///< how large the blade is, of what it becomes

bool isInside(const FlatBlade& blade, const glm::dvec2& at)
{
    const auto side = [&](const glm::dvec2& a, const glm::dvec2& b) {
        return (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    };
    return std::ranges::any_of(blade.triangles, [&](const glm::uvec3& t) {
        const glm::dvec2 &a = blade.points[t.x], &b = blade.points[t.y], &c = blade.points[t.z];
        return side(a, b) >= 0.0 && side(b, c) >= 0.0 && side(c, a) >= 0.0;
    });
}

struct Source
{
    glm::dvec2 at;
    Index nearest = 0; ///< node
    double away = 0.0;
};

class Growth
{
public:
    Growth(const FlatBlade& blade, double gap, std::uint64_t seed)
        : m_blade(blade)
        , m_gap(gap)
        , m_step(0.3 * gap)
        , m_random(seed, RandomStream::Venation)
    {
        m_nodes.push_back(glm::dvec2(0.0));
        m_parents.push_back(noIndex);
        m_low = m_high = glm::dvec2(0.0);
        for (const glm::dvec2& point : blade.points) {
            m_low = glm::min(m_low, point);
            m_high = glm::max(m_high, point);
        }
    }

    /// Pieces of a straight way from a node. Returns the last one; it ends where the blade does.
    Index addRib(Index from, const glm::dvec2& end)
    {
        const glm::dvec2 start = m_nodes[from];
        const int pieces = std::max(1, static_cast<int>(glm::length(end - start) / m_step));
        Index last = from;
        for (int i = 1; i <= pieces; ++i) {
            const glm::dvec2 at = glm::mix(start, end, static_cast<double>(i) / pieces);
            if (!isInside(m_blade, at))
                break;
            last = add(at, last);
        }
        return last;
    }
    /// Along a rib that stands already: veins to its right and left, bent a little to its end.
    void addLaterals(Index first, Index last, double spacing, double angle)
    {
        const glm::dvec2 way = glm::normalize(m_nodes[last] - m_nodes[first]), side(way.y, -way.x);
        const double length = glm::length(m_nodes[last] - m_nodes[first]);
        const auto [across, ahead] = maths::sincos(angle);
        double next = 0.35 * spacing, turn = 1.0;
        const auto nodes = static_cast<Index>(m_nodes.size());
        for (Index node = first + 1; node < std::min(last, nodes); ++node) {
            const double along = glm::length(m_nodes[node] - m_nodes[first]);
            if (along < next || along > 0.9 * length)
                continue;
            next = along + 0.5 * spacing;
            turn = -turn;
            Index from = node;
            for (const double bend : {0.0, 0.35})
                from =
                    addRib(from, m_nodes[from] + (bend > 0.0 ? 1.0 : 0.22) *
                                                     ((across - bend) * turn * side + (ahead + bend) * way));
        }
    }
    [[nodiscard]] Index count() const { return static_cast<Index>(m_nodes.size()); }
    void run()
    {
        for (const double size : stages) {
            sow(m_gap / size);
            // Each round reaches at least one source, or the last ones cannot be reached.
            for (int round = 0; round < mostRounds && !m_sources.empty(); ++round)
                if (!grow(m_gap / size))
                    break;
            m_sources.clear();
        }
    }
    [[nodiscard]] std::vector<Vein> veins() const
    {
        std::vector<double> cubes(m_nodes.size(), 0.0);
        for (std::size_t i = m_nodes.size() - 1; i > 0; --i) {
            if (cubes[i] == 0.0)
                cubes[i] = 1.0; // a tip
            cubes[m_parents[i]] += cubes[i];
        }
        std::vector<Vein> all;
        all.reserve(m_nodes.size() - 1);
        for (std::size_t i = 1; i < m_nodes.size(); ++i)
            all.push_back({m_nodes[m_parents[i]], m_nodes[i], maths::pow(cubes[i], 1.0 / 3.0)});
        return all;
    }

private:
    static constexpr int mostRounds = 400, mostDarts = 4000;

    Index add(const glm::dvec2& at, Index parent)
    {
        const auto node = static_cast<Index>(m_nodes.size());
        m_nodes.push_back(at);
        m_parents.push_back(parent);
        for (Source& source : m_sources)
            if (const double away = glm::length(source.at - at); away < source.away)
                source = {source.at, node, away};
        return node;
    }
    /// Darts that come too near to a vein or to another source are thrown away.
    void sow(double gap)
    {
        for (int dart = 0; dart < mostDarts; ++dart) {
            const double x = m_random.unit(), y = m_random.unit();
            Source source{m_low + glm::dvec2(x, y) * (m_high - m_low)};
            const bool isCrowded = std::ranges::any_of(
                m_sources, [&](const Source& other) { return glm::length(other.at - source.at) < gap; });
            if (isCrowded || !isInside(m_blade, source.at))
                continue;
            source.away = glm::length(source.at - m_nodes[0]);
            for (Index node = 1; node < m_nodes.size(); ++node)
                if (const double away = glm::length(source.at - m_nodes[node]); away < source.away) {
                    source.away = away;
                    source.nearest = node;
                }
            if (source.away > 0.7 * gap)
                m_sources.push_back(source);
        }
    }
    [[nodiscard]] bool isNear(Index parent, const glm::dvec2& at) const
    {
        for (Index node = parent + 1; node < m_nodes.size(); ++node)
            if (m_parents[node] == parent && glm::length(m_nodes[node] - at) < 0.6 * m_step)
                return true;
        return false;
    }
    /// One step of every vein that is nearest to a source. False: nothing grew.
    bool grow(double gap)
    {
        std::vector<std::pair<Index, glm::dvec2>> ways;
        for (const Source& source : m_sources) {
            const glm::dvec2 way = (source.at - m_nodes[source.nearest]) / source.away;
            const auto known = std::ranges::find(ways, source.nearest, &std::pair<Index, glm::dvec2>::first);
            if (known == ways.end())
                ways.emplace_back(source.nearest, way);
            else
                known->second += way;
        }
        bool grew = false;
        for (const auto& each : ways) {
            const Index node = each.first;
            const glm::dvec2& way = each.second;
            if (glm::length(way) < 0.05)
                continue; // between two sources that pull it apart
            const glm::dvec2 at = m_nodes[node] + m_step * glm::normalize(way);
            // Sources on either side of what it would grow cannot be reached from here.
            const bool isThere = isNear(node, at);
            if (isThere || !isInside(m_blade, at)) {
                std::erase_if(m_sources, [&](const Source& source) { return source.nearest == node; });
                continue;
            }
            add(at, node);
            grew = true;
        }
        const double reached = std::max(1.2 * m_step, 0.45 * gap);
        const auto before = m_sources.size();
        std::erase_if(m_sources, [&](const Source& source) { return source.away < reached; });
        return grew || m_sources.size() < before;
    }

    const FlatBlade& m_blade;
    double m_gap, m_step;
    Random m_random;
    glm::dvec2 m_low{0.0}, m_high{0.0};
    std::vector<glm::dvec2> m_nodes;
    std::vector<Index> m_parents;
    std::vector<Source> m_sources;
};

/// The lobes' ends of a star: points farther out than both neighbours on the rim.
std::vector<glm::dvec2> lobeEnds(const FlatBlade& star)
{
    std::vector<glm::dvec2> ends;
    for (std::size_t i = 2; i + 1 < star.points.size(); ++i) {
        const double own = glm::length(star.points[i]);
        if (own > glm::length(star.points[i - 1]) && own > glm::length(star.points[i + 1]))
            ends.push_back(0.94 * star.points[i]);
    }
    return ends;
}

} // namespace

std::vector<Vein> venation(const FlatBlade& blade, const std::vector<glm::dvec2>& ribs, double gap,
                           std::uint64_t seed)
{
    if (blade.triangles.empty())
        return {};
    Growth growth(blade, std::clamp(gap, 0.02, 0.5), seed);
    for (const glm::dvec2& rib : ribs) {
        const Index first = growth.count(), last = growth.addRib(0, rib);
        if (last >= first)
            growth.addLaterals(first, last, ribs.size() > 1 ? 0.2 : 0.17, 0.85);
    }
    growth.run();
    return growth.veins();
}

/// A palm's fan is folded along straight ribs, one to each lobe's end and lesser ones beside it: there is no
/// net.
static std::vector<Vein> pleats(const FlatBlade& fan)
{
    const std::vector<glm::dvec2> ends = lobeEnds(fan);
    std::vector<Vein> all;
    for (std::size_t i = 1; i < fan.points.size(); ++i) {
        const glm::dvec2 end = 0.94 * fan.points[i];
        all.push_back({glm::dvec2(0.0), end, std::ranges::find(ends, end) != ends.end() ? 4.0 : 1.0});
    }
    return all;
}

VeinedBlade veinedBlade(LeafShape shape)
{
    constexpr int finest = 3;
    const LeafRow& row = leafRow(shape);
    VeinedBlade out;
    const glm::dvec2 tip(0.0, 0.97);
    if (row.family == LeafFamily::Star) {
        out.blade = starOf(row, 1.0, finest);
        if (shape == LeafShape::FanPalm) {
            out.veins = pleats(out.blade);
            return out;
        }
        // A fan's veins fork from the foot on; it has no ribs.
        out.veins = venation(out.blade, row.lobes > 0 ? lobeEnds(out.blade) : std::vector<glm::dvec2>{},
                             0.045, static_cast<std::uint64_t>(shape));
        return out;
    }
    const bool stands = row.family == LeafFamily::Tuft || row.family == LeafFamily::Shoot;
    const bool isNeedle = stands || row.width < 0.15;
    out.blade = stands ? needleOf(row, 1.0) : bladeOf(row, 1.0, 2 * finest - 1, row.width > 0.3);
    out.veins = isNeedle ? std::vector{Vein{glm::dvec2(0.0), tip, 4.0}}
                         : venation(out.blade, {tip}, 0.05 + 0.02 * (1.0 - row.width),
                                    static_cast<std::uint64_t>(shape));
    return out;
}

} // namespace ramure
