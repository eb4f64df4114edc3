/// \file
/// Fruit on stalks: they go on hanging however their twigs turn, and stay behind when those move.
///
/// There is no state, as with leaves (leaf_swing.h): heavy on a short stalk, a fruit follows at once the pull
/// of its weight and of the air that it is carried through. With its branch at rest it hangs as it was
/// placed.
#pragma once

#include "core/rig/physics/physics_state.h"
#include "core/rig/physics/tree_body.h"
#include "core/rig/pose/pose.h"
#include "core/surface/foliage/foliage.h"
#include <span>
#include <vector>

namespace ramure {

class FruitSwing
{
public:
    /// Nothing swings where the fruit are the faithful ones, or flowers. \param alpha TurtleParams::alpha.
    FruitSwing(const Foliage& foliage, double alpha);
    FruitSwing() = default;

    [[nodiscard]] double reach() const { return m_reach; } ///< m, from the foot of a stalk to the middle
    /// How fast each one's branch goes, m/s; none where nothing swings.
    [[nodiscard]] std::vector<glm::dvec3> carried(const TreeBody& body, const PhysicsState& state) const;
    /// Turns each about the foot of its stalk. \param bones one per fruit: those of their branches, tree
    /// space.
    void pose(std::span<const glm::dvec3> carried, std::span<RigidTransform> bones) const;

private:
    std::vector<glm::dvec3> m_feet; ///< tree space, at rest
    std::vector<Index> m_branches;
    double m_reach = 0.0;
};

/// One of them. \param branch the bone that carries it \param foot of its stalk, at rest \param carried m/s
RigidTransform hungFruit(const RigidTransform& branch, const glm::dvec3& foot, const glm::dvec3& carried);

} // namespace ramure
