#include "core/scene/object_mesh.h"

#include "core/rig/arm/arm_shape.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/primitives/primitive_mesh.h"
#include "core/surface/primitives/terrain.h"

namespace ramure {

static std::shared_ptr<const TriangleMesh> importedMesh(const Node& node)
{
    return node.mesh && !node.mesh->empty() ? node.mesh.pointer() : nullptr;
}

std::shared_ptr<const TriangleMesh> objectMesh(const Node& node, const NodeParams& params)
{
    if (node.kind == NodeKind::Primitive)
        return std::make_shared<const TriangleMesh>(primitiveMesh(params.primitive));
    if (node.kind == NodeKind::Terrain) {
        auto terrain = buildTerrain(params.terrain);
        return terrain ? std::make_shared<const TriangleMesh>(std::move(*terrain)) : nullptr;
    }
    auto mesh = node.kind == NodeKind::Mesh ? importedMesh(node) : nullptr;
    if (!mesh || mesh->normals.size() == mesh->positions.size())
        return mesh;
    auto smooth = std::make_shared<TriangleMesh>(*mesh);
    computeNormals(*smooth);
    return smooth;
}

bool isOpenSurface(const Node& node)
{
    return node.kind == NodeKind::Terrain ||
           (node.kind == NodeKind::Primitive && node.params.primitive.shape == PrimitiveShape::Plane);
}

Expected<std::shared_ptr<const TriangleMesh>> objectSolid(const Node& node, const NodeParams& params)
{
    const auto shared = [](TriangleMesh&& mesh) {
        return std::make_shared<const TriangleMesh>(std::move(mesh));
    };
    switch (node.kind) {
    case NodeKind::Primitive:
        return shared(primitiveSolid(params.primitive));
    case NodeKind::Mesh:
        return importedMesh(node);
    case NodeKind::Terrain: {
        auto terrain = buildTerrain(params.terrain);
        if (!terrain)
            return fail(std::move(terrain.error()));
        return shared(std::move(*terrain));
    }
    case NodeKind::Arm: {
        const auto shape = armSolid(params, node.mesh.pointer().get(), shownArmPart(params));
        if (!shape)
            return fail(shape.error());
        return shared(posedArm(*shape, params));
    }
    case NodeKind::Group:
    case NodeKind::Tree:
        break;
    }
    return nullptr;
}

} // namespace ramure
