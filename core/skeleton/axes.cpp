#include "core/skeleton/axes.h"

#include "core/math/frame.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

class AxisFinder
{
public:
    explicit AxisFinder(const Skeleton& skeleton)
        : m_skeleton(skeleton)
        , m_next(skeleton.size(), noIndex)
        , m_mates(skeleton.size(), 0)
        , m_frames(skeleton.size())
    {
        m_tree.axisOf.resize(skeleton.size());
        m_tree.forksBelow.resize(skeleton.size(), 0);
        m_tree.start.resize(skeleton.size(), 0.0);
    }

    TreeAxes run()
    {
        // Whether a fork starts at a branch's end must be known before anybody counts it.
        for (Index i = 0; i < m_skeleton.size(); ++i) {
            const Index parent = m_skeleton.parent[i];
            if (parent == noIndex)
                ++m_roots;
            else if (m_next[parent] == noIndex && continues(i))
                m_next[parent] = i;
            else
                ++m_mates[parent];
        }
        m_seen.assign(m_skeleton.size(), 0);
        for (Index i = 0; i < m_skeleton.size(); ++i)
            add(i);
        for (Axis& axis : m_tree.axes) {
            const double whole = axis.parent == noIndex ? 0.0 : m_tree.axes[axis.parent].length;
            axis.share = whole > 0.0 ? axis.s / whole : 0.0;
        }
        listNodes();
        return std::move(m_tree);
    }

private:
    void add(Index i)
    {
        const Index parent = m_skeleton.parent[i];
        const glm::dvec3 along = m_skeleton.p1[i] - m_skeleton.p0[i];
        const double length = glm::length(along);
        const Frame before = parent == noIndex ? Frame() : m_frames[parent];
        m_frames[i] = length > 0.0 ? transported(before, along / length) : before;
        if (parent != noIndex && m_next[parent] == i) {
            m_tree.axisOf[i] = m_tree.axisOf[parent];
            m_tree.forksBelow[i] = m_tree.forksBelow[parent] + (m_mates[parent] > 0 ? 1 : 0);
            m_tree.start[i] = m_tree.start[parent] + m_skeleton.length(parent);
        } else {
            m_tree.axisOf[i] = static_cast<Index>(m_tree.axes.size());
            m_tree.axes.push_back(started(i, before, length > 0.0 ? along / length : before.tangent));
        }
        Axis& axis = m_tree.axes[m_tree.axisOf[i]];
        axis.length = m_tree.start[i] + length;
        axis.forks = m_tree.forksBelow[i] + (m_mates[i] > 0 ? 1 : 0);
        ++axis.nodes;
    }

    /// Whether a branch may be the next one of its parent's axis.
    [[nodiscard]] bool continues(Index i) const
    {
        return m_skeleton.axisStarts.empty() ? m_skeleton.level[i] == m_skeleton.level[m_skeleton.parent[i]]
                                             : startAt(i) == m_skeleton.axisStarts.end();
    }
    /// Where the list of the axes that edits left has a branch.
    [[nodiscard]] auto startAt(Index i) const -> decltype(Skeleton::axisStarts)::const_iterator
    {
        const auto at =
            std::ranges::lower_bound(m_skeleton.axisStarts, i, {}, &std::pair<Index, std::uint64_t>::first);
        return at != m_skeleton.axisStarts.end() && at->first == i ? at : m_skeleton.axisStarts.end();
    }

    /// The axis that starts with a branch.
    Axis started(Index i, const Frame& before, const glm::dvec3& direction)
    {
        const Index parent = m_skeleton.parent[i];
        Axis axis;
        std::uint64_t parentAddress = noAxisAddress;
        if (parent == noIndex) {
            axis.mate = m_seenRoots++;
            axis.mates = m_roots;
        } else {
            axis.parent = m_tree.axisOf[parent];
            const Axis& below = m_tree.axes[axis.parent];
            parentAddress = below.address;
            axis.order = below.order + 1;
            axis.fork = m_tree.forksBelow[parent];
            axis.mate = m_seen[parent]++;
            axis.mates = m_mates[parent];
            axis.s = m_tree.start[parent] + m_skeleton.length(parent);
        }
        const auto kept = startAt(i);
        axis.address = kept == m_skeleton.axisStarts.end() ? axisAddress(parentAddress, axis.fork, axis.mate)
                                                           : kept->second;
        const double x = glm::dot(direction, before.normal), y = glm::dot(direction, before.binormal);
        const double aside = std::sqrt(x * x + y * y);
        axis.downAngle = maths::atan2(aside, glm::dot(direction, before.tangent));
        // Straight on there is no side: rounding must not choose one.
        axis.azimuth = aside > 1e-9 ? maths::atan2(y, x) : 0.0;
        axis.radius = m_skeleton.a0[i];
        return axis;
    }

    void listNodes()
    {
        Index first = 0;
        for (Axis& axis : m_tree.axes) {
            axis.firstNode = first;
            first += axis.nodes;
        }
        m_tree.nodes.resize(m_skeleton.size());
        std::vector<Index> filled(m_tree.axes.size(), 0);
        for (Index i = 0; i < m_skeleton.size(); ++i) {
            const Index axis = m_tree.axisOf[i];
            m_tree.nodes[m_tree.axes[axis].firstNode + filled[axis]++] = i;
        }
    }

    const Skeleton& m_skeleton;
    std::vector<Index> m_next;  ///< by branch: what continues it
    std::vector<Index> m_mates; ///< by branch: axes that start at its end
    std::vector<Index> m_seen;  ///< and how many of them were met
    std::vector<Frame> m_frames;
    Index m_roots = 0, m_seenRoots = 0;
    TreeAxes m_tree;
};

} // namespace

std::uint64_t axisAddress(std::uint64_t parent, Index fork, Index mate)
{
    constexpr std::uint64_t step = 0x9E3779B97F4A7C15ull;
    return mixBits(mixBits(parent + step * (std::uint64_t(fork) + 1)) + step * (std::uint64_t(mate) + 1));
}

TreeAxes axesOf(const Skeleton& skeleton)
{
    return AxisFinder(skeleton).run();
}

} // namespace ramure
