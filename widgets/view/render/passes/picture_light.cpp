#include "widgets/view/render/passes/picture_light.h"

#include "core/math/angle.h"
#include "widgets/view/render/shader_program.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

// Light on a level surface adds up to 1, so that the sunlit ground has exactly its colour; the sky's share is
// blue and the sun's therefore warm.
constexpr glm::vec3 skyLight{0.33f, 0.39f, 0.47f};
constexpr glm::vec3 groundLight{0.17f, 0.19f, 0.12f};
constexpr glm::dvec3 meadow{0.0931, 0.2051, 0.0612}; ///< linear; #567D46, as world.frag has it
constexpr glm::dvec3 brightness{0.2126, 0.7152, 0.0722};

/// sRGB; below 0: there is a horizon.
glm::vec3 studioColour(Backdrop backdrop)
{
    switch (backdrop) {
    case Backdrop::Landscape:
    case Backdrop::Sky:
        break;
    case Backdrop::LightStudio:
        return {0.93f, 0.93f, 0.92f};
    case Backdrop::DarkStudio:
        return {0.155f, 0.165f, 0.175f};
    }
    return glm::vec3(-1.0f);
}

/// As a photographer exposes: for what faces the light, so that a low sun does not burn out all that stands;
/// and not for all of it, so that an evening stays darker than a noon.
void takeSky(PictureLight& out, double turbidity)
{
    constexpr double lowestLevel = 0.45, middle = 1.2, noon = 100.0, kept = 0.2; // noon: klx
    constexpr glm::vec3 up(0.0f, 1.0f, 0.0f);
    Sky sky = clearSky(out.sun, turbidity);
    const glm::dvec3 above = pi * glm::dvec3(ambientAt(ambientOf(sky, glm::dvec3(0.0)), up));
    const double facing = glm::dot(brightness, above + sky.sunlight * std::max(out.sun.y, lowestLevel));
    const double level = facing / middle * std::pow(std::max(1.0, noon / facing), kept);
    const Ambient ambient = ambientOf(sky, meadow * (above + sky.sunlight * out.sun.y) / pi);
    for (std::size_t i = 0; i < ambient.size(); ++i)
        out.ambient[i] = ambient[i] * float(pi / level);
    out.sunlight = glm::vec3(sky.sunlight / level);
    sky.scale.x *= pi / level;
    out.sky = sky;
}

} // namespace

glm::dvec3 PictureLight::radiance(const glm::dvec3& direction) const
{
    if (direction.y >= 0.0)
        return sky->radiance(direction);
    return meadow * (glm::dvec3(ambientAt(ambient, {0.0f, 1.0f, 0.0f})) + glm::dvec3(sunlight) * sun.y);
}

void PictureLight::set(ShaderProgram& program) const
{
    static constexpr std::array ambientNames{"uAmbient[0]", "uAmbient[1]", "uAmbient[2]",
                                             "uAmbient[3]", "uAmbient[4]", "uAmbient[5]",
                                             "uAmbient[6]", "uAmbient[7]", "uAmbient[8]"};
    program.set("uSun", glm::vec3(sun));
    program.set("uSunLight", sunlight);
    for (std::size_t i = 0; i < ambient.size(); ++i)
        program.set(ambientNames[i], ambient[i]);
    program.set("uSunSpread", sky ? 0.0093f : 0.035f); // as wide as it is seen; elsewhere as of a hazy day
    program.set("uStanding", sky ? 1.0f : 1.2f);
    program.set("uAround", sky ? 1.0f : 0.0f);
    program.set("uGain", gain);
    program.set("uStudio", studio);
    program.set("uSky", sky.has_value());
    const Sky shown = sky.value_or(Sky{});
    program.set("uPerezA", glm::vec3(shown.a));
    program.set("uPerezB", glm::vec3(shown.b));
    program.set("uPerezC", glm::vec3(shown.c));
    program.set("uPerezD", glm::vec3(shown.d));
    program.set("uPerezE", glm::vec3(shown.e));
    program.set("uSkyScale", glm::vec3(shown.scale));
}

PictureLight lightOf(const SceneLight& light)
{
    PictureLight out;
    out.sun = light.sun();
    out.studio = studioColour(light.backdrop);
    out.gain = float(std::exp2(light.exposure));
    if (light.backdrop == Backdrop::Sky) {
        takeSky(out, light.turbidity);
        return out;
    }
    out.ambient = ambientOf(skyLight, groundLight);
    // A low sun has lost its blue on a long way through the air.
    const glm::vec3 warmth = glm::mix(glm::vec3(1.0f, 0.62f, 0.34f), glm::vec3(1.0f),
                                      float(glm::smoothstep(0.0, 30.0, light.heightDeg)));
    out.sunlight = warmth * (glm::vec3(1.0f) - skyLight) / float(std::max(out.sun.y, 0.2));
    return out;
}

} // namespace ramure
