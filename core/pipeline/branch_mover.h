/// \file
/// The search for the smallest turn that takes one branch off another, on tubes around the branches' curves:
/// a model of the mesh that is quick to move. Internal to separate_branches.cpp.
#pragma once

#include "core/surface/check/collisions.h"
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

namespace ramure {

class BranchMover
{
public:
    struct Turn
    {
        Index branch = noIndex;
        glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< in tree space, about the branch's start
    };
    struct Limits
    {
        double clearance = 0.15; ///< share of the added radii
        double mostTurnRad = 0.7;
    };

    /// \param skeleton as it is now. \param parent as the mesher sees them (repairedParents).
    BranchMover(Skeleton skeleton, std::vector<Index> parent, const Limits& limits);

    /// The smallest turn found that parts the two without bringing others together; nothing where there is
    /// none. Branches that \p isBanned stay where they are.
    [[nodiscard]] std::optional<Turn> partingTurn(Index first, Index second,
                                                  const std::vector<bool>& isBanned) const;
    void apply(const Turn& turn);
    /// Do the tubes overlap, or come closer than the clearance?
    [[nodiscard]] bool areClose(Index first, Index second) const;
    /// The branch and all that grows on it.
    [[nodiscard]] std::vector<Index> subtree(Index branch) const;

private:
    struct Moved
    {
        std::vector<Index> branches;
        std::vector<BranchTube> tubes;
    };
    struct Bounds
    {
        glm::dvec3 low, high;
    };

    [[nodiscard]] BranchTube tubeOf(Index branch) const;
    [[nodiscard]] static Bounds boundsOf(const BranchTube& tube);
    [[nodiscard]] std::vector<Index> movers(Index first, Index second) const;
    [[nodiscard]] std::optional<Turn> turnOf(Index mover, Index moving, Index resting) const;
    [[nodiscard]] Moved moved(const std::vector<Index>& branches, const Turn& turn) const;
    [[nodiscard]] bool isFree(const Moved& moved, const std::vector<bool>& moves, Index moving,
                              Index resting) const;
    [[nodiscard]] bool isFar(Index a, Index b) const;
    [[nodiscard]] double wantedDepth(const TubeContact& contact) const;

    Skeleton m_skeleton;
    std::vector<Index> m_parent;
    Limits m_limits;
    ChildLists m_children;
    std::vector<BranchTube> m_tubes;
    std::vector<Bounds> m_bounds;
};

} // namespace ramure
