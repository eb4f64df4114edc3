#include "core/scene/kinds/node_kinds.h"
#include "core/surface/mesh/normals.h"

namespace ramure {

static Expected<SharedMesh> meshSolid(const NodeParams& /*params*/, const SharedMesh& own)
{
    return own && !own->empty() ? own : nullptr;
}

static SharedMesh meshLook(const NodeParams& /*params*/, const SharedMesh& own)
{
    if (!own || own->empty() || own->normals.size() == own->positions.size())
        return own && !own->empty() ? own : nullptr;
    auto smooth = std::make_shared<TriangleMesh>(*own);
    computeNormals(*smooth);
    return smooth;
}

extern const NodeKindRow meshKind;
const NodeKindRow meshKind = {
    .kind = NodeKind::Mesh,
    .name = "mesh",
    .icon = "mode-mesh",
    .word = RAMURE_NOOP("mesh"),
    .tip = RAMURE_NOOP("Imported mesh: %1"),
    .many = RAMURE_NOOP("Imported meshes"),
    .look = &meshLook,
    .solid = &meshSolid,
};

} // namespace ramure
