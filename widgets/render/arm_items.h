/// \file
/// Pictures of arms (SPEC C1, C3): spheres at the joints and rods between them, the skin around them, and a
/// green sphere at the target.
#pragma once

#include "widgets/render/render_scene.h"
#include "widgets/render/scene_builder.h"
#include <span>

namespace ramure {

class ScenePartCache;

/// Spheres and rods of the straight arm, each vertex's branch its segment.
TriangleMesh armRods(std::span<const ArmJoint> joints, double jointRadius);

/// Appends an arm in the pose of its joints, upright in its node, or a terrain. False for other nodes.
/// \param world of the node's own geometry
bool addArmOrRelief(RenderScene& scene, ScenePartCache& cache, const Node& node, const glm::dmat4& world,
                    const SceneView& view);

} // namespace ramure
