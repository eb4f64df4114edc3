#include "core/scene/object_mesh.h"

#include "core/mesh/normals.h"
#include "core/mesh/primitive_mesh.h"

namespace ramure {

static std::shared_ptr<const TriangleMesh> importedMesh(const Node& node)
{
    return node.mesh && !node.mesh->empty() ? node.mesh.pointer() : nullptr;
}

std::shared_ptr<const TriangleMesh> objectMesh(const Node& node, const NodeParams& params)
{
    if (node.kind == NodeKind::Primitive)
        return std::make_shared<const TriangleMesh>(primitiveMesh(params.primitive));
    auto mesh = node.kind == NodeKind::Mesh ? importedMesh(node) : nullptr;
    if (!mesh || mesh->normals.size() == mesh->positions.size())
        return mesh;
    auto smooth = std::make_shared<TriangleMesh>(*mesh);
    computeNormals(*smooth);
    return smooth;
}

std::shared_ptr<const TriangleMesh> objectSolid(const Node& node, const NodeParams& params)
{
    if (node.kind == NodeKind::Primitive)
        return std::make_shared<const TriangleMesh>(primitiveSolid(params.primitive));
    return node.kind == NodeKind::Mesh ? importedMesh(node) : nullptr;
}

} // namespace ramure
