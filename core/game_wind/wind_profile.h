/// \file
/// The numbers of each vertex by which shaders of an engine move a tree, in the convention of that engine.
///
/// - Plain: _WIND, four floats: the phase (0 to 1) and m of lean, sway and flutter of a WindVertex.
/// - Crysis: colours as in T. Sousa, "Vegetation Procedural Animation and Shading in Crysis", GPU Gems 3
///   (2007), chapter 16: red how freely the edge of a leaf moves, green the phase, blue how stiff leaf and
///   branch are, alpha the light that reaches it (1: all). The main bending needs the height alone.
/// - Unity: what AnimateVertex of TerrainEngine.cginc takes from a tree of Unity's Tree Creator: red the
/// phase,
///   green the flutter of edges; of the second texture coordinates u the primary factor, v the secondary one.
///   Unity's readers of glTF turn v round, so 1 less the factor is written.
/// - PivotPainter: second texture coordinates that name a texel of the textures of
/// core/game_wind/wind_elements.h.
///
/// Colours are normalised numbers of 16 bits: with 8, edges would stand up to 2.3 mm elsewhere (half a step
/// of blue, twice the wave, a branch that sways 0.3 m). Phases are the same in 8 bits.
#pragma once

#include "core/game_wind/wind_elements.h"
#include <glm/gtc/type_precision.hpp>
#include <string>

namespace ramure {

enum class WindProfile : std::uint8_t { None, Plain, Crysis, Unity, PivotPainter };

struct WindProfileFacts
{
    WindProfile profile;
    const char* name;   ///< "pivot-painter": of the command line and in files
    const char* choice; ///< in the export dialog, as text to translate
};
/// All but None.
std::span<const WindProfileFacts> windProfiles();
/// \pre it is not None
const WindProfileFacts& factsOf(WindProfile profile);

/// Settings of the whole tree that engines hold as material parameters. Formulas:
/// resources/shaders/wind.glsl.
struct WindSettings
{
    double bendScale = 0.0; ///< Crysis, 1/m: its top leans trunkSway of its height
    double branchAmp = 0.0; ///< Crysis, m: the farthest that a branch sways
    double detailAmp = 0.0; ///< Crysis, m: the farthest that an edge flutters
    bool operator==(const WindSettings&) const = default;
};
/// \param meshes all of the tree
WindSettings windSettings(const WindTree& tree, std::span<const std::span<const WindVertex>> meshes);

/// The wind data of one mesh. Each column has one entry per vertex, or is empty.
struct WindColumns
{
    std::vector<glm::u16vec4> colours; ///< 65535 is 1; linear
    std::vector<glm::vec2> uv;         ///< the second texture coordinates, as files have them
    std::vector<glm::vec4> numbers;    ///< _WIND
    WindProfile profile = WindProfile::None;
    WindSettings settings{};
    bool operator==(const WindColumns&) const = default;
};
/// \param textures of PivotPainter
WindColumns windColumns(WindProfile profile, std::span<const WindVertex> vertices,
                        const WindSettings& settings, const PivotTextures& textures);

} // namespace ramure
