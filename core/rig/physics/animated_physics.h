/// \file
/// Parameters of physics with tracks (wind that rises, gravity that goes): a run in which each step has its
/// own.
#pragma once

#include "core/params/physics_params.h"
#include "core/rig/tracks/node_animation.h"
#include <cstdint>

namespace ramure {

/// A parameter of the physics has a track.
bool movesPhysics(const NodeAnimation& animation);
/// A parameter that shapes a tree has a track: at every time it is another tree.
bool movesShape(const NodeAnimation& animation);
/// The parameters in force from state \p step to the next.
PhysicsParams physicsAtStep(const PhysicsParams& params, const NodeAnimation& animation, std::int64_t step);

/// Tells a script, or a cache that has one, the parameters of the steps \p from .. \p to.
template <class Run>
void scriptSteps(Run& run, const PhysicsParams& params, const NodeAnimation& animation, std::int64_t from,
                 std::int64_t to)
{
    for (std::int64_t step = from; step <= to; ++step)
        run.setParams(physicsAtStep(params, animation, step), step);
}

} // namespace ramure
