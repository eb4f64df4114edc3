// Arms as the views of moving scenes see them.
#include "core/rig/arm/arm_chain.h"
#include "core/session/motion.h"

#include <algorithm>

namespace ramure {

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
