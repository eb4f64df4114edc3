#include "core/rig/physics/physics_state.h"

namespace ramure {

HeldWeight heldWeight(const PhysicsParams& params)
{
    return params.settled ? HeldWeight{params.gravity, params.restitution, params.appleMass} : HeldWeight{};
}

std::size_t PhysicsState::bytes() const
{
    return sizeof *this + values.capacity() * sizeof(double) + loose.capacity() * sizeof(LooseApple) +
           limbs.capacity() * sizeof(FallingLimb);
}

} // namespace ramure
