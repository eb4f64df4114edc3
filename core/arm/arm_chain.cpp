#include "core/arm/arm_chain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

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
        joints[j].phi.angleRad = phis[j] * degree;
        joints[j].theta.angleRad = thetas[j] * degree;
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

std::vector<double> armAngles(std::span<const ArmJoint> joints)
{
    std::vector<double> angles;
    angles.reserve(2 * joints.size());
    for (const ArmJoint& joint : joints) {
        angles.push_back(joint.phi.angleRad);
        angles.push_back(joint.theta.angleRad);
    }
    return angles;
}

void setArmAngles(std::span<ArmJoint> joints, std::span<const double> angles)
{
    for (std::size_t j = 0; j < joints.size(); ++j) {
        joints[j].phi.angleRad = angles[2 * j];
        joints[j].theta.angleRad = angles[2 * j + 1];
    }
}

double wrappedAngle(double angleRad)
{
    return angleRad >= -pi && angleRad <= pi ? angleRad : std::remainder(angleRad, 2.0 * pi);
}

glm::dmat4 armUpright()
{
    return {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, -1.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
}

ArmChain::ArmChain(std::span<const ArmJoint> joints)
    : m_points(joints.size() + 1, glm::dvec3(0.0))
    , m_axes(2 * joints.size())
    , m_frames(joints.size())
{
    double longest = 0.0;
    for (const ArmJoint& joint : joints) {
        m_lengths.push_back(joint.length);
        m_reach += joint.length;
        longest = std::max(longest, joint.length);
    }
    // One segment that is longer than all others together cannot be folded back to the foot.
    m_leastReach = std::max(0.0, 2.0 * longest - m_reach);
    setAngles(armAngles(joints));
}

void ArmChain::setAngles(std::span<const double> angles)
{
    glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
    for (std::size_t j = 0; j < m_lengths.size(); ++j) {
        m_axes[2 * j] = z;
        const double cp = std::cos(angles[2 * j]), sp = std::sin(angles[2 * j]);
        const glm::dvec3 turned = cp * x + sp * y;
        y = cp * y - sp * x;
        m_axes[2 * j + 1] = y;
        const double ct = std::cos(angles[2 * j + 1]), st = std::sin(angles[2 * j + 1]);
        x = ct * turned - st * z;
        z = st * turned + ct * z;
        m_frames[j] = glm::dmat3(x, y, z);
        m_points[j + 1] = m_points[j] + m_lengths[j] * z;
    }
}

void ArmChain::jacobian(std::span<glm::dvec3> columns) const
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i] = glm::cross(m_axes[i], tip() - m_points[i / 2]);
}

void ArmChain::pose(std::vector<RigidTransform>& bones) const
{
    bones.resize(jointCount());
    double height = 0.0;
    for (std::size_t j = 0; j < bones.size(); ++j) {
        bones[j].rotation = glm::normalize(glm::quat_cast(m_frames[j]));
        bones[j].translation = m_points[j] - bones[j].rotation * glm::dvec3(0.0, 0.0, height);
        height += m_lengths[j];
    }
}

} // namespace ramure
