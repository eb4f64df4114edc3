#include "core/scene/kinds/node_kinds.h"

namespace ramure {

extern const NodeKindRow treeKind, primitiveKind, meshKind, armKind, terrainKind, cameraKind, scatterKind,
    groupKind;

std::span<const NodeKindRow* const> nodeKinds()
{
    static constexpr const NodeKindRow* table[] = {&treeKind,    &primitiveKind, &meshKind,    &armKind,
                                                   &terrainKind, &cameraKind,    &scatterKind, &groupKind};
    return table;
}

} // namespace ramure
