#include "core/generators/colonisation/colonisation.h"

#include "core/generators/colonisation/colonised_nodes.h"
#include "core/generators/colonisation/crown_shape.h"
#include "core/generators/grammar/branch_keys.h"
#include "core/math/reproducible.h"
#include <algorithm>

namespace ramure {
namespace {

/// Makes axes of nodes: who goes on, what is left out, how thick, how smooth.
class AxisMaker
{
public:
    AxisMaker(const ColonisationParams& params, ColonisedNodes nodes)
        : m_params(params)
        , m_at(std::move(nodes.at))
        , m_parent(std::move(nodes.parent))
    {
    }

    Skeleton run()
    {
        weigh();
        leaveOut();
        smooth();
        m_waiting.push_back({noIndex, 0, noIndex, 0, 0});
        while (!m_waiting.empty()) {
            const Start next = m_waiting.back();
            m_waiting.pop_back();
            draw(next);
        }
        return std::move(m_skeleton);
    }

private:
    /// Of an axis.
    struct Start
    {
        Index fork = noIndex;   ///< node; noIndex: the root
        Index first = 0;        ///< node after the fork; of the root, the foot itself
        Index branch = noIndex; ///< that ends at the fork
        Index number = 0;       ///< among what starts there; 0 goes on
        Index level = 0;
    };

    [[nodiscard]] Index size() const { return static_cast<Index>(m_at.size()); }

    /// Radii from the tips down, how far each node's wood reaches, and the child that goes on.
    void weigh()
    {
        m_radius.assign(size(), 0.0);
        m_reach.assign(size(), 0.0);
        m_next.assign(size(), noIndex);
        const double tip = maths::pow(m_params.tipRadius, m_params.exponent);
        for (Index i = size(); i-- > 0;) {
            const double carried = m_radius[i] > 0.0 ? m_radius[i] : tip; // so far the sum of the powers
            m_radius[i] = maths::pow(carried, 1.0 / m_params.exponent);
            const Index parent = m_parent[i];
            if (parent == noIndex)
                continue;
            m_radius[parent] += carried;
            m_reach[parent] = std::max(m_reach[parent], m_reach[i] + glm::length(m_at[i] - m_at[parent]));
            const Index rival = m_next[parent];
            if (rival == noIndex || m_radius[i] >= m_radius[rival])
                m_next[parent] = i;
        }
    }

    /// Short side twigs, with all that they carry, and what does not leave the wood.
    void leaveOut()
    {
        m_sides.assign(size(), {});
        m_out.assign(size(), false);
        for (Index i = 1; i < size(); ++i) {
            const Index parent = m_parent[i];
            if (m_next[parent] == i) {
                m_out[i] = m_out[parent];
                continue;
            }
            const double length = m_reach[i] + glm::length(m_at[i] - m_at[parent]);
            m_out[i] = m_out[parent] || length < std::max(m_params.thinning, 2.0 * m_radius[parent]);
            if (!m_out[i])
                m_sides[parent].push_back(i);
        }
    }

    /// Each node moves towards the middle of its neighbours on the axis; the side axes move with their forks.
    void smooth()
    {
        constexpr int rounds = 6;
        std::vector<glm::dvec3> moved;
        for (int round = 0; round < rounds && m_params.smoothing > 0.0; ++round) {
            moved = m_at;
            for (Index i = 1; i < size(); ++i) {
                const Index next = m_next[i], before = m_parent[i];
                // The foot stands, and so does the first step out of a fork: there is the angle of the
                // branch.
                const bool ends = next == noIndex || (m_next[before] != i && round > 1);
                if (!ends)
                    moved[i] += m_params.smoothing * (0.5 * (m_at[before] + m_at[next]) - m_at[i]);
            }
            m_at.swap(moved);
        }
    }

    /// The nodes that stay, from the first to the tip: none closer to the one before than the wood is thick.
    /// What forks off at those that go starts at the one before.
    void draw(const Start& start)
    {
        const bool isRoot = start.fork == noIndex;
        Index last = isRoot ? 0 : start.fork, branch = start.branch;
        Index number = start.number;
        double radius = isRoot ? m_radius[0] : m_radius[start.first];
        double room = isRoot ? 0.0 : 1.5 * m_radius[start.fork];
        for (Index i = isRoot ? m_next[0] : start.first; i != noIndex; i = m_next[i]) {
            const double length = glm::length(m_at[i] - m_at[last]);
            const bool isTip = m_next[i] == noIndex;
            if (isTip || length >= std::max({room, 1.2 * m_radius[i], 0.9 * m_params.step})) {
                const glm::dvec3 from = branch == noIndex ? m_at[0] : m_skeleton.p1[branch];
                const double end = std::min(m_radius[i], radius);
                branch = addPiece(branch, from, m_at[i], radius, end, start.level, number);
                number = 0;
                room = 0.0;
                radius = end;
                last = i;
            }
            if (branch != noIndex)
                for (const Index side : m_sides[i])
                    m_waiting.push_back(
                        {last, side, branch, ++m_sideCount[branch], m_skeleton.level[branch] + 1});
        }
    }

    Index addPiece(Index parent, const glm::dvec3& from, const glm::dvec3& to, double radius, double end,
                   Index level, Index number)
    {
        const Index i = m_skeleton.add(parent, from, to, radius, end, level);
        m_skeleton.key[i] =
            branchKeyBelow(parent == noIndex ? rootBranchKey : m_skeleton.key[parent], number);
        m_sideCount.push_back(0);
        return i;
    }

    const ColonisationParams& m_params;
    std::vector<glm::dvec3> m_at;
    std::vector<Index> m_parent;
    std::vector<double> m_radius;
    std::vector<double> m_reach; ///< m to the farthest tip above
    std::vector<Index> m_next;   ///< goes on; noIndex: a tip
    std::vector<std::vector<Index>> m_sides;
    std::vector<bool> m_out;
    std::vector<Start> m_waiting;
    std::vector<Index> m_sideCount; ///< by branch: axes that start at its end
    Skeleton m_skeleton;
};

} // namespace

Expected<Skeleton> growColonisation(const ColonisationParams& params, std::uint64_t seed,
                                    const Progress& progress)
{
    const auto points = crownPoints(params, seed, progress.part(0.0, 0.2));
    RAMURE_TRY(points);
    auto nodes = colonise(params, *points, progress.part(0.2, 1.0));
    RAMURE_TRY(nodes);
    return AxisMaker(params, std::move(*nodes)).run();
}

} // namespace ramure
