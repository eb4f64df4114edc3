#include "widgets/scene/branch_rows.h"

namespace ramure {

BranchRows::BranchRows(std::shared_ptr<const SimplifiedSkeleton> skeleton)
    : m_skeleton(std::move(skeleton))
    , m_children(childLists(m_skeleton->skeleton))
    , m_row(this->skeleton().size(), 0)
{
    const Skeleton& bones = this->skeleton();
    for (Index branch = 0; branch < bones.size(); ++branch) {
        if (bones.parent[branch] == noIndex) {
            m_row[branch] = static_cast<Index>(m_roots.size());
            m_roots.push_back(branch);
        }
        Index row = 0;
        for (const Index child : m_children.of(branch))
            m_row[child] = row++;
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
    return skeleton().parent == other.parent && skeleton().key == other.key;
}

void BranchRows::refresh(std::shared_ptr<const SimplifiedSkeleton> skeleton)
{
    m_skeleton = std::move(skeleton);
}

} // namespace ramure
