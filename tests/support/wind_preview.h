/// \file
/// Where a vertex stands in the wind, by the formula that the engine of a profile has published, with the
/// numbers as they are before a file rounds them. Strength 1 is a strong wind. The tree stands in the origin.
///
/// - Plain, ours: p + s (d (lean + sway sin(2 pi (0.5 t + phase))) + n flutter sin(2 pi (2 t + phase))).
/// - Crysis: GPU Gems 3, chapter 16, listings 1 and 2, detail before main bending; speed and frequency 1, no
///   phase of the object; amplitudes of WindSettings times the strength, and a wind of that length.
/// - Unity: AnimateVertex of TerrainEngine.cginc, for _Wind = (s d, s); no phase of the object.
/// - PivotPainter: PivotPainter2FoliageShader with PivotMotion and, for the texture of gusts, their formula.
/// It
///   adds up what each piece of a chain of four does by itself.
#pragma once

#include "core/game_wind/wind_profile.h"

namespace ramure {

struct WindNow
{
    glm::dvec3 direction{1.0, 0.0, 0.0}; ///< unit, level, in the tree's space
    double strength = 1.0;               ///< 0 or more
    double seconds = 0.0;
};

/// In place of the texture: it comes again in both directions. 0 to 1.
double gustAt(double u, double v);

struct WindPlace
{
    glm::dvec3 position{0.0}, normal{0.0, 1.0, 0.0}; ///< at rest
};
/// \param elements of PivotPainter. \return m, in the tree's space. \pre the profile is not None
glm::dvec3 windPreview(WindProfile profile, const WindPlace& place, const WindVertex& vertex,
                       const WindSettings& settings, const WindElements& elements, const WindNow& now,
                       const PivotMotion& motion = {});

} // namespace ramure
