#include "core/rig/physics/pose_blend.h"

#include "core/rig/tracks/quaternions.h"

namespace ramure {

void blendPose(const TreeBody& body, const Pose& other, double weight, Pose& pose)
{
    for (Index slot = 0; slot < body.size(); ++slot) {
        const Index parent = body.parent[slot], branch = body.branchOf[slot];
        const glm::dvec3& rest = body.p0[slot];
        // Parents have lower slots: theirs is blended already.
        glm::dvec3 p0 = pose.bones[parent == noIndex ? branch : body.branchOf[parent]].point(rest);
        if (parent == noIndex) // of what stands both are the same
            p0 += weight * (other.bones[branch].point(rest) - p0);
        const glm::dquat &from = pose.bones[branch].rotation, &to = other.bones[branch].rotation;
        const glm::dquat rotation = slerped(from, glm::dot(from, to) < 0.0 ? -to : to, weight); // shorter way
        pose.bones[branch] = {rotation, p0 - rotation * rest};
    }
}

} // namespace ramure
