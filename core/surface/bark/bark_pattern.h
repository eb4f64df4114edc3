/// \file
/// The families of bark: what lies at a place of a tile. x goes around the branch, y along it.
#pragma once

#include "core/params/bark_params.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ramure {

/// One place of a bark.
struct BarkSample
{
    float height = 0.5f; ///< 0 the deepest crack .. 1 the highest ridge
    float tint = 0.0f;   ///< -1 darker .. 1 lighter than bark of this height: of plates and scales
    float mark = 0.0f;   ///< 0 .. 1: lenticels, lichen, young bark, which have a colour of their own
};

/// The smooth skin of thin wood, and how it gives way.
struct BarkYouth
{
    glm::vec3 colour{0.5f};           ///< sRGB, 0 .. 1
    float from = 0.01f, until = 0.1f; ///< m: radii at which bark begins to show, and is all there
};

/// The bark of limbs, before plates are thick and furrows deep: the colour that its picture has on average
/// there.
struct BarkOfLimbs
{
    glm::vec3 colour{-1.0f};         ///< sRGB, 0 .. 1; below 0: that of old bark
    float from = 1.0f, until = 2.0f; ///< m: radii at which old bark begins to show, and is all there
};

struct BarkLook
{
    BarkSample (*at)(glm::vec2 place, std::uint32_t seed) = nullptr; ///< place in tiles; periodic
    glm::vec3 crack, ridge, mark;                                    ///< sRGB, 0 .. 1
    float relief = 0.0f;    ///< from the deepest crack to the highest ridge, in tiles
    float variety = 0.0f;   ///< how far tint reaches
    float roughness = 0.9f; ///< of ridges; cracks are rough
    BarkYouth youth{};      ///< of twigs, before that
    BarkOfLimbs limbs{};    ///< between the two
};

/// Of every family but Plain, whose function is null.
const BarkLook& barkLook(BarkFamily family);

} // namespace ramure
