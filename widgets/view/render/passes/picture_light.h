/// \file
/// What lights a picture, in the numbers of its shaders: light of 1 on a level surface shows it as it is.
#pragma once

#include "widgets/view/render/light/picture_sky.h"
#include "widgets/view/render/light/sky.h"
#include "widgets/view/render/renderer_options.h"
#include <optional>

namespace ramure {

class ShaderProgram;

struct PictureLight
{
    glm::dvec3 sun{0.0, 1.0, 0.0};            ///< unit, towards it
    glm::vec3 sunlight{1.0f};                 ///< on a surface that faces it; linear
    Ambient ambient{};                        ///< of all the rest
    glm::vec3 studio{-1.0f};                  ///< sRGB; below 0: there is a horizon
    std::optional<Sky> sky;                   ///< of Backdrop::Sky, in the picture's brightness
    std::shared_ptr<const PictureSky> around; ///< of Backdrop::Picture
    float aroundTurn = 0.0f;                  ///< of it, 0..1
    float aroundScale = 1.0f;                 ///< from its brightness to the picture's
    glm::vec3 gain{1.0f};                     ///< exposure and white balance; linear

    /// Light and colours are those of a real sky.
    [[nodiscard]] bool isNatural() const { return sky || around; }
    /// Linear, as the picture shows it before exposure; of Backdrop::Sky alone.
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;
    /// How much more light falls on what stands than on the ground, so that it looks as bright.
    [[nodiscard]] float standing() const { return isNatural() ? 1.0f : 1.2f; }
    void set(ShaderProgram& program) const;
};

PictureLight lightOf(const SceneLight& light);

} // namespace ramure
