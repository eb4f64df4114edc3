/// \file
/// The constant data of a moving tree: its branches at rest as flat arrays in an order made for stepping.
///
/// The physics counts slots, not branches. Slots are sorted by depth (all roots, then all their children,
/// ...), so parents come first and the slots of one depth can be computed side by side.
#pragma once

#include "core/base/index.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/foliage.h"
#include <cstdint>
#include <memory>
#include <vector>

namespace ramure {

/// A limb that comes off (Skeleton::loose), as a rigid body.
struct LooseBody
{
    Index root = noIndex;  ///< slot
    Index stump = noIndex; ///< slot; noIndex: it stands on nothing
    double seconds = 0.0;
    glm::dvec3 centre{0.0};  ///< centre of mass at rest
    glm::dmat3 inertia{1.0}; ///< about it, m²: of a body of 1 kg
    glm::dvec3 foot{0.0};    ///< place of the cut
    /// The balls that touch the ground: with a radius around its ends, with radius 0 around its foot. Places
    /// are relative to the centre, at rest.
    std::vector<std::pair<glm::dvec3, double>> balls;
};

struct TreeBody
{
    std::vector<Index> branchOf; ///< by slot: the branch of the skeleton
    std::vector<Index> slotOf;   ///< by branch
    std::vector<Index> parent;   ///< by slot: the parent's slot, noIndex for roots
    std::vector<Index> depthEnd; ///< per depth: one past its last slot

    // By slot, at rest, tree space, metres.
    std::vector<glm::dvec3> p0, p1;
    std::vector<double> dirX, dirY, dirZ; ///< unit(p1 - p0); +Y where a branch has no length
    std::vector<double> length;
    std::vector<double> a0, a1;
    std::vector<double> reach; ///< from p0 to the farthest tip that the branch carries, along the branches

    /// Apples in the order of Foliage::apples.
    std::vector<Index> appleSlot;
    std::vector<glm::dvec3> applePosition;
    std::vector<glm::dquat> appleOrientation;
    double appleRadius = 0.0; ///< m

    std::vector<LooseBody> limbs; ///< in the order of Skeleton::loose
    std::vector<Index> limbOf;    ///< by slot: among them, noIndex where it stays; empty: all stay

    Index firstTerminal = 0; ///< slot of the first branch (in the skeleton's order) without children
    std::uint64_t key = 0;   ///< hash of all of the above: one part of the key of a physics cache

    [[nodiscard]] Index size() const { return static_cast<Index>(parent.size()); }
};

/// \param skeleton the simplified skeleton from which the mesh is made \param foliage may be null: no apples
/// \param alpha the grammar's length (TurtleParams::alpha), which scales apples (fruitRadius)
std::shared_ptr<const TreeBody> makeTreeBody(const Skeleton& skeleton, const Foliage* foliage, double alpha);

} // namespace ramure
