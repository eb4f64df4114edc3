/// \file
/// The pose of a skeleton at one time: one rigid transform per bone, in the space of the skeleton (tree space
/// for a tree), measured from its rest. A skin needs nothing else.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// x -> rotation * x + translation; the rotation is a unit quaternion.
struct RigidTransform
{
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 translation{0.0}; ///< m

    [[nodiscard]] glm::dvec3 point(const glm::dvec3& x) const { return rotation * x + translation; }
    /// Directions, normals, velocities: turned, not moved.
    [[nodiscard]] glm::dvec3 direction(const glm::dvec3& x) const { return rotation * x; }
    [[nodiscard]] glm::dmat4 matrix() const;
    [[nodiscard]] RigidTransform inverse() const;
    bool operator==(const RigidTransform&) const = default;
};

/// First \p inner, then \p outer.
RigidTransform operator*(const RigidTransform& outer, const RigidTransform& inner);

/// Returns a turn about \p pivot.
RigidTransform turnAbout(const glm::dvec3& pivot, const glm::dquat& rotation);

struct Pose
{
    double timeSeconds = 0.0;
    std::vector<RigidTransform> bones; ///< by bone (of a tree: by branch of the simplified skeleton)
    bool operator==(const Pose&) const = default;
};

} // namespace ramure
