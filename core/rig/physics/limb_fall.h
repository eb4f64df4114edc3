/// \file
/// Limbs that were cut: each hangs on its stump until its time, tears off about its foot where it stood upon
/// it, falls, and comes to rest on the ground y = 0. One rigid body each, in tree space; limbs go through
/// each other and through the tree.
///
/// Contacts and the hinge by sequential impulses (Catto, "Iterative Dynamics with Temporal Coherence", 2005);
/// what lies below the ground after a step is lifted out of it.
#pragma once

#include "core/params/physics_params.h"
#include "core/rig/physics/physics_state.h"
#include "core/rig/physics/tree_body.h"
#include "core/rig/pose/pose.h"

namespace ramure {

/// Finds the limbs of a body whose branches are there: their masses, what they stood on, what touches the
/// ground. Those with a root that is none are left out; stumps that go with the limb itself count as gone.
void takeLimbs(const std::vector<LooseLimb>& limbs, TreeBody& body);

/// From hanging to tearing, or falling where it does not stand on its foot. \param held where its stump holds
/// it \param velocity of the stump, m/s
void letGo(const LooseBody& body, const RigidTransform& held, const glm::dvec3& velocity, FallingLimb& limb);

/// Moves a limb on by \p seconds; those that hang or rest stay. No ball is below the ground afterwards.
void stepLimb(const LooseBody& body, const PhysicsParams& params, double seconds, FallingLimb& limb);

} // namespace ramure
