#include "core/session/moving_arms.h"

#include "core/rig/arm/arm_blend.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_driver.h"
#include "core/scene/loop_blend.h"
#include <cmath>

namespace ramure {

/// One arm's driver, as long as nothing that it was made from changes.
struct MovingArms::Run
{
    explicit Run(const Node& node)
        : params(node.params)
        , animation(node.animation)
        , driver(armDriver(params, animation))
    {
    }
    [[nodiscard]] bool isFor(const Node& node) const
    {
        return params.joints == node.params.joints && params.ik == node.params.ik &&
               params.arm == node.params.arm && animation == node.animation;
    }

    NodeParams params;
    NodeAnimation animation;
    ArmDriver driver;
};

MovingArms::MovingArms(const TimelineSettings& timeline)
    : m_timeline(timeline)
{
}

MovingArms::~MovingArms() = default;

Expected<std::vector<ArmJoint>> MovingArms::jointsAt(const Node& arm, double seconds,
                                                     const Progress& progress)
{
    if (auto checked = checkArm(arm.params.joints); !checked)
        return fail(std::move(checked.error()));
    const bool turns = seconds > 0.0 && arm.params.arm.follows;
    if (!turns && !arm.animation.movesParams() && !std::isnan(seconds))
        return arm.params.joints;
    std::unique_ptr<Run>& run = m_runs[arm.id];
    if (!run || !run->isFor(arm))
        run = std::make_unique<Run>(arm);
    const LoopBlend blend = turns ? loopBlend(m_timeline, seconds) : LoopBlend();
    auto earlier = blend.weight > 0.0 ? run->driver.momentAt(blend.earlierSeconds, progress)
                                      : Expected<ArmMoment>(ArmMoment());
    if (!earlier)
        return fail(earlier.error());
    auto moment = run->driver.momentAt(seconds, progress);
    if (!moment)
        return fail(moment.error());
    if (blend.weight > 0.0)
        blendJoints(earlier->joints, blend.weight, moment->joints);
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
