/// \file
/// What a scene takes up while it plays: for framing it so that nothing leaves the view.
#pragma once

#include "core/scene/scene.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

/// Points (world, m) for Camera::frame: those of \p built as it is now (see RenderScene::framePoints), and of
/// what keys move, in its places over the whole timeline, looked at some tens of times. Trees in the wind,
/// the bends of arms and what lies outside the timeline's range count only as they are now.
std::vector<glm::dvec3> framingPoints(const Scene& scene, const RenderScene& built);

/// Moments of the timeline, seconds, from its first to its last frame, for looking at what moves: the more
/// nodes there are, the fewer, so that it takes some milliseconds.
std::vector<double> momentsOf(const Scene& scene);

} // namespace ramure
