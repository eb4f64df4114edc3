/// \file
/// How a picture is drawn, beyond scene and camera.
#pragma once

#include "widgets/view/render/display_mode.h"
#include "widgets/view/render/lens.h"
#include "widgets/view/render/light/sky.h"
#include "widgets/view/render/light/white_balance.h"
#include <cmath>
#include <cstdint>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <memory>

namespace ramure {

struct PictureSky;

/// The background of the scene.
enum class Backdrop : std::uint8_t {
    Landscape,   ///< sky and meadow
    LightStudio, ///< one colour that takes shadows
    DarkStudio,
    Sky,     ///< a clear day as it is: light, colours and haze by where the sun stands (sky.h)
    Picture, ///< an artist's own, with its sun and its light (picture_sky.h)
};

struct SceneLight
{
    static constexpr double leastHeightDeg = leastSunHeightDeg;

    double azimuthDeg = 136.0; ///< the sun's direction, clockwise from the north (-Z): 90 is the east (+X)
    double heightDeg = 46.0;   ///< the sun's height over the horizon, leastHeightDeg .. 90
    Backdrop backdrop = Backdrop::Landscape;
    double turbidity = 3.0; ///< haze of Backdrop::Sky, Sky::leastTurbidity .. mostTurbidity
    double exposure = 0.0;  ///< f-stops, -mostStops .. mostStops
    std::shared_ptr<const PictureSky> picture{}; ///< of Backdrop::Picture; null: that is Backdrop::Sky
    double turnDeg = 0.0;                        ///< of the picture, clockwise seen from above
    double whiteKelvin = usualKelvin;            ///< whiteBalance()
    static constexpr double mostStops = 5.0;

    /// Unit, towards the sun.
    [[nodiscard]] glm::dvec3 sun() const
    {
        const double azimuth = glm::radians(azimuthDeg), height = glm::radians(heightDeg);
        return {std::sin(azimuth) * std::cos(height), std::sin(height),
                -std::cos(azimuth) * std::cos(height)};
    }
    bool operator==(const SceneLight&) const = default;
};

/// The wind of a game at one moment, for trees that are prepared for it (item_wind.h).
struct WindMoment
{
    double strength = 0.0; ///< 1: a strong wind
    double seconds = 0.0;
    bool operator==(const WindMoment&) const = default;
};

struct RenderOptions
{
    ShadingMode shading = ShadingMode::Solid;
    Quality quality = Quality::Draft;
    bool hurried = false; ///< something moves: leaves of fewer triangles, one sample a pixel
    bool sparing = false; ///< small leaves of fewer triangles, for views that a processor draws
    bool grid = false;    ///< metric grid on the ground
    bool ground = true;   ///< off: the sky alone, and objects below the ground are visible
    bool shadows = true;
    bool outline = true; ///< around the selection
    float outlineOpacity = 1.0f;
    bool world = true;       ///< sky and ground; without: a transparent background
    int samples = 4;         ///< samples per pixel if the renderer owns the target; 0 = no multisampling
    int pictures = 1;        ///< drawn in one aside, each a part of a pixel beside the other: finer edges
    bool smoothing = false;  ///< smooth the edges of the finished picture instead of multisampling
    double pixelRatio = 1.0; ///< device pixels per logical pixel: line widths
    int shadowTaps = 0;      ///< per pixel; 0 = 20 on hardware, 12 on a software rasteriser; under 12 the
                             ///< shadow is equally sharp everywhere
    SceneLight light;
    Lens lens;
    WindMoment wind;
    bool operator==(const RenderOptions&) const = default;
};

} // namespace ramure
