/// \file
/// The options of `ramure-cli render` that say how a picture is taken: camera, lens, light and backdrop.
#pragma once

#include "app/cli/command_line.h"
#include "widgets/view/render/camera_items.h"
#include <optional>

namespace ramure::cli {

struct PictureOptions
{
    std::optional<Camera> camera; ///< else one that shows all that is visible
    QString cameraNode;           ///< the name of a camera of the scene, in the place of both; empty: none
    RenderOptions options;        ///< but for the lens
    double fStop = 0.0;           ///< 0: everything is sharp
    double focus = 0.0;           ///< m; 0: the camera's target
    QString skyFile;              ///< file for the sky; empty: none
    bool skyHasSun = false;
};

void addPictureOptions(CommandLine& line);
/// Errors: Invalid and Unknown, naming the option.
Expected<PictureOptions> pictureOptionsOf(const CommandLine& line);
/// With the lens that the options say, else with that of the view.
RenderOptions optionsFor(const PictureOptions& picture, const NodeView& view);

} // namespace ramure::cli
