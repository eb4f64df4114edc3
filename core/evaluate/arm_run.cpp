#include "core/evaluate/arm_run.h"

#include "core/rig/arm/arm_blend.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/loop_blend.h"
#include <algorithm>

namespace ramure {

void ArmRun::set(const NodeParams& params, const NodeAnimation& animation)
{
    if (m_driver && m_params == params && m_animation == animation)
        return;
    if (!m_driver || m_params.joints != params.joints || m_params.ik != params.ik ||
        m_params.arm != params.arm || !(m_animation == animation))
        m_driver.emplace(armDriver(params, animation));
    m_params = params;
    m_animation = animation;
}

Expected<ArmMoment> ArmRun::momentAt(double seconds, const TimelineSettings& timeline,
                                     const Progress& progress)
{
    const LoopBlend blend = m_params.arm.follows ? loopBlend(timeline, seconds) : LoopBlend();
    if (blend.weight == 0.0)
        return m_driver->momentAt(seconds, progress);
    const auto earlier = m_driver->momentAt(blend.earlierSeconds, progress);
    if (!earlier)
        return earlier;
    auto moment = m_driver->momentAt(seconds, progress);
    if (!moment)
        return moment;
    blendJoints(earlier->joints, blend.weight, moment->joints);
    moment->angles = armAngles(moment->joints);
    return moment;
}

static bool movesLengths(const NodeAnimation& animation)
{
    return std::any_of(animation.tracks().begin(), animation.tracks().end(), [](const auto& entry) {
        const JointDef* def = entry.first.jointDef();
        return def && !def->angle;
    });
}

Expected<NodeMotion> ArmRun::motionAt(double seconds, const TimelineSettings& timeline,
                                      const Progress& progress)
{
    auto moment = momentAt(seconds, timeline, progress);
    RAMURE_TRY(moment);
    NodeMotion motion = armMotion(m_params, moment->joints);
    motion.step = m_animation.movesParams() || (seconds > 0.0 && m_params.arm.follows) ? 1 : 0;
    motion.reshapes = movesLengths(m_animation);
    auto told = std::make_shared<ArmProgress>();
    told->limits = armLimits(moment->joints, moment->angles);
    told->angles = std::move(moment->angles);
    told->figures = moment->figures;
    told->residual = moment->residual;
    told->residuals = std::move(moment->residuals);
    // What the solver has reached the arm may still be on its way to.
    told->moves = told->figures.status == ArmStatus::Reached && told->residual > m_params.ik.tolerance;
    motion.arm = std::move(told);
    return motion;
}

std::vector<ArmLimit> armLimits(std::span<const ArmJoint> joints, std::span<const double> angles)
{
    std::vector<ArmLimit> limits(angles.size(), ArmLimit::Free);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const ArmAngle& rule = i % 2 == 0 ? joints[i / 2].phi : joints[i / 2].theta;
        if (rule.limited && angles[i] >= rule.maxRad)
            limits[i] = ArmLimit::Upper;
        else if (rule.limited && angles[i] <= rule.minRad)
            limits[i] = ArmLimit::Lower;
    }
    return limits;
}

NodeMotion armMotion(const NodeParams& params, std::span<const ArmJoint> joints)
{
    const ArmChain chain(joints);
    auto bones = std::make_shared<std::vector<RigidTransform>>();
    chain.pose(*bones);
    NodeMotion motion;
    motion.method = params.skin.method;
    motion.bones = std::move(bones);
    for (const glm::dvec3& point : chain.points())
        motion.box.add(point);
    motion.box = motion.box.grown(std::max(params.armSkin.radius, params.arm.jointRadius));
    motion.step = 1;
    return motion;
}

} // namespace ramure
