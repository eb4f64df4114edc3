/// \file
/// The branches of one tree as rows of the scene panel: who stands below whom, and at which row.
#pragma once

#include "core/skeleton/simplify.h"
#include <memory>
#include <optional>
#include <unordered_map>

namespace ramure {

class BranchRows
{
public:
    /// One pass over the skeleton: a few milliseconds for 100,000 branches. \p skeleton must not be null.
    explicit BranchRows(std::shared_ptr<const SimplifiedSkeleton> skeleton);

    [[nodiscard]] const Skeleton& skeleton() const { return m_skeleton->skeleton; }
    [[nodiscard]] const std::vector<Index>& roots() const { return m_roots; }
    [[nodiscard]] Index childCount(Index branch) const { return m_children.count(branch); }
    [[nodiscard]] Index child(Index branch, Index row) const { return m_children.of(branch)[row]; }
    /// Position among its siblings.
    [[nodiscard]] Index row(Index branch) const { return m_row[branch]; }
    /// The branch with this key (Skeleton::key), where there is one.
    [[nodiscard]] std::optional<Index> find(std::uint64_t key) const;
    /// The same branches below the same parents: only lengths and radii may differ.
    [[nodiscard]] bool sameShape(const Skeleton& other) const;
    /// Takes another skeleton of the same shape.
    void refresh(std::shared_ptr<const SimplifiedSkeleton> skeleton);

private:
    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    ChildLists m_children;
    std::vector<Index> m_roots;
    std::vector<Index> m_row;
    mutable std::unordered_map<std::uint64_t, Index> m_byKey; ///< filled at the first find()
};

} // namespace ramure
