/// \file
/// The branches of one tree as rows of the scene panel: who stands below whom, and at which row.
///
/// A branch and those that lead it on (of the same level of brackets) stand side by side, one below the
/// other; below each stand the side branches that spring from its end. So a trunk of a hundred pieces is a
/// list, not a staircase a hundred steps deep, and unfolding goes from trunk to bough to twig.
#pragma once

#include "core/skeleton/simplify.h"
#include <memory>
#include <optional>
#include <unordered_map>

namespace ramure {

class BranchRows
{
public:
    /// Two passes over the skeleton: a few milliseconds for 100,000 branches. \p skeleton must not be null.
    explicit BranchRows(std::shared_ptr<const SimplifiedSkeleton> skeleton);

    [[nodiscard]] const Skeleton& skeleton() const { return m_skeleton->skeleton; }
    [[nodiscard]] const std::vector<Index>& tops() const { return m_tops; }
    /// The row it stands below, noIndex at the top: the branch its axis springs from.
    [[nodiscard]] Index above(Index branch) const { return m_above[branch]; }
    /// Rows below a branch: side branches with what leads them on.
    [[nodiscard]] Index rowCount(Index branch) const { return m_below.count(branch); }
    [[nodiscard]] Index at(Index branch, Index row) const { return m_below.of(branch)[row]; }
    /// Position below above().
    [[nodiscard]] Index row(Index branch) const { return m_row[branch]; }
    /// It leads on the row before it; otherwise it begins an axis.
    [[nodiscard]] bool leadsOn(Index branch) const { return m_leadsOn[branch]; }
    /// Branches that begin at its end, whether side branches or not.
    [[nodiscard]] Index forks(Index branch) const { return m_forks[branch]; }
    /// The branch with this key (Skeleton::key), where there is one.
    [[nodiscard]] std::optional<Index> find(std::uint64_t key) const;
    /// The same branches below the same parents: only lengths and radii may differ.
    [[nodiscard]] bool sameShape(const Skeleton& other) const;
    /// Takes another skeleton of the same shape.
    void refresh(std::shared_ptr<const SimplifiedSkeleton> skeleton);

private:
    void findAxes();
    void placeRows();

    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    std::vector<bool> m_leadsOn;
    std::vector<Index> m_above;
    std::vector<Index> m_forks;
    ChildLists m_below;
    std::vector<Index> m_tops;
    std::vector<Index> m_row;
    mutable std::unordered_map<std::uint64_t, Index> m_byKey; ///< filled at the first find()
};

} // namespace ramure
