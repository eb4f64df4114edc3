#include "core/scene/kinds/node_kinds.h"

namespace ramure {

extern const NodeKindRow groupKind;
const NodeKindRow groupKind = {
    .kind = NodeKind::Group,
    .name = "group",
    .icon = "group",
    .word = RAMURE_NOOP("group"),
    .tip = RAMURE_NOOP("Group: %1"),
    .label = RAMURE_NOOP("Group"),
    .addId = "edit.addGroup",
    .addText = RAMURE_NOOP("&Group"),
};

} // namespace ramure
