#include "widgets/scene/branch_rows.h"

namespace ramure {

BranchRows::BranchRows(std::shared_ptr<const SimplifiedSkeleton> skeleton)
    : m_skeleton(std::move(skeleton))
    , m_leadsOn(this->skeleton().size(), false)
    , m_above(this->skeleton().size(), noIndex)
    , m_forks(this->skeleton().size(), 0)
    , m_row(this->skeleton().size(), 0)
{
    findAxes();
    placeRows();
}

void BranchRows::findAxes()
{
    const Skeleton& bones = skeleton();
    std::vector<bool> ledOn(bones.size(), false);
    for (Index branch = 0; branch < bones.size(); ++branch) {
        const Index parent = bones.parent[branch];
        if (parent == noIndex)
            continue;
        ++m_forks[parent];
        // Only one leads on, should a skeleton have several children of its parent's level.
        if (!ledOn[parent] && bones.level[branch] == bones.level[parent]) {
            ledOn[parent] = true;
            m_leadsOn[branch] = true;
            m_above[branch] = m_above[parent];
        } else {
            m_above[branch] = parent;
        }
    }
}

void BranchRows::placeRows()
{
    const Index count = skeleton().size();
    m_below.first.assign(count + std::size_t{1}, 0);
    for (const Index above : m_above) {
        if (above != noIndex)
            ++m_below.first[above + std::size_t{1}];
    }
    for (Index branch = 0; branch < count; ++branch)
        m_below.first[branch + std::size_t{1}] += m_below.first[branch];
    m_below.list.resize(m_below.first.back());
    std::vector<Index> filled(count, 0);
    for (Index branch = 0; branch < count; ++branch) {
        const Index above = m_above[branch];
        if (above == noIndex) {
            m_row[branch] = static_cast<Index>(m_tops.size());
            m_tops.push_back(branch);
        } else {
            m_row[branch] = filled[above]++;
            m_below.list[m_below.first[above] + m_row[branch]] = branch;
        }
    }
}

std::optional<Index> BranchRows::find(std::uint64_t key) const
{
    if (m_byKey.empty()) {
        for (Index branch = 0; branch < skeleton().size(); ++branch)
            m_byKey.emplace(skeleton().key[branch], branch);
    }
    const auto found = m_byKey.find(key);
    return found == m_byKey.end() ? std::nullopt : std::optional(found->second);
}

bool BranchRows::sameShape(const Skeleton& other) const
{
    return skeleton().parent == other.parent && skeleton().key == other.key &&
           skeleton().level == other.level;
}

void BranchRows::refresh(std::shared_ptr<const SimplifiedSkeleton> skeleton)
{
    m_skeleton = std::move(skeleton);
}

} // namespace ramure
