#include "core/physics/physics_state.h"

namespace ramure {

std::size_t PhysicsState::bytes() const
{
    return sizeof *this + values.capacity() * sizeof(double) + loose.capacity() * sizeof(LooseApple);
}

} // namespace ramure
