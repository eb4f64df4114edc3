#include "core/rig/pose/bend_pose.h"

#include "core/skeleton/bend.h"

namespace ramure {

std::vector<RigidTransform> bendPose(const Skeleton& skeleton, std::span<const glm::dvec3> fromRad,
                                     std::span<const glm::dvec3> toRad)
{
    const std::vector<glm::dquat> from = bendRotations(skeleton, fromRad);
    const std::vector<glm::dquat> to = bendRotations(skeleton, toRad);
    std::vector<RigidTransform> bones(skeleton.size());
    for (Index b = 0; b < skeleton.size(); ++b) {
        const Index parent = skeleton.parent[b];
        const bool carried = parent != noIndex && bones[parent] != RigidTransform();
        if (!carried && fromRad[b] == toRad[b])
            continue;
        const glm::dvec3& foot = skeleton.p0[b];
        const glm::dquat turn = glm::normalize(to[b] * glm::conjugate(from[b]));
        bones[b] = {turn, (carried ? bones[parent].point(foot) : foot) - turn * foot};
    }
    return bones;
}

} // namespace ramure
