#include "core/scene/kinds/node_kinds.h"

namespace ramure {

extern const NodeKindRow scatterKind;
const NodeKindRow scatterKind = {
    .kind = NodeKind::Scatter,
    .name = "scatter",
    .icon = "scatter",
    .word = RAMURE_NOOP("scatter"),
    .tip = RAMURE_NOOP("Scatter: %1"),
    .label = RAMURE_NOOP("Scatter"),
    .addId = "edit.addScatter",
    .addText = RAMURE_NOOP("&Scatter"),
    .addTip = RAMURE_NOOP("Add a scatter: many copies of the selected trees and shapes stand on the ground"),
};

} // namespace ramure
