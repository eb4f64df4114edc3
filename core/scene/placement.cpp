#include "core/scene/scene.h"

#include "core/math/reproducible.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace ramure {

glm::dmat3 rotationMatrix(const glm::dvec3& rotationRad)
{
    const auto x = maths::sincos(rotationRad.x), y = maths::sincos(rotationRad.y),
               z = maths::sincos(rotationRad.z);
    // The columns of Rz * Ry * Rx, multiplied out.
    return {
        glm::dvec3{z.cos * y.cos, z.sin * y.cos, -y.sin},
        glm::dvec3{z.cos * y.sin * x.sin - z.sin * x.cos, z.sin * y.sin * x.sin + z.cos * x.cos,
                   y.cos * x.sin},
        glm::dvec3{z.cos * y.sin * x.cos + z.sin * x.sin, z.sin * y.sin * x.cos - z.cos * x.sin,
                   y.cos * x.cos},
    };
}

glm::dmat4 placementMatrix(const PlacementParams& placement)
{
    const glm::dmat3 rotation = rotationMatrix(placement.rotation);
    return {
        glm::dvec4(rotation[0] * placement.scale.x, 0.0),
        glm::dvec4(rotation[1] * placement.scale.y, 0.0),
        glm::dvec4(rotation[2] * placement.scale.z, 0.0),
        glm::dvec4(placement.translation, 1.0),
    };
}

glm::dmat4 worldMatrix(const Scene& scene, NodeId id)
{
    glm::dmat4 world(1.0);
    for (const Node* node = scene.find(id); node; node = scene.find(node->parent))
        world = placementMatrix(node->params.tree) * world;
    return world;
}

glm::dmat4 geometryMatrix(const Scene& scene, const Node& node)
{
    return worldMatrix(scene, node.id) * placementMatrix(node.params.local);
}

/// Angles about X, Y, Z of a rotation matrix Rz * Ry * Rx. Where Y is a quarter turn, X and Z turn about one
/// axis: Z is 0 then.
static glm::dvec3 anglesOf(const glm::dmat3& r)
{
    const double cosY = maths::hypot(r[0][0], r[0][1]);
    const double y = maths::atan2(-r[0][2], cosY);
    if (cosY > 1e-9)
        return {maths::atan2(r[1][2], r[2][2]), y, maths::atan2(r[0][1], r[0][0])};
    return {maths::atan2(-r[2][1], r[1][1]), y, 0.0};
}

Expected<PlacementParams> decomposePlacement(const glm::dmat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return fail(ErrorCode::Invalid, RAMURE_NOOP("the place in the world is not a finite one"));
    if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 || matrix[3][3] != 1.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the place in the world is a projection"));

    glm::dmat3 axes(matrix);
    glm::dvec3 scale{glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])};
    if (!(scale.x > 0.0 && scale.y > 0.0 && scale.z > 0.0))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the place in the world is flat: a scale is zero"));
    if (glm::determinant(axes) < 0.0)
        scale.x = -scale.x;
    for (int i = 0; i < 3; ++i)
        axes[i] /= scale[i];
    constexpr double square = 1e-9; // cosine of the angle between two axes that count as perpendicular
    if (std::abs(glm::dot(axes[0], axes[1])) > square || std::abs(glm::dot(axes[1], axes[2])) > square ||
        std::abs(glm::dot(axes[2], axes[0])) > square)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("the place in the world is sheared: no rotation and scale give it"));

    PlacementParams placement;
    placement.translation = glm::dvec3(matrix[3]);
    placement.rotation = anglesOf(axes);
    placement.scale = scale;
    return placement;
}

} // namespace ramure
