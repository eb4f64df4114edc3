/// \file
/// How a picture is drawn, beyond scene and camera.
#pragma once

#include "widgets/view/render/display_mode.h"
#include <glm/vec3.hpp>

namespace ramure {

struct RenderOptions
{
    ShadingMode shading = ShadingMode::Solid;
    bool grid = false;  ///< metric grid on the ground
    bool ground = true; ///< without: the sky alone, and what lies below the ground is seen
    bool shadows = true;
    bool outline = true;     ///< around what is selected
    bool world = true;       ///< sky and ground; without: a transparent background
    int samples = 4;         ///< of multisampling, where the renderer owns the target; 0 = none
    bool smoothing = false;  ///< smooth the edges of the finished picture instead of multisampling
    double pixelRatio = 1.0; ///< device pixels per logical pixel: line widths
    int shadowTaps = 0;      ///< per pixel; 0 = 20 on hardware, 12 on a software rasteriser; under 12 the
                             ///< shadow is equally sharp everywhere
    glm::dvec3 sun{0.48, 0.72, 0.50}; ///< towards the sun, any length > 0
};

} // namespace ramure
