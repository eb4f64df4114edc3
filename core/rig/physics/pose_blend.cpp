#include "core/rig/physics/pose_blend.h"

namespace ramure {

void blendPose(const TreeBody& body, const Pose& other, double weight, Pose& pose)
{
    for (Index slot = 0; slot < body.size(); ++slot) {
        const Index parent = body.parent[slot], branch = body.branchOf[slot];
        const glm::dvec3& rest = body.p0[slot];
        // Parents have lower slots: theirs is blended already.
        const glm::dvec3 p0 = parent == noIndex ? pose.bones[branch].point(rest)
                                                : pose.bones[body.branchOf[parent]].point(rest);
        const glm::dquat rotation =
            glm::normalize(glm::slerp(pose.bones[branch].rotation, other.bones[branch].rotation, weight));
        pose.bones[branch] = {rotation, p0 - rotation * rest};
    }
}

} // namespace ramure
