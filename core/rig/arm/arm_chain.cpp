#include "core/rig/arm/arm_chain.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

} // namespace

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
        const auto [sp, cp] = maths::sincos(angles[2 * j]);
        const glm::dvec3 turned = cp * x + sp * y;
        y = cp * y - sp * x;
        m_axes[2 * j + 1] = y;
        const auto [st, ct] = maths::sincos(angles[2 * j + 1]);
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
