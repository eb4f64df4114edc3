/// \file
/// What the pictures of the panel of levels show: one level, or the whole tree, both as the view draws a
/// tree.
#pragma once

#include "core/qt/session/export/level_watch.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/scene_builder.h"
#include <optional>

namespace ramure {

/// \param level nothing: the whole tree. Bark has its picture where the view has made the tree's texture
/// coordinates by now. Never fails: what cannot be made is left out.
RenderScene levelScene(SceneBuilder& builder, const TreeLevels& of, std::optional<std::size_t> level);

/// How a picture is taken.
struct LevelShot
{
    double distance = 1.0; ///< m in the scene, from the eye to the middle of the tree
    bool enlarged =
        false; ///< the tree fills the picture; else it has the pixels of a screen of levelScreenHeight
    double yawRad = 0.6, pitchRad = 0.05;
    bool operator==(const LevelShot&) const = default;
};
/// The same perspective either way: enlarged is the same picture through a longer lens. \param size pixels
Camera levelCamera(const TreeLevels& of, const LevelShot& shot, const glm::ivec2& size);
/// How high the tree is on that screen.
double levelPixels(const TreeLevels& of, double distance);

} // namespace ramure
