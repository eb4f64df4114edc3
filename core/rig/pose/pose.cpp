#include "core/rig/pose/pose.h"

#include <glm/gtc/matrix_transform.hpp>

namespace ramure {

glm::dmat4 RigidTransform::matrix() const
{
    glm::dmat4 out = glm::mat4_cast(rotation);
    out[3] = glm::dvec4(translation, 1.0);
    return out;
}

RigidTransform RigidTransform::inverse() const
{
    const glm::dquat back = glm::conjugate(rotation);
    return {back, -(back * translation)};
}

RigidTransform operator*(const RigidTransform& outer, const RigidTransform& inner)
{
    return {outer.rotation * inner.rotation, outer.point(inner.translation)};
}

RigidTransform turnAbout(const glm::dvec3& pivot, const glm::dquat& rotation)
{
    return {rotation, pivot - rotation * pivot};
}

} // namespace ramure
