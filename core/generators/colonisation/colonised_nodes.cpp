#include "core/generators/colonisation/colonised_nodes.h"

#include "core/generators/colonisation/growth_space.h"
#include "core/generators/grammar/turtle.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

namespace ramure {
namespace {

constexpr double unseen = std::numeric_limits<double>::infinity();

/// Points in the order of the cells of a grid, so that the neighbours of a node lie in few runs.
class PointGrid
{
public:
    PointGrid(const std::vector<glm::dvec3>& points, double reach)
    {
        glm::dvec3 max = m_min = points.front();
        for (const glm::dvec3& p : points) {
            m_min = glm::min(m_min, p);
            max = glm::max(max, p);
        }
        const glm::dvec3 size = max - m_min;
        // No more cells than help.
        m_cell = std::max(reach, std::max({size.x, size.y, size.z}) / 64.0);
        for (int k = 0; k < 3; ++k)
            m_count[std::size_t(k)] = static_cast<int>(size[k] / m_cell) + 1;
        m_first.assign(std::size_t(m_count[0]) * std::size_t(m_count[1]) * std::size_t(m_count[2]) + 1, 0);
        std::vector<std::size_t> cells(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::array<int, 3> c = cellOf(points[i]);
            cells[i] = number(c[0], c[1], c[2]);
            ++m_first[cells[i] + 1];
        }
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
        std::vector<Index> next(m_first.begin(), m_first.end() - 1);
        m_points.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            m_points[next[cells[i]]++] = points[i];
    }

    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return m_points; }

    /// Calls \p look(first, end) for the runs of points that may lie within \p reach of \p at.
    template <class Look> void around(const glm::dvec3& at, double reach, Look&& look) const
    {
        const std::array<int, 3> low = cellOf(at - reach), high = cellOf(at + reach);
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                look(m_first[number(low[0], y, z)], m_first[number(high[0], y, z) + 1]);
    }

private:
    [[nodiscard]] std::array<int, 3> cellOf(const glm::dvec3& p) const
    {
        std::array<int, 3> cell{};
        for (int k = 0; k < 3; ++k) {
            const double most = m_count[std::size_t(k)] - 1;
            cell[std::size_t(k)] = static_cast<int>(std::clamp((p[k] - m_min[k]) / m_cell, 0.0, most));
        }
        return cell;
    }
    [[nodiscard]] std::size_t number(int x, int y, int z) const
    {
        return (std::size_t(z) * std::size_t(m_count[1]) + std::size_t(y)) * std::size_t(m_count[0]) +
               std::size_t(x);
    }

    glm::dvec3 m_min{0.0};
    double m_cell = 1.0;
    std::array<int, 3> m_count{};
    std::vector<Index> m_first;
    std::vector<glm::dvec3> m_points;
};

class Colony
{
public:
    Colony(const ColonisationParams& params, const std::vector<glm::dvec3>& points)
        : m_params(params)
        , m_grid(points, params.influence)
        , m_distance(points.size(), unseen)
        , m_nearest(points.size(), noIndex)
    {
    }

    Expected<ColonisedNodes> run(const Progress& progress)
    {
        addNode(glm::dvec3(0.0), noIndex);
        for (bool grows = raiseTrunk(); grows;) {
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            grows = growRound();
            const std::size_t all = m_distance.size();
            progress.report(double(all - m_seen.size()) / double(all));
            if (m_nodes.at.size() > maxBranches)
                return refuse(ErrorCode::Limit,
                              RAMURE_NOOP("the branches have more pieces than the limit of %1"),
                              "colonisation.step", {std::to_string(maxBranches)});
        }
        if (m_nodes.at.size() < 2)
            return refuse(ErrorCode::Invalid,
                          RAMURE_NOOP("no point of the crown comes within sight of the trunk"),
                          "colonisation.influence", {});
        return std::move(m_nodes);
    }

private:
    static tl::unexpected<Error> refuse(ErrorCode code, const char* text, const char* path,
                                        std::vector<std::string> args)
    {
        auto error = fail(code, text, std::move(args));
        error.value().path = path;
        return error;
    }

    /// Behind an obstacle.
    [[nodiscard]] bool isHidden(const glm::dvec3& at, const glm::dvec3& from) const
    {
        return m_params.space.space() && m_params.space.space()->blocks(from, at);
    }

    /// Up until a point is in sight. \return whether one is; if not, the foot is all there is.
    bool raiseTrunk()
    {
        const double top = crownTop(m_params);
        while (m_seen.empty() && m_nodes.at.back().y < top && m_nodes.at.size() <= maxBranches) {
            const glm::dvec3 last = m_nodes.at.back(), next = last + glm::dvec3(0.0, m_params.step, 0.0);
            if (isHidden(next, last))
                break;
            addNode(next, Index(m_nodes.at.size() - 1));
        }
        if (!m_seen.empty())
            return true;
        if (m_nodes.at.size() <= maxBranches)
            m_nodes.at.resize(1), m_nodes.parent.resize(1);
        return false;
    }

    /// All points that see it and no nearer node are its own from now on.
    void addNode(const glm::dvec3& at, Index parent)
    {
        const auto node = static_cast<Index>(m_nodes.at.size());
        m_nodes.at.push_back(at);
        m_nodes.parent.push_back(parent);
        m_pull.emplace_back(0.0);
        m_stuck.push_back(false);
        m_pulledIn.push_back(0);
        m_lastChild.push_back(noIndex);
        m_sibling.push_back(parent == noIndex ? noIndex : std::exchange(m_lastChild[parent], node));
        const double reach = m_params.influence * m_params.influence;
        const std::vector<glm::dvec3>& points = m_grid.points();
        m_grid.around(at, m_params.influence, [&](Index first, Index end) {
            for (Index i = first; i < end; ++i) {
                const glm::dvec3 way = points[i] - at;
                const double distance = glm::dot(way, way);
                if (distance >= m_distance[i] || distance > reach || isHidden(points[i], at))
                    continue;
                if (m_distance[i] == unseen)
                    m_seen.push_back(i);
                m_distance[i] = distance;
                m_nearest[i] = node;
            }
        });
    }

    /// Points that are reached, and those that nothing gets nearer to, draw no more.
    void dropReached()
    {
        const double kill = m_params.kill * m_params.kill;
        std::erase_if(m_seen, [&](Index i) {
            const bool gone = m_distance[i] < kill || m_stuck[m_nearest[i]];
            if (gone)
                m_distance[i] = -1.0;
            return gone;
        });
    }

    /// Two points on either side can draw a node to the same place for ever.
    [[nodiscard]] bool isTaken(const glm::dvec3& at, Index node) const
    {
        for (Index child = m_lastChild[node]; child != noIndex; child = m_sibling[child])
            if (glm::length(m_nodes.at[child] - at) < 0.25 * m_params.step)
                return true;
        return false;
    }

    bool growRound()
    {
        dropReached();
        if (m_seen.empty())
            return false;
        m_active.clear();
        ++m_round;
        const std::vector<glm::dvec3>& points = m_grid.points();
        for (const Index i : m_seen) {
            const Index node = m_nearest[i];
            if (std::exchange(m_pulledIn[node], m_round) != m_round)
                m_active.push_back(node);
            m_pull[node] += (points[i] - m_nodes.at[node]) / std::sqrt(m_distance[i]);
        }
        for (const Index node : m_active)
            growFrom(node);
        return true;
    }

    void growFrom(Index node)
    {
        const double pull = glm::length(m_pull[node]);
        const glm::dvec3 towards = (pull > 1e-9 ? m_pull[node] / pull : glm::dvec3(0.0)) + m_params.tropism;
        m_pull[node] = glm::dvec3(0.0);
        const double length = glm::length(towards);
        const glm::dvec3 to = m_nodes.at[node] + m_params.step / std::max(length, 1e-9) * towards;
        const glm::dvec3& from = m_nodes.at[node];
        // Wood is thicker than its axis: it keeps away from obstacles by half a step.
        const bool blocked =
            length < 1e-9 || to.y <= 0.0 || isTaken(to, node) || isHidden(to + 0.5 * (to - from), from);
        if (blocked)
            m_stuck[node] = true;
        else
            addNode(to, node);
    }

    const ColonisationParams& m_params;
    PointGrid m_grid;
    ColonisedNodes m_nodes;
    std::vector<glm::dvec3> m_pull;            ///< by node: sum of directions to its points
    std::vector<bool> m_stuck;                 ///< by node
    std::vector<std::uint32_t> m_pulledIn;     ///< by node: the last round in which points drew it
    std::vector<Index> m_lastChild, m_sibling; ///< by node: its children, the last one first
    std::vector<double> m_distance; ///< by point: squared, to the nearest node; below 0: draws no more
    std::vector<Index> m_nearest;   ///< by point
    std::vector<Index> m_seen;      ///< points that draw
    std::vector<Index> m_active;
    std::uint32_t m_round = 0;
};

} // namespace

Expected<ColonisedNodes> colonise(const ColonisationParams& params, const std::vector<glm::dvec3>& points,
                                  const Progress& progress)
{
    return Colony(params, points).run(progress);
}

} // namespace ramure
