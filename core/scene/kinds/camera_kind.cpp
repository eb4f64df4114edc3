#include "core/scene/kinds/node_kinds.h"

namespace ramure {

extern const NodeKindRow cameraKind;
const NodeKindRow cameraKind = {
    .kind = NodeKind::Camera,
    .name = "camera",
    .icon = "camera",
    .word = RAMURE_NOOP("camera"),
    .tip = RAMURE_NOOP("Camera: %1"),
    .label = RAMURE_NOOP("Camera"),
    .addId = "edit.addCamera",
    .addText = RAMURE_NOOP("&Camera"),
    .addTip = RAMURE_NOOP("Add a camera with the present view"),
};

} // namespace ramure
