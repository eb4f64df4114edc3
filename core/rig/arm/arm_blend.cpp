#include "core/rig/arm/arm_blend.h"

#include <cmath>
#include <numbers>

namespace ramure {

static void blendAngle(const ArmAngle& other, double weight, ArmAngle& angle)
{
    const double way = other.angleRad - angle.angleRad;
    angle.angleRad += weight * (angle.limited ? way : std::remainder(way, 2.0 * std::numbers::pi));
}

void blendJoints(std::span<const ArmJoint> other, double weight, std::vector<ArmJoint>& joints)
{
    for (std::size_t i = 0; i < joints.size(); ++i) {
        blendAngle(other[i].phi, weight, joints[i].phi);
        blendAngle(other[i].theta, weight, joints[i].theta);
    }
}

} // namespace ramure
