/// \file
/// Collects the extent of a scene while it plays, to frame it so that nothing leaves the view.
#pragma once

#include "core/scene/scene.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

/// Returns points (world, m) for Camera::frame: the points of \p built as it is now (see
/// RenderScene::framePoints), and the places of keyed nodes at some tens of times over the whole timeline.
/// Trees in the wind, the bends of arms and motion outside the timeline's range count only as they are now.
std::vector<glm::dvec3> framingPoints(const Scene& scene, const RenderScene& built);

/// Moments of the timeline, seconds, from its first to its last frame, for looking at what moves: the more
/// nodes there are, the fewer, so that it takes some milliseconds.
std::vector<double> momentsOf(const Scene& scene);

} // namespace ramure
