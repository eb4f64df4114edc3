/// \file
/// One step of a tree's motion (SPEC A7 faithful; robust as the artists' default), from one state to the
/// next.
///
/// Same body, parameters, state and hand: the same bits, on any thread. A step cannot fail and allocates
/// nothing after the first. One TreePhysics for each thread: it has working memory.
#pragma once

#include "core/rig/physics/physics_state.h"
#include "core/rig/physics/tree_body.h"
#include "core/rig/pose/pose.h"
#include <memory>
#include <optional>

namespace ramure {

class TreePhysics
{
public:
    explicit TreePhysics(std::shared_ptr<const TreeBody> body, const PhysicsParams& params = {});
    ~TreePhysics();
    TreePhysics(TreePhysics&&) noexcept;
    TreePhysics& operator=(TreePhysics&&) noexcept;

    [[nodiscard]] const TreeBody& body() const;
    [[nodiscard]] const PhysicsParams& params() const;
    /// From the next step on; states stay valid (one of the other mode is converted by the step). Values
    /// outside the table's ranges are clamped.
    void setParams(const PhysicsParams& params);

    /// At rest, step 0, all apples on the tree. Settled trees (PhysicsParams::settled) hold the weight that
    /// they have with these parameters.
    [[nodiscard]] PhysicsState restState() const;
    /// step k -> k + 1. \p pull the hand during this step, if any; out of range branches are ignored.
    void step(PhysicsState& state, const std::optional<Pull>& pull = {});
    /// Lets an apple go: it falls from where it is with the velocity of its branch. Nothing where it is loose
    /// already or does not exist.
    void shakeOff(PhysicsState& state, Index apple) const;

    /// One transform per branch of the skeleton. \p out is reused.
    void pose(const PhysicsState& state, Pose& out) const;
    /// Per loose apple, in the order of PhysicsState::loose: from its place at rest to where it lies now.
    [[nodiscard]] std::vector<RigidTransform> loosePoses(const PhysicsState& state) const;
    [[nodiscard]] PhysicsFigures figures(const PhysicsState& state) const;
    /// How fast a branch swings by itself in the robust mode, rad/s.
    [[nodiscard]] double swingRate(Index branch) const;

private:
    struct Prepared;
    std::shared_ptr<const TreeBody> m_body;
    std::unique_ptr<Prepared> m_prepared;
};

} // namespace ramure
