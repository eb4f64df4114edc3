/// \file
/// Camera nodes: what they see, and what is seen of them.
#pragma once

#include "core/evaluate/evaluator.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/renderer_options.h"
#include <optional>

namespace ramure {

class ScenePartCache;

/// Of a node that stands so in the world. Scales and shears of \p world do not matter. What is sharp is the
/// target.
Camera cameraAt(const glm::dmat4& world, const CameraParams& params);
/// Where a camera node must stand in the world to see what \p camera sees, without a scale.
glm::dmat4 standingOf(const Camera& camera);
Lens lensOf(const CameraParams& params);

struct NodeView
{
    Camera camera;
    Lens lens;
};
/// What the camera \p id sees at the scene's time. Nothing where there is no such camera.
std::optional<NodeView> viewThrough(EvaluatedScene& now, NodeId id);

/// A body to click on and lines around what it sees. Not framed, no shadow.
void addCamera(RenderScene& scene, ScenePartCache& cache, const Node& node, const CameraParams& params,
               const glm::dmat4& world, bool isSelected);

} // namespace ramure
