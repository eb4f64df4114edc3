/// \file
/// Tests whether points lie in a shape that a tree is pruned to.
#pragma once

#include "core/base/error.h"
#include "core/math/bvh.h"
#include "core/params/tree_edit.h"

namespace ramure {

class ShapeTest
{
public:
    /// \param shape as checkTreeEdit wants it; kept by reference.
    explicit ShapeTest(const EditShape& shape);

    /// Error: Invalid (a mesh that is not closed has no inside).
    [[nodiscard]] Expected<void> check() const;
    [[nodiscard]] bool contains(const glm::dvec3& point) const;

private:
    [[nodiscard]] bool inProfile(const glm::dvec3& fromFoot) const;
    [[nodiscard]] bool inMesh(const glm::dvec3& point) const;
    [[nodiscard]] glm::dvec3 areaVector(Index triangle) const;

    const EditShape& m_shape;
    Bvh m_triangles;
    double m_outward = 1.0; ///< -1: the mesh's faces look inward
    bool m_isClosed = true;
};

} // namespace ramure
