/// \file
/// The colour of a leaf from its pigments, and the colour that shines through it: the plate model PROSPECT-D
/// (Féret, Gitelson, Noble, Jacquemoud, "PROSPECT-D: towards modeling leaf optical properties through a
/// complete lifecycle", 2017), seen in daylight (D65) by the standard observer of 1931.
#pragma once

#include <glm/vec3.hpp>

namespace ramure {

/// What a leaf holds, in µg/cm² of its area; brown pigments have no unit.
struct Pigments
{
    float chlorophyll = 0.0F; ///< 0..150
    float carotenoids = 0.0F; ///< 0..25
    float anthocyanin = 0.0F; ///< 0..50
    float brown = 0.0F;       ///< 0..4
    bool operator==(const Pigments&) const = default;
};

/// Returns the pigments on the way from \p from (0) to \p to (1).
Pigments mix(const Pigments& from, const Pigments& to, float share);

/// sRGB, 0..255.
struct LeafColours
{
    glm::vec3 reflected{0.0F}, transmitted{0.0F};
};

/// Returns the colours of a leaf of 1.5 plates, with as much water (0.01 g/cm²) and dry matter (0.009 g/cm²)
/// as a broad leaf has: both hardly matter to the eye. Amounts below 0 and those that are no numbers count as
/// 0, and larger ones than those above as these.
LeafColours pigmentColours(const Pigments& pigments);

/// Returns the colours as a photograph of a crown has them, which is exposed for leaves: they are darker than
/// all around them, and the other colours of the program are those of photographs. What shines on the surface
/// of a leaf is left out for the most part, because renderers add it themselves.
LeafColours photographed(const LeafColours& colours);

/// What a leaf throws back at its surface, before any pigment: linear. Beneath it, what a leaf lets through
/// has nearly the colour that it shows: transmitted = passedOn * max(reflected - surfaceSheen, 0). Against
/// the model ΔE00 stays below 5 for all colours of a year, so that shaders need one colour a leaf.
inline constexpr glm::vec3 surfaceSheen{0.025F, 0.035F, 0.042F};
inline constexpr float passedOn = 1.05F;

} // namespace ramure
