/// \file
/// Pictures of arms (SPEC C1, C3): spheres at the joints and rods between them, the skin around them (a
/// cylinder or a bound mesh), and a green sphere at the target.
#pragma once

#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/scene_builder.h"

namespace ramure {

class ScenePartCache;

/// Returns the place of the target's mark in the arm's node.
glm::dmat4 armTargetPlace(const glm::dvec3& target);

/// Appends an arm in the pose of its joints, upright in its node. A mesh that no arm can wear is left out.
/// \param params at the scene's time \param world transform of the node's own geometry
void addArm(RenderScene& scene, ScenePartCache& cache, const Node& node, const NodeParams& params,
            const glm::dmat4& world, DisplayMode mode);

} // namespace ramure
