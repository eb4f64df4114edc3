#include "core/scene/kinds/node_kinds.h"
#include "core/surface/primitives/primitive_mesh.h"

namespace ramure {

static SharedMesh primitiveLook(const NodeParams& params, const SharedMesh& /*own*/)
{
    return std::make_shared<const TriangleMesh>(primitiveMesh(params.primitive));
}

static Expected<SharedMesh> primitiveSolid(const NodeParams& params, const SharedMesh& /*own*/)
{
    return std::make_shared<const TriangleMesh>(primitiveSolid(params.primitive));
}

static bool isOpenPrimitive(const NodeParams& params)
{
    return params.primitive.shape == PrimitiveShape::Plane;
}

extern const NodeKindRow primitiveKind;
const NodeKindRow primitiveKind = {
    .kind = NodeKind::Primitive,
    .name = "primitive",
    .icon = "cube",
    .word = RAMURE_NOOP("primitive"),
    .tip = RAMURE_NOOP("Primitive: %1"),
    .many = RAMURE_NOOP("Primitives"),
    .look = &primitiveLook,
    .solid = &primitiveSolid,
    .isOpen = &isOpenPrimitive,
};

} // namespace ramure
