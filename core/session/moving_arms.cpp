#include "core/session/moving_arms.h"

#include "core/rig/arm/arm_chain.h"
#include <cmath>

namespace ramure {

MovingArms::MovingArms(const TimelineSettings& timeline)
    : m_timeline(timeline)
{
}

Expected<std::vector<ArmJoint>> MovingArms::jointsAt(const Node& arm, double seconds,
                                                     const Progress& progress)
{
    if (auto checked = checkArm(arm.params.joints); !checked)
        return fail(std::move(checked.error()));
    const bool turns = seconds > 0.0 && arm.params.arm.follows;
    if (!turns && !arm.animation.movesParams() && !std::isnan(seconds))
        return arm.params.joints;
    ArmRun& run = m_runs[arm.id];
    run.set(arm.params, arm.animation);
    auto moment = run.momentAt(seconds, m_timeline, progress);
    if (!moment)
        return fail(std::move(moment.error()));
    return std::move(moment->joints);
}

Expected<Scene> MovingArms::at(const Scene& scene, double seconds, const Progress& progress)
{
    Scene moved = scene;
    for (const Node& node : scene.nodes()) {
        if (node.kind != NodeKind::Arm)
            continue;
        auto joints = jointsAt(node, seconds, progress);
        if (!joints) {
            Error error = std::move(joints.error());
            error.path = node.name + (error.path.empty() ? "" : ": " + error.path);
            return fail(std::move(error));
        }
        moved.find(node.id)->params.joints = std::move(*joints);
    }
    return moved;
}

} // namespace ramure
