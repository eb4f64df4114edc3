#include "core/scene/kinds/node_kinds.h"

namespace ramure {

extern const NodeKindRow treeKind;
const NodeKindRow treeKind = {
    .kind = NodeKind::Tree,
    .name = "tree",
    .icon = "tree",
    .word = RAMURE_NOOP("tree"),
    .tip = RAMURE_NOOP("Tree: %1"),
};

} // namespace ramure
