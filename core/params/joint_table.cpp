#include "core/params/joint_table.h"

#include "core/math/angle.h"

#include <algorithm>
#include <array>

namespace ramure {
namespace {

constexpr JointDef angleRow(const char* key, const char* label, const char* tooltip,
                            ArmAngle ArmJoint::*angle, double ArmAngle::*member)
{
    if (member == &ArmAngle::mostSpeed)
        return {key, label, tooltip, ParamUnit::Radian, 0.0, 1e3, 0.0, 2 * pi, oneDegree, 1, angle, member};
    return {key, label, tooltip, ParamUnit::Radian, -1e3, 1e3, -pi, pi, oneDegree, 1, angle, member};
}

constexpr std::array<JointDef, 9> rows{
    JointDef{"length", RAMURE_NOOP("Length"),
             RAMURE_NOOP("Length of the segment behind the joint, in metres"), ParamUnit::Metre, 1e-4, 1e4,
             0.01, 5.0, 0.1, 3, nullptr, nullptr},
    angleRow("phi.angle", RAMURE_NOOP("Phi"),
             RAMURE_NOOP("Turns about the segment before the joint, degrees"), &ArmJoint::phi,
             &ArmAngle::angleRad),
    angleRow("phi.min", RAMURE_NOOP("Phi from"), RAMURE_NOOP("Lower limit of phi, degrees"), &ArmJoint::phi,
             &ArmAngle::minRad),
    angleRow("phi.max", RAMURE_NOOP("Phi to"), RAMURE_NOOP("Upper limit of phi, degrees"), &ArmJoint::phi,
             &ArmAngle::maxRad),
    angleRow("phi.mostSpeed", RAMURE_NOOP("Phi speed"),
             RAMURE_NOOP("The most phi turns, degrees a second; 0 is as fast as it likes"), &ArmJoint::phi,
             &ArmAngle::mostSpeed),
    angleRow("theta.angle", RAMURE_NOOP("Theta"),
             RAMURE_NOOP("Bends the arm about the joint's Y axis, degrees"), &ArmJoint::theta,
             &ArmAngle::angleRad),
    angleRow("theta.min", RAMURE_NOOP("Theta from"), RAMURE_NOOP("Lower limit of theta, degrees"),
             &ArmJoint::theta, &ArmAngle::minRad),
    angleRow("theta.max", RAMURE_NOOP("Theta to"), RAMURE_NOOP("Upper limit of theta, degrees"),
             &ArmJoint::theta, &ArmAngle::maxRad),
    angleRow("theta.mostSpeed", RAMURE_NOOP("Theta speed"),
             RAMURE_NOOP("The most theta turns, degrees a second; 0 is as fast as it likes"),
             &ArmJoint::theta, &ArmAngle::mostSpeed),
};

} // namespace

std::span<const JointDef> jointTable()
{
    return rows;
}

std::optional<std::size_t> jointNumber(std::string_view key)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (key == rows[i].key)
            return i;
    return std::nullopt;
}

std::size_t jointAngleNumber(bool phi)
{
    return phi ? 1 : 5;
}

void settleAngle(ArmAngle& angle)
{
    angle.maxRad = std::max(angle.maxRad, angle.minRad);
    if (angle.limited)
        angle.angleRad = std::clamp(angle.angleRad, angle.minRad, angle.maxRad);
}

} // namespace ramure
