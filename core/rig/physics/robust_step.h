/// \file
/// The artists' step. Every branch is a damped spring, relative to its parent (or to the world), that follows
/// the bend which wind, weight and the hand would give it in the long run:
///
///     bend'' = rate² (target - bend) - 2 ratio rate bend',      rate² = 5 g / reach * stiffness
///
/// Long branches swing slowly, twigs flutter. Each turns by its share (length / reach) of what the load asks
/// for, so the foot of the trunk stands firm and a tip gathers the turns of all below. Within a substep the
/// target stands still and the spring is solved exactly: no step is too long, no spring too stiff, nothing
/// can explode. The target depends on what stands below the branch only, never on its own bend, and is
/// bounded. A branch feels the air that it is carried through: that makes tips lag behind.
///
/// A settled tree is bent by its weight already: what its weight at rest asks for is taken off the load, as
/// seen from the frame that the branch rests in. So the shape at rest stands still to the last bit, whatever
/// the weight; more or less weight than at first, and weight from another side, bend it.
///
/// Bends are vectors tan(angle / 2) * axis across the branch: any vector is a rotation, without sine or
/// cosine.
#pragma once

#include "core/rig/physics/step_arrays.h"

namespace ramure {

/// The constants for one set of parameters, body and masses.
Springs springsOf(const TreeBody& body, const PhysicsParams& params, const Masses& masses);

/// Returns, by slot, the load that the weight \p held puts on each branch while all apples hang.
std::vector<double> heldLoads(const TreeBody& body, const HeldWeight& held);

/// One substep from \p timeSeconds on. Leaves time and step of the state alone.
void robustStep(const StepInputs& in, PhysicsState& state, double timeSeconds);

} // namespace ramure
