#include "widgets/base/branch_rows.h"

#include <numeric>

namespace ramure {

BranchRows::BranchRows(std::shared_ptr<const SimplifiedSkeleton> skeleton)
    : m_skeleton(std::move(skeleton))
{
    findAxes();
    listBranches();
    listAxes();
    measure();
}

void BranchRows::findAxes()
{
    const Skeleton& bones = skeleton();
    m_axisOf.resize(bones.size());
    m_place.assign(bones.size(), 0);
    m_forks.assign(bones.size(), 0);
    std::vector<bool> ledOn(bones.size(), false);
    for (Index branch = 0; branch < bones.size(); ++branch) {
        const Index parent = bones.parent[branch];
        if (parent != noIndex)
            ++m_forks[parent];
        // Only one leads on, should a skeleton have several children of its parent's level.
        if (parent != noIndex && !ledOn[parent] && bones.level[branch] == bones.level[parent]) {
            ledOn[parent] = true;
            m_axisOf[branch] = m_axisOf[parent];
            m_place[branch] = m_place[parent] + 1;
        } else {
            m_axisOf[branch] = axisCount();
            m_above.push_back(parent == noIndex ? noIndex : m_axisOf[parent]);
            m_order.push_back(parent == noIndex ? 0 : m_order[m_above.back()] + 1);
        }
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
        if (m_above[axis] != noIndex) {
            ++first[springsFrom(axis) + 1];
        } else {
            m_number[axis] = static_cast<Index>(m_trunks.size());
            m_trunks.push_back(axis);
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (const Index begin : m_branches.first)
        m_below.first.push_back(first[begin]);
    m_below.list.resize(first.back());
    for (Index axis = 0; axis < axisCount(); ++axis) {
        if (m_above[axis] == noIndex)
            continue;
        const Index at = first[springsFrom(axis)]++;
        m_below.list[at] = axis;
        m_number[axis] = at - m_below.first[m_above[axis]];
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
            m_byName.emplace(skeleton().name(branch), branch);
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
