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
    arm.params.arm.target = {1.0, -2.0, 0.2}; // on the terrain
    for (ArmJoint& joint : arm.params.joints) {
        joint.phi.mostSpeed = 3.0;
        joint.theta.mostSpeed = 1.5;
    }
    Node terrain;
    terrain.id = 2;
    terrain.kind = NodeKind::Terrain;
    terrain.name = "Terrain";
    terrain.params.surface.color = {0.62, 0.55, 0.43};
    // Hills behind the arm, a basin before it, lowest along the sides: seen whole, it has no ragged edge.
    terrain.params.tree.rotation.y = std::numbers::pi;
    terrain.params.terrain.seed = 15344;
    terrain.params.terrain.height = 1.2;
    terrain.params.terrain.roughness = 0.42;
    // Both are new, different ids: this cannot fail.
    return Scene::fromNodes({arm, terrain}).value_or(Scene());
}

} // namespace ramure
