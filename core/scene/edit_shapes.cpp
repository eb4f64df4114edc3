#include "core/scene/edit_shapes.h"

#include "core/scene/object_mesh.h"
#include <glm/matrix.hpp>

namespace ramure {

Expected<EditShape> meshShape(const Scene& scene, NodeId treeId, NodeId solidId)
{
    const Node* const tree = scene.find(treeId);
    const Node* const solid = scene.find(solidId);
    if (!tree || !solid)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no such node"));
    const bool isSolid = solid->kind == NodeKind::Primitive || solid->kind == NodeKind::Mesh;
    const auto mesh = objectSolid(*solid, solid->params);
    if (!isSolid || !mesh || !*mesh || (*mesh)->triangles.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no solid"), {solid->name});
    const glm::dmat4 intoTree = glm::inverse(geometryMatrix(scene, *tree)) * geometryMatrix(scene, *solid);
    EditShape shape{EditShapeKind::Mesh, {}, {}, {}};
    for (const glm::vec3& p : (*mesh)->positions)
        shape.points.emplace_back(intoTree * glm::dvec4(p, 1.0));
    for (const glm::uvec3& t : (*mesh)->triangles)
        shape.triangles.push_back({t.x, t.y, t.z});
    return shape;
}

} // namespace ramure
