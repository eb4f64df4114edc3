#include "widgets/base/texts/branch_rows.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ramure {

BranchRows::BranchRows(const TreeResult& tree)
    : m_skeleton(tree.simplified)
{
    const TreeAxes drawn = axesOf(tree.skeleton ? *tree.skeleton : skeleton());
    findAxes(drawn);
    listBranches();
    listAxes();
    tree.grown&& tree.grown != tree.skeleton ? numberAxes(drawn, axesOf(*tree.grown))
                                             : numberAxes(drawn, drawn);
    measure();
}

void BranchRows::findAxes(const TreeAxes& axes)
{
    const Skeleton& bones = skeleton();
    m_axisOf.resize(bones.size());
    m_place.assign(bones.size(), 0);
    m_forks.assign(bones.size(), 0);
    std::vector<Index> rowOf(axes.axes.size(), noIndex);
    for (Index branch = 0; branch < bones.size(); ++branch) {
        const Index parent = bones.parent[branch];
        if (parent != noIndex)
            ++m_forks[parent];
        Index& row = rowOf[axes.axisOf[bones.source[branch]]];
        if (row == noIndex) {
            row = axisCount();
            m_above.push_back(parent == noIndex ? noIndex : m_axisOf[parent]);
            m_order.push_back(parent == noIndex ? 0 : m_order[m_above.back()] + 1);
        } else {
            m_place[branch] = m_place[parent] + 1;
        }
        m_axisOf[branch] = row;
    }
}

/// Axes that grew are counted where they grew; those that edits made, or put elsewhere, after them.
void BranchRows::numberAxes(const TreeAxes& drawn, const TreeAxes& grown)
{
    struct Grown
    {
        std::uint64_t parent = noAxisAddress;
        Index number = 0;
    };
    std::unordered_map<std::uint64_t, Grown> places;
    std::unordered_map<std::uint64_t, Index> counts; // of what springs from an axis, by its address
    std::vector<Index> along(grown.axes.size());
    std::iota(along.begin(), along.end(), Index(0));
    std::ranges::stable_sort(
        along, {}, [&grown](Index axis) { return std::pair(grown.axes[axis].fork, grown.axes[axis].mate); });
    const auto addressOf = [](const TreeAxes& of, Index axis) {
        return axis == noIndex ? noAxisAddress : of.axes[axis].address;
    };
    for (const Index axis : along) {
        const std::uint64_t parent = addressOf(grown, grown.axes[axis].parent);
        places[grown.axes[axis].address] = {parent, counts[parent]++};
    }
    m_grownTrunks = counts[noAxisAddress];
    for (Index axis = 0; axis < axisCount(); ++axis) {
        const Axis& own = drawn.axes[drawn.axisOf[skeleton().source[foot(axis)]]];
        const std::uint64_t parent = addressOf(drawn, own.parent);
        const auto found = places.find(own.address);
        const bool isThere = found != places.end() && found->second.parent == parent;
        m_number[axis] = isThere ? found->second.number : counts[parent]++;
    }
}

void BranchRows::listBranches()
{
    m_branches.first.assign(axisCount() + std::size_t{1}, 0);
    for (const Index axis : m_axisOf)
        ++m_branches.first[axis + std::size_t{1}];
    std::partial_sum(m_branches.first.begin(), m_branches.first.end(), m_branches.first.begin());
    m_branches.list.resize(m_axisOf.size());
    for (Index branch = 0; branch < m_axisOf.size(); ++branch)
        m_branches.list[m_branches.first[m_axisOf[branch]] + m_place[branch]] = branch;
}

/// Axes in the order of the places that they spring from: those of one axis stand together then.
void BranchRows::listAxes()
{
    const Skeleton& bones = skeleton();
    const auto springsFrom = [&](Index axis) -> std::size_t {
        const Index parent = bones.parent[foot(axis)];
        return m_branches.first[m_axisOf[parent]] + m_place[parent];
    };
    std::vector<Index> first(bones.size() + std::size_t{1}, 0);
    m_number.assign(axisCount(), 0);
    for (Index axis = 0; axis < axisCount(); ++axis) {
        if (m_above[axis] != noIndex)
            ++first[springsFrom(axis) + 1];
        else
            m_trunks.push_back(axis);
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (const Index begin : m_branches.first)
        m_below.first.push_back(first[begin]);
    m_below.list.resize(first.back());
    for (Index axis = 0; axis < axisCount(); ++axis) {
        if (m_above[axis] == noIndex)
            continue;
        m_below.list[first[springsFrom(axis)]++] = axis;
    }
}

void BranchRows::measure()
{
    const Skeleton& bones = skeleton();
    m_reached.resize(bones.size());
    for (Index branch = 0; branch < bones.size(); ++branch)
        m_reached[branch] =
            bones.length(branch) + (m_place[branch] == 0 ? 0.0 : m_reached[bones.parent[branch]]);
}

double BranchRows::along(Index axis) const
{
    const Index parent = skeleton().parent[foot(axis)];
    return parent == noIndex ? 0.0 : m_reached[parent];
}

std::optional<Index> BranchRows::find(std::uint64_t name) const
{
    if (m_byName.empty()) {
        for (Index branch = 0; branch < skeleton().size(); ++branch)
            m_byName.emplace(skeleton().key[branch], branch);
    }
    const auto found = m_byName.find(name);
    return found == m_byName.end() ? std::nullopt : std::optional(found->second);
}

bool BranchRows::sameShape(const Skeleton& other) const
{
    return skeleton().parent == other.parent && skeleton().key == other.key &&
           skeleton().level == other.level;
}

void BranchRows::refresh(std::shared_ptr<const SimplifiedSkeleton> skeleton)
{
    m_skeleton = std::move(skeleton);
    measure();
}

} // namespace ramure
