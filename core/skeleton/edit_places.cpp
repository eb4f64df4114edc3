#include "core/skeleton/edit_places.h"

#include "core/math/assignment.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/math/stage_hash.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace ramure {
namespace {

AxisPrint printOf(const Axis& a)
{
    return {a.address, a.fork,      a.mate,    a.forks,  a.mates, a.s,
            a.share,   a.downAngle, a.azimuth, a.length, a.radius};
}

/// Along the parent's direction and to its sides.
glm::dvec3 direction(double downAngle, double azimuth)
{
    const auto [aside, along] = maths::sincos(downAngle);
    const auto [sine, cosine] = maths::sincos(azimuth);
    return {aside * cosine, aside * sine, along};
}

/// |log2(a / b)|, at most \p most, also where one of them is 0.
double unlikeSizes(double a, double b, double most)
{
    if (a == b)
        return 0.0;
    return a > 0.0 && b > 0.0 ? std::min(most, std::abs(maths::log(a / b)) / 0.6931471805599453) : most;
}

constexpr double sameLength = 0.03; ///< as a share
constexpr double mostTurned = 0.25; ///< rad, where forks came or went
constexpr double mostCost = 2.0;

/// How an axis came to look, since an edit was made somewhere on it.
enum class Change : std::uint8_t {
    None,     ///< as many forks as before: ranks hold
    Inserted, ///< forks came or went on the same length: distances hold
    Grown,    ///< longer or shorter: ranks hold from the base on
};

Change changeOf(const AxisPrint& before, const Axis& now)
{
    if (before.forks == now.forks)
        return Change::None;
    return std::abs(now.length - before.length) <= sameLength * before.length ? Change::Inserted
                                                                              : Change::Grown;
}

/// What was edited, and what grew on it, of one tree: the axes that places name.
struct KnownAxis
{
    AxisPrint print;
    std::vector<Index> children{}; ///< in the list of all
    Index found = noIndex;         ///< axis of the tree
};

/// No address at all where the fingerprint is another one's.
bool isPlausible(const AxisPrint& before, const Axis& now)
{
    return std::abs(before.downAngle - now.downAngle) <= 1.0 &&
           (std::abs(before.share - now.share) <= 0.35 || std::abs(before.s - now.s) <= 0.01 * before.s) &&
           unlikeSizes(before.length, now.length, 4.0) <= 3.3;
}

/// Where the parent has grown, ranks hold as far as the forks stand where they stood: whatever the axes were
/// turned about it, as by one more roll with each iteration.
bool isAtSameDistance(const AxisPrint& before, const Axis& now, const AxisPrint& parentBefore)
{
    return std::abs(now.s - before.s) * std::max<double>(parentBefore.forks, 1.0) <=
           0.3 * parentBefore.length;
}

/// Of taking \p now for what was \p before; nothing where it cannot be.
std::optional<double> costOf(const AxisPrint& before, const Axis& now, Change parent, double parentLength,
                             std::uint32_t parentForks)
{
    const glm::dvec3 a = direction(before.downAngle, before.azimuth);
    const glm::dvec3 b = direction(now.downAngle, now.azimuth);
    double turned = maths::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    const bool grown = parent != Change::Inserted;
    const double longer = unlikeSizes(before.length, now.length, 3.0);
    if (parent == Change::Grown && before.mates != now.mates && (longer > 1.0 || before.forks == 0))
        return std::nullopt; // what was there is gone, and something else has come in its place
    const double forks = std::max<double>(parentForks, 1.0);
    const double away = parentLength > 0.0 ? std::abs(now.s - before.s) * forks / parentLength : 0.0;
    const double along = std::min(away, std::abs(now.share - before.share) * forks);
    const bool sameFork = before.fork == now.fork;
    if (grown && sameFork && along <= 0.3)
        turned = std::min(turned, std::abs(before.downAngle - now.downAngle) + 0.1);
    if (turned > mostTurned)
        return std::nullopt;
    if (grown ? !sameFork && along > 0.3 : along > 0.6)
        return std::nullopt;
    const double rank = (sameFork ? 0.0 : grown ? 1.5 : 0.1) + (before.mate == now.mate ? 0.0 : 0.3);
    return std::min(along, 0.7) + rank + 2.0 * turned + (grown ? 0.15 : 0.5) * longer +
           (grown ? 0.3 : 0.5) * unlikeSizes(before.radius, now.radius, 1.0);
}

/// Where the axes named by the places of one tree are in another.
class AxisMatcher
{
public:
    explicit AxisMatcher(const TreeAxes& tree)
        : m_tree(tree)
        , m_first(tree.axes.size() + 2, 0)
        , m_children(tree.axes.size())
        , m_taken(tree.axes.size(), false)
    {
        for (const Axis& axis : tree.axes)
            ++m_first[rowOf(axis.parent) + 1];
        for (std::size_t i = 1; i < m_first.size(); ++i)
            m_first[i] += m_first[i - 1];
        std::vector<Index> next(m_first.begin(), m_first.end() - 1);
        for (Index i = 0; i < tree.axes.size(); ++i)
            m_children[next[rowOf(tree.axes[i].parent)]++] = i;
        for (std::size_t row = 0; row + 1 < m_first.size(); ++row)
            std::ranges::stable_sort(m_children.begin() + m_first[row], m_children.begin() + m_first[row + 1],
                                     {}, [&tree](Index i) { return tree.axes[i].fork; });
    }

    /// \param known parents before children; those of \p roots have no parent.
    void match(std::vector<KnownAxis>& known, const std::vector<Index>& roots)
    {
        std::vector<Index> used;
        matchChildren(known, roots, noIndex, nullptr, used);
        for (KnownAxis& axis : known)
            if (axis.found != noIndex)
                matchChildren(known, axis.children, axis.found, &axis.print, used);
        for (const Index axis : used)
            m_taken[axis] = false; // another tree's places may be here too
    }

private:
    [[nodiscard]] std::size_t rowOf(Index parent) const { return parent == noIndex ? 0 : parent + 1; }

    void take(KnownAxis& known, Index axis, std::vector<Index>& used)
    {
        known.found = axis;
        m_taken[axis] = true;
        used.push_back(axis);
    }

    void matchChildren(std::vector<KnownAxis>& known, const std::vector<Index>& wanted, Index parent,
                       const AxisPrint* parentBefore, std::vector<Index>& used)
    {
        const std::span<const Index> children(m_children.data() + m_first[rowOf(parent)],
                                              m_children.data() + m_first[rowOf(parent) + 1]);
        const Change change = parentBefore ? changeOf(*parentBefore, m_tree.axes[parent]) : Change::None;
        for (const Index child : wanted)
            if (const Index itself = sameAddress(known[child].print, children);
                itself != noIndex && !m_taken[itself])
                take(known[child], itself, used);
        std::vector<Index> rest;
        for (const Index child : wanted) {
            if (known[child].found != noIndex)
                continue;
            const AxisPrint& print = known[child].print;
            const Index same = change == Change::Inserted ? noIndex : sameRank(print, children);
            if (same != noIndex && !m_taken[same] &&
                (change == Change::None || isAtSameDistance(print, m_tree.axes[same], *parentBefore)))
                take(known[child], same, used);
            else
                rest.push_back(child);
        }
        std::vector<AssignmentEdge> edges;
        for (Index row = 0; row < rest.size(); ++row)
            addEdges(known[rest[row]].print, row, children, change, parentBefore, edges);
        if (edges.empty())
            return;
        const auto found = leastCostAssignment(static_cast<Index>(rest.size()),
                                               static_cast<Index>(children.size()), edges, mostCost);
        for (Index row = 0; row < rest.size(); ++row)
            if (found[row] != noIndex)
                take(known[rest[row]], children[found[row]], used);
    }

    /// The child of the same address in the very same place: where edits (core/recipe/) made or took
    /// away what stood beside it, it is itself still.
    [[nodiscard]] Index sameAddress(const AxisPrint& print, std::span<const Index> children) const
    {
        constexpr double rounding = 1e-6;
        const auto at =
            std::ranges::find(children, print.address, [this](Index i) { return m_tree.axes[i].address; });
        if (at == children.end())
            return noIndex;
        const Axis& axis = m_tree.axes[*at];
        const bool isThere = std::abs(axis.s - print.s) <= rounding * (1.0 + print.s) &&
                             std::abs(axis.downAngle - print.downAngle) <= rounding &&
                             std::abs(axis.azimuth - print.azimuth) <= rounding;
        return isThere ? *at : noIndex;
    }

    /// The child at the same rank of the same fork, if it can be meant.
    [[nodiscard]] Index sameRank(const AxisPrint& print, std::span<const Index> children) const
    {
        auto at = std::ranges::lower_bound(children, print.fork, {},
                                           [this](Index i) { return m_tree.axes[i].fork; });
        for (; at != children.end() && m_tree.axes[*at].fork == print.fork; ++at) {
            const Axis& axis = m_tree.axes[*at];
            if (axis.mate == print.mate)
                return axis.mates == print.mates && isPlausible(print, axis) ? *at : noIndex;
        }
        return noIndex;
    }

    /// To the children around the same rank and around the same distance from the parent's foot: what lies
    /// farther away is not meant, and need not be looked at.
    void addEdges(const AxisPrint& print, Index row, std::span<const Index> children, Change change,
                  const AxisPrint* parentBefore, std::vector<AssignmentEdge>& edges) const
    {
        constexpr std::ptrdiff_t around = 24;
        const auto size = static_cast<std::ptrdiff_t>(children.size());
        const auto from = [&](auto at) {
            return std::max<std::ptrdiff_t>(at - children.begin() - around, 0);
        };
        const auto byRank = from(std::ranges::lower_bound(children, print.fork, {},
                                                          [this](Index i) { return m_tree.axes[i].fork; }));
        const auto byWay = from(
            std::ranges::lower_bound(children, print.s, {}, [this](Index i) { return m_tree.axes[i].s; }));
        const auto add = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
            for (std::ptrdiff_t i = first; i < std::min(last, size); ++i) {
                const Axis& axis = m_tree.axes[children[static_cast<std::size_t>(i)]];
                if (m_taken[children[static_cast<std::size_t>(i)]])
                    continue;
                const Change how = parentBefore ? change : Change::Inserted;
                const auto cost = costOf(print, axis, how, parentBefore ? parentBefore->length : 0.0,
                                         parentBefore ? parentBefore->forks : 0);
                if (cost)
                    edges.push_back({row, static_cast<Index>(i), *cost});
            }
        };
        const auto low = std::min(byRank, byWay), high = std::max(byRank, byWay);
        add(low, std::min(low + 2 * around, high));
        add(high, high + 2 * around);
    }

    const TreeAxes& m_tree;
    std::vector<Index> m_first, m_children; ///< by axis, the roots in row 0: its children along it
    std::vector<bool> m_taken;
};

/// The branch on an axis that was found. noIndex: it is not there any more.
Index branchOn(const TreeAxes& tree, Index axis, const BranchPlace& place)
{
    const AxisPrint& before = place.way.back();
    const std::span<const Index> nodes = tree.nodesOf(axis);
    const double along = place.share * before.length;
    const auto after = std::ranges::upper_bound(nodes, along, {}, [&tree](Index i) { return tree.start[i]; });
    const Index byWay = after == nodes.begin() ? nodes.front() : *(after - 1);
    if (changeOf(before, tree.axes[axis]) == Change::Inserted)
        return byWay;
    const auto belowFork = [&tree](Index i) { return tree.forksBelow[i]; };
    const auto first = std::ranges::lower_bound(nodes, place.fork, {}, belowFork);
    const auto last = std::ranges::upper_bound(nodes, place.fork, {}, belowFork);
    if (first == last)
        return noIndex;
    // The very same axis in more pieces, or fewer, was bent or cut (core/recipe/): ways hold.
    constexpr double rounding = 1e-9;
    if (std::abs(tree.axes[axis].length - before.length) <= rounding * before.length)
        return byWay;
    return first[std::min<std::ptrdiff_t>(place.piece, last - first - 1)];
}

} // namespace

std::uint64_t treeMark(const TreeAxes& tree)
{
    StageHash hash(tree.nodes.size());
    for (const Axis& a : tree.axes)
        hash.add(a.address).add(a.forks).add(a.mates).add(a.s).add(a.length).add(a.azimuth).add(a.radius);
    return hash.value();
}

BranchPlace placeOf(const TreeAxes& tree, Index branch, std::uint64_t mark)
{
    BranchPlace place;
    place.tree = mark;
    const Index own = tree.axisOf[branch];
    for (Index axis = own; axis != noIndex; axis = tree.axes[axis].parent)
        place.way.push_back(printOf(tree.axes[axis]));
    std::ranges::reverse(place.way);
    place.fork = tree.forksBelow[branch];
    const std::span<const Index> nodes = tree.nodesOf(own);
    const auto at = std::ranges::lower_bound(nodes, branch);
    const auto first =
        std::ranges::lower_bound(nodes, place.fork, {}, [&tree](Index i) { return tree.forksBelow[i]; });
    place.piece = static_cast<std::uint32_t>(at - first);
    const double length = tree.axes[own].length;
    const double end = at + 1 == nodes.end() ? length : tree.start[*(at + 1)];
    place.share = length > 0.0 ? 0.5 * (tree.start[branch] + end) / length : 0.0;
    return place;
}

std::vector<FoundPlace> findPlaces(const TreeAxes& tree, std::span<const BranchPlace* const> places)
{
    std::map<std::uint64_t, std::vector<Index>> byTree;
    for (Index i = 0; i < places.size(); ++i)
        if (!places[i]->way.empty())
            byTree[places[i]->tree].push_back(i);
    std::vector<FoundPlace> found(places.size());
    AxisMatcher matcher(tree);
    for (const auto& [mark, members] : byTree) {
        std::vector<KnownAxis> known;
        std::map<std::uint64_t, Index> byAddress;
        std::vector<Index> roots, own(members.size());
        for (std::size_t m = 0; m < members.size(); ++m) {
            Index parent = noIndex;
            for (const AxisPrint& print : places[members[m]]->way) {
                const auto [at, isNew] = byAddress.emplace(print.address, Index(known.size()));
                if (isNew) {
                    known.push_back({print});
                    (parent == noIndex ? roots : known[parent].children).push_back(at->second);
                }
                parent = at->second;
            }
            own[m] = parent;
        }
        matcher.match(known, roots);
        for (std::size_t m = 0; m < members.size(); ++m) {
            const Index axis = known[own[m]].found;
            if (axis == noIndex)
                continue;
            const BranchPlace& place = *places[members[m]];
            const Index branch = branchOn(tree, axis, place);
            found[members[m]] = {branch, branch != noIndex &&
                                             tree.axes[axis].address == place.way.back().address &&
                                             tree.forksBelow[branch] == place.fork};
        }
    }
    return found;
}

std::vector<Index> findBranches(const Skeleton& drawn, const SimplifiedSkeleton& simplified,
                                std::span<const BranchPlace> places)
{
    std::vector<const BranchPlace*> wanted;
    for (const BranchPlace& place : places)
        wanted.push_back(&place);
    std::vector<Index> branches;
    for (const FoundPlace& found : findPlaces(axesOf(drawn), wanted))
        branches.push_back(found.branch == noIndex ? noIndex : simplified.mergedInto[found.branch]);
    return branches;
}

std::vector<Index> followBranches(const Skeleton& drawn, const SimplifiedSkeleton& simplified,
                                  std::span<const Index> branches, const Skeleton& otherDrawn,
                                  const SimplifiedSkeleton& other)
{
    if (simplified.skeleton.key == other.skeleton.key) // which say how each branch is reached
        return {branches.begin(), branches.end()};
    const TreeAxes tree = axesOf(drawn);
    std::vector<BranchPlace> places;
    for (const Index branch : branches)
        places.push_back(placeOf(tree, simplified.skeleton.source[branch], 0));
    return findBranches(otherDrawn, other, places);
}

} // namespace ramure
