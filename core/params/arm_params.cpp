#include "core/params/arm_params.h"

#include "core/math/angle.h"

#include <cmath>
#include <string>

namespace ramure {
namespace {

tl::unexpected<Error> wrong(const char* text, std::size_t joint, const char* member)
{
    tl::unexpected<Error> error = fail(ErrorCode::Invalid, text);
    error.value().path = "joints[";
    error.value().path.append(std::to_string(joint)).append("].").append(member);
    return error;
}

Expected<void> checkAngle(const ArmAngle& angle, std::size_t joint, const std::string& name)
{
    const auto at = [&](const char* member) { return name + member; };
    if (!std::isfinite(angle.angleRad))
        return wrong(RAMURE_NOOP("An angle must be a number"), joint, at("angleRad").c_str());
    if (!std::isfinite(angle.minRad) || !std::isfinite(angle.maxRad) || angle.minRad > angle.maxRad)
        return wrong(RAMURE_NOOP("The lower limit of an angle must not be over the upper one"), joint,
                     at("minRad").c_str());
    if (!std::isfinite(angle.mostSpeed) || angle.mostSpeed < 0.0)
        return wrong(RAMURE_NOOP("A speed limit must not be negative"), joint, at("mostSpeed").c_str());
    return {};
}

} // namespace

std::vector<ArmJoint> defaultArmJoints()
{
    constexpr double lengths[] = {1.7, 1.5, 1.2};
    constexpr double phis[] = {45.0, 0.0, -30.0};
    constexpr double thetas[] = {30.0, 20.0, -20.0};
    std::vector<ArmJoint> joints(3);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        joints[j].length = lengths[j];
        joints[j].phi.angleRad = phis[j] * oneDegree;
        joints[j].theta.angleRad = thetas[j] * oneDegree;
    }
    return joints;
}

Expected<void> checkArm(std::span<const ArmJoint> joints)
{
    if (joints.size() < leastArmJoints || joints.size() > mostArmJoints) {
        tl::unexpected<Error> error = fail(ErrorCode::Invalid, RAMURE_NOOP("An arm has 1 to 64 joints"));
        error.value().path = "joints";
        return error;
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (!std::isfinite(joints[j].length) || joints[j].length <= 0.0)
            return wrong(RAMURE_NOOP("A segment must be longer than 0"), j, "length");
        if (const auto checked = checkAngle(joints[j].phi, j, "phi."); !checked)
            return checked;
        if (const auto checked = checkAngle(joints[j].theta, j, "theta."); !checked)
            return checked;
    }
    return {};
}

} // namespace ramure
