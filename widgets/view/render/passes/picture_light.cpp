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
    case Backdrop::Picture:
        break;
    case Backdrop::LightStudio:
        return {0.93f, 0.93f, 0.92f};
    case Backdrop::DarkStudio:
        return {0.155f, 0.165f, 0.175f};
    }
    return glm::vec3(-1.0f);
}

constexpr glm::vec3 up(0.0f, 1.0f, 0.0f);
constexpr double middle = 1.2; ///< how bright a picture shows what faces the light

/// What a photographer exposes for: what faces the light, so that a low sun does not burn out all that
/// stands. \param above on a level surface, without the sun's
double facingLight(const glm::dvec3& above, const glm::dvec3& sunlight, const glm::dvec3& sun)
{
    constexpr double lowestLevel = 0.45;
    return glm::dot(brightness, above + sunlight * std::max(sun.y, lowestLevel));
}

/// And not for all of it: an evening stays darker than a noon. \param facing klx
double dimness(double facing)
{
    constexpr double noon = 100.0, kept = 0.2; // noon: klx
    return std::pow(std::max(1.0, noon / facing), kept);
}

glm::dvec3 levelLight(const Ambient& ambient)
{
    return pi * glm::dvec3(ambientAt(ambient, up));
}

void takeSky(PictureLight& out, double turbidity)
{
    Sky sky = clearSky(out.sun, turbidity);
    const glm::dvec3 above = levelLight(ambientOf(sky, glm::dvec3(0.0)));
    const double facing = facingLight(above, sky.sunlight, out.sun);
    const double level = facing / middle * dimness(facing);
    const Ambient ambient = ambientOf(sky, meadow * (above + sky.sunlight * out.sun.y) / pi);
    for (std::size_t i = 0; i < ambient.size(); ++i)
        out.ambient[i] = ambient[i] * float(pi / level);
    out.sunlight = glm::vec3(sky.sunlight / level);
    sky.scale.x *= pi / level;
    out.sky = sky;
}

glm::dvec3 turned(const glm::dvec3& v, double turn)
{
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}

/// A picture's numbers have any unit: it is exposed for itself, and with a low sun as dim as a clear day with
/// such a one.
void takePicture(PictureLight& out, const SceneLight& light)
{
    constexpr double turbidity = 3.0;
    const PictureSky& picture = *light.picture;
    const double turn = light.turnDeg * oneDegree;
    const bool hasSun = picture.sunlight != glm::dvec3(0.0);
    const Ambient ambient =
        ambientOf([&](const glm::dvec3& way) { return picture.restAt(turned(way, -turn)); });
    out.sun = turned(picture.sun, turn);
    double level = facingLight(levelLight(ambient), picture.sunlight, out.sun) / middle;
    if (hasSun) {
        const Sky day = clearSky(out.sun, turbidity);
        level *= dimness(facingLight(levelLight(ambientOf(day, glm::dvec3(0.0))), day.sunlight, out.sun));
    }
    for (std::size_t i = 0; i < ambient.size(); ++i)
        out.ambient[i] = ambient[i] * float(pi / level);
    out.sunlight = glm::vec3(picture.sunlight / level);
    out.around = light.picture;
    out.aroundTurn = float(light.turnDeg / 360.0);
    out.aroundScale = float(pi / level);
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
    program.set("uSunSpread",
                isNatural() ? 0.0093f : 0.035f); // as wide as it is seen; elsewhere as of a hazy day
    program.set("uStanding", standing());
    program.set("uAround", isNatural() ? 1.0f : 0.0f);
    program.set("uGain", gain);
    program.set("uStudio", studio);
    program.set("uSky", isNatural());
    program.set("uPictureTurn", aroundTurn);
    program.set("uPictureScale", aroundScale);
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
    out.gain = glm::vec3(std::exp2(light.exposure) * whiteBalance(light.whiteKelvin));
    if (light.backdrop == Backdrop::Picture && light.picture) {
        takePicture(out, light);
        return out;
    }
    if (light.backdrop == Backdrop::Sky || light.backdrop == Backdrop::Picture) {
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
