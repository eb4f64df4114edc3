#include "core/skeleton/bend.h"

#include "core/math/reproducible.h"
#include <glm/geometric.hpp>

namespace ramure {

glm::dquat bendRotation(const glm::dvec3& bendRad)
{
    const double angle = glm::length(bendRad);
    if (angle == 0.0)
        return glm::dquat(1.0, 0.0, 0.0, 0.0);
    return glm::normalize(maths::angleAxis(angle, bendRad / angle));
}

glm::dvec3 bendVector(const glm::dquat& rotation)
{
    const double sign = rotation.w < 0.0 ? -1.0 : 1.0; // the shorter way
    const glm::dvec3 part = sign * glm::dvec3(rotation.x, rotation.y, rotation.z);
    const double sine = glm::length(part);
    if (sine == 0.0)
        return glm::dvec3(0.0);
    return part / sine * (2.0 * maths::atan2(sine, sign * rotation.w));
}

std::vector<glm::dquat> bendRotations(const Skeleton& skeleton, std::span<const glm::dvec3> bendRad)
{
    std::vector<glm::dquat> turned(skeleton.size(), glm::dquat(1.0, 0.0, 0.0, 0.0));
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (skeleton.parent[i] != noIndex)
            turned[i] = turned[skeleton.parent[i]];
        if (bendRad[i] != glm::dvec3(0.0))
            turned[i] = glm::normalize(turned[i] * bendRotation(bendRad[i]));
    }
    return turned;
}

void bendBranches(Skeleton& skeleton, std::span<const glm::dvec3> bendRad)
{
    const std::vector<glm::dquat> turned = bendRotations(skeleton, bendRad);
    std::vector<bool> moves(skeleton.size(), false);
    for (Index i = 0; i < skeleton.size(); ++i) {
        const Index parent = skeleton.parent[i];
        const bool carried = parent != noIndex && moves[parent];
        moves[i] = carried || bendRad[i] != glm::dvec3(0.0);
        if (!moves[i])
            continue;
        const glm::dvec3 along = skeleton.p1[i] - skeleton.p0[i];
        if (carried)
            skeleton.p0[i] = skeleton.p1[parent];
        skeleton.p1[i] = skeleton.p0[i] + turned[i] * along;
    }
}

} // namespace ramure
