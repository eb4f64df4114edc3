#include "core/scene/arm_demo.h"

namespace ramure {

Scene armDemo()
{
    Node arm;
    arm.id = 1;
    arm.kind = NodeKind::Arm;
    arm.name = "Arm";
    arm.params.surface.color = {0.85, 0.55, 0.25};
    arm.params.armSkin.radius = 0.3;
    arm.params.arm.jointRadius = 0.15;
    arm.params.arm.target = {1.5, -1.5, 0.6};
    for (ArmJoint& joint : arm.params.joints) {
        joint.phi.mostSpeed = 3.0;
        joint.theta.mostSpeed = 1.5;
    }
    Node terrain;
    terrain.id = 2;
    terrain.kind = NodeKind::Relief;
    terrain.name = "Terrain";
    terrain.params.surface.color = {0.34, 0.49, 0.27};
    // Both are new, different ids: this cannot fail.
    return Scene::fromNodes({arm, terrain}).value_or(Scene());
}

} // namespace ramure
