#include "core/rig/arm/arm_shape.h"
#include "core/scene/kinds/node_kinds.h"

namespace ramure {

static void beginArm(NodeParams& params)
{
    params.surface.color = {0.85, 0.55, 0.25};
    params.armSkin.radius = 0.3;
    params.arm.jointRadius = 0.15;
    params.arm.target = {1.0, -2.0, 0.2}; // on a new terrain
    for (ArmJoint& joint : params.joints) {
        joint.phi.mostSpeed = 3.0;
        joint.theta.mostSpeed = 1.5;
    }
}

/// In the pose of its joints.
static Expected<SharedMesh> armSolid(const NodeParams& params, const SharedMesh& own)
{
    const auto shape = armSolid(params, own.get(), shownArmPart(params));
    RAMURE_TRY(shape);
    return std::make_shared<const TriangleMesh>(posedArm(*shape, params));
}

extern const NodeKindRow armKind;
const NodeKindRow armKind = {
    .kind = NodeKind::Arm,
    .name = "arm",
    .icon = "arm",
    .word = RAMURE_NOOP("arm"),
    .tip = RAMURE_NOOP("Arm: %1"),
    .label = RAMURE_NOOP("Arm"),
    .many = RAMURE_NOOP("Arms"),
    .addId = "edit.addArm",
    .addText = RAMURE_NOOP("&Arm"),
    .addTip = RAMURE_NOOP("Add an articulated arm that reaches for targets"),
    .begin = &beginArm,
    .solid = &armSolid,
};

} // namespace ramure
