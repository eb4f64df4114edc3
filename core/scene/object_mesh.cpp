#include "core/scene/object_mesh.h"

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

} // namespace ramure
