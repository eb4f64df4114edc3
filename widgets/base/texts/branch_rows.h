/// \file
/// The branches of one tree as axes: branches that continue each other from foot to tip are a trunk, a limb,
/// a bough or a twig. An axis belongs below its parent, so a trunk of a hundred branches is one row of the
/// scene panel, and unfolding goes from trunk to limb to twig.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/skeleton/axes.h"
#include <memory>
#include <optional>
#include <unordered_map>

namespace ramure {

class BranchRows
{
public:
    /// Passes over the skeletons a few times: milliseconds for 100,000 branches. Axes are those of the tree
    /// before simplification, and their numbers those of the tree as it grew, so that no edit renames another
    /// limb. Without TreeResult::skeleton the tree was never simplified. \pre TreeResult::simplified
    explicit BranchRows(const TreeResult& tree);

    [[nodiscard]] const Skeleton& skeleton() const { return m_skeleton->skeleton; }

    // Axes are counted in the order of their first branches.
    [[nodiscard]] Index axisCount() const { return static_cast<Index>(m_above.size()); }
    [[nodiscard]] Index axisOf(Index branch) const { return m_axisOf[branch]; }
    /// From foot to tip; at least one.
    [[nodiscard]] std::span<const Index> branches(Index axis) const { return m_branches.of(axis); }
    /// Position of a branch within its axis, from 0.
    [[nodiscard]] Index place(Index branch) const { return m_place[branch]; }
    /// The axis it springs from; noIndex for a trunk.
    [[nodiscard]] Index above(Index axis) const { return m_above[axis]; }
    /// The axes that spring from it, from its foot to its tip.
    [[nodiscard]] std::span<const Index> below(Index axis) const { return m_below.of(axis); }
    [[nodiscard]] const std::vector<Index>& trunks() const { return m_trunks; }
    /// Position among the children of the same axis, or among the trunks, from 0. Axes that edits made come
    /// last.
    [[nodiscard]] Index number(Index axis) const { return m_number[axis]; }
    /// There is another trunk that it has to be told from: it did not grow as the only one.
    [[nodiscard]] bool isOneOfTrunks(Index trunk) const { return m_number[trunk] > 0 || m_grownTrunks > 1; }
    /// 0 for a trunk, 1 for what springs from it, and so on.
    [[nodiscard]] Index order(Index axis) const { return m_order[axis]; }
    /// m from the foot of the axis it springs from to where it springs; 0 for a trunk.
    [[nodiscard]] double along(Index axis) const;
    /// m along its branches.
    [[nodiscard]] double length(Index axis) const { return m_reached[m_branches.of(axis).back()]; }

    /// Branches that begin at the end of one, whether they lead it on or not.
    [[nodiscard]] Index forks(Index branch) const { return m_forks[branch]; }
    /// The branch of this name (Skeleton::key), where there is one.
    [[nodiscard]] std::optional<Index> find(std::uint64_t name) const;
    /// The same branches below the same parents: only lengths and radii may differ.
    [[nodiscard]] bool sameShape(const Skeleton& other) const;
    /// Takes another skeleton of the same shape.
    void refresh(std::shared_ptr<const SimplifiedSkeleton> skeleton);

private:
    void findAxes(const TreeAxes& axes);
    void numberAxes(const TreeAxes& drawn, const TreeAxes& grown);
    void listBranches();
    void listAxes();
    void measure();
    [[nodiscard]] Index foot(Index axis) const { return m_branches.list[m_branches.first[axis]]; }

    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    // By branch.
    std::vector<Index> m_axisOf, m_place, m_forks;
    std::vector<double> m_reached; ///< m from the foot of its axis to its end
    // By axis.
    std::vector<Index> m_above, m_number, m_order;
    ChildLists m_branches, m_below;
    std::vector<Index> m_trunks;
    Index m_grownTrunks = 0;
    mutable std::unordered_map<std::uint64_t, Index> m_byName; ///< filled at the first find()
};

} // namespace ramure
