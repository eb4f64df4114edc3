#include "core/scene/object_mesh.h"

#include "core/math/stage_hash.h"

namespace ramure {

std::shared_ptr<const TriangleMesh> objectMesh(const Node& node, const NodeParams& params)
{
    const NodeKindRow& row = kindRow(node.kind);
    return row.look ? row.look(params, node.mesh.pointer()) : nullptr;
}

bool isOpenSurface(const Node& node)
{
    const NodeKindRow& row = kindRow(node.kind);
    return row.isOpen && row.isOpen(node.params);
}

Expected<std::shared_ptr<const TriangleMesh>> objectSolid(const Node& node, const NodeParams& params)
{
    const NodeKindRow& row = kindRow(node.kind);
    return row.solid ? row.solid(params, node.mesh.pointer()) : nullptr;
}

std::uint64_t shapeHash(const Node& node)
{
    if (node.kind == NodeKind::Mesh)
        return node.mesh && !node.mesh->empty() ? node.mesh.hash() : 0;
    StageHash hash(0);
    for (const double number : ownNumbers(node.kind, node.params))
        hash.add(number);
    return hash.value();
}

} // namespace ramure
