/// \file
/// Camera nodes: their view, and their look in the scene.
#pragma once

#include "core/evaluate/evaluator.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/renderer_options.h"
#include <optional>

namespace ramure {

class ScenePartCache;

/// Returns the camera of a node with this place in the world. Scales and shears of \p world are ignored. The
/// target is in focus.
Camera cameraAt(const glm::dmat4& world, const CameraParams& params);
/// Returns the place, without a scale, that a camera node needs to have the view of \p camera.
glm::dmat4 standingOf(const Camera& camera);
Lens lensOf(const CameraParams& params);

struct NodeView
{
    Camera camera;
    Lens lens;
};
/// Returns the view through the camera \p id at the scene's time. Nothing if there is no such camera.
std::optional<NodeView> viewThrough(EvaluatedScene& now, NodeId id);

/// Adds a body to click on and lines around the camera's view. Not framed, no shadow.
void addCamera(RenderScene& scene, ScenePartCache& cache, const Node& node, const CameraParams& params,
               const glm::dmat4& world, bool isSelected);

} // namespace ramure
