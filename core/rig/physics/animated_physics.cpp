#include "core/rig/physics/animated_physics.h"

#include <algorithm>

namespace ramure {

template <class Test> static bool movesAny(const NodeAnimation& animation, Test&& test)
{
    return std::any_of(animation.tracks().begin(), animation.tracks().end(), [&test](const auto& entry) {
        const ParamDef* def = entry.first.def();
        return def && test(def->stage);
    });
}

bool movesPhysics(const NodeAnimation& animation)
{
    return movesAny(animation, [](Stage stage) { return stage == Stage::Motion; });
}

bool movesShape(const NodeAnimation& animation)
{
    return movesAny(animation, [](Stage stage) { return stage < Stage::Placement; });
}

PhysicsParams physicsAtStep(const PhysicsParams& params, const NodeAnimation& animation, std::int64_t step)
{
    NodeParams node;
    node.physics = params;
    return paramsAt(node, animation, double(step) * params.stepSeconds).physics;
}

} // namespace ramure
