/// \file
/// What the picture of a print shows: the mesh as it will be printed, its overhangs in a colour of their own.
#pragma once

#include "core/print/print_tree.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

inline constexpr glm::u8vec3 printColour{206, 204, 198}, overhangColour{228, 128, 44},
    thinnestColour{214, 38, 58}; ///< sRGB, also of the legend

/// Meshes in m of the print, as they stand on its ground.
RenderScene previewScene(const PrintedTree& print);

/// All of it, from where the camera looks. \param aspect width by height
Camera wholePrint(const PrintedTree& print, Camera camera, double aspect);
/// Its thinnest place in the middle, from the side that the place is nearest to, so that nothing stands
/// before it as a rule.
Camera thinnestPlace(const PrintedTree& print, Camera camera);

} // namespace ramure
