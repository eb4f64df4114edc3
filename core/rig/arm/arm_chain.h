/// \file
/// Computes the places of an arm's joints for given angles, and how its tip moves with each of them (SPEC C1,
/// C2).
///
/// The arm's own space: the foot at the origin, Z up. Joint j turns by R_axis(phi) * R_Y(theta) and goes on
/// along its own Z. Angles stand in one row: phi and theta of joint 0, phi and theta of joint 1 ...
#pragma once

#include "core/base/error.h"
#include "core/params/arm_params.h"
#include "core/rig/pose/pose.h"
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <span>

namespace ramure {

/// The angles of \p joints in one row.
std::vector<double> armAngles(std::span<const ArmJoint> joints);
/// The other way. \pre two angles per joint
void setArmAngles(std::span<ArmJoint> joints, std::span<const double> angles);

/// The same direction within -pi .. pi. Not finite stays so.
double wrappedAngle(double angleRad);

/// The arm's own space, Z up, as it stands in the world of its node, Y up: (x, y, z) -> (x, z, -y).
glm::dmat4 armUpright();

/// Keeps its buffers; setAngles allocates nothing.
class ArmChain
{
public:
    ArmChain() = default;
    /// \pre checkArm
    explicit ArmChain(std::span<const ArmJoint> joints);

    void setAngles(std::span<const double> angles); ///< \pre two per joint

    [[nodiscard]] std::size_t jointCount() const { return m_lengths.size(); }
    [[nodiscard]] std::size_t angleCount() const { return 2 * m_lengths.size(); }
    /// The joints from the foot on and, last, the tip.
    [[nodiscard]] std::span<const glm::dvec3> points() const { return m_points; }
    [[nodiscard]] const glm::dvec3& tip() const { return m_points.back(); }
    /// Columns: the axes of segment \p j, Z along it.
    [[nodiscard]] const glm::dmat3& frame(std::size_t j) const { return m_frames[j]; }
    /// About which the angle of the same number turns, unit.
    [[nodiscard]] std::span<const glm::dvec3> axes() const { return m_axes; }
    /// m: as far as the tip gets from the foot, and as near.
    [[nodiscard]] double reach() const { return m_reach; }
    [[nodiscard]] double leastReach() const { return m_leastReach; }
    /// Columns of J, by angle: how the tip moves per radian, axis x (tip - joint).
    void jacobian(std::span<glm::dvec3> columns) const;
    /// How each segment moved from the arm that stands straight up along Z (SPEC C3: T_j * inverse B_j).
    void pose(std::vector<RigidTransform>& bones) const;

private:
    std::vector<double> m_lengths;
    std::vector<glm::dvec3> m_points{glm::dvec3(0.0)};
    std::vector<glm::dvec3> m_axes;
    std::vector<glm::dmat3> m_frames;
    double m_reach = 0.0, m_leastReach = 0.0;
};

} // namespace ramure
