#include "core/game_wind/wind_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

constexpr std::array profiles{
    WindProfileFacts{WindProfile::Plain, "plain", RAMURE_NOOP("Any shader (_WIND)")},
    WindProfileFacts{WindProfile::Crysis, "crysis", RAMURE_NOOP("CryEngine (vertex colours)")},
    WindProfileFacts{WindProfile::Unity, "unity", RAMURE_NOOP("Unity (Tree Creator)")},
    WindProfileFacts{WindProfile::PivotPainter, "pivot-painter", RAMURE_NOOP("Unreal (Pivot Painter 2)")}};

/// Of AnimateVertex: how far an edge of factor 1 goes.
constexpr float unityDetailAmp = 0.1F;

std::uint16_t bitsOf(double share)
{
    return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(share, 0.0, 1.0)));
}

double shareOf(double part, double whole)
{
    return whole > 0.0 ? part / whole : 0.0;
}

} // namespace

std::span<const WindProfileFacts> windProfiles()
{
    return profiles;
}

const WindProfileFacts& factsOf(WindProfile profile)
{
    return *std::ranges::find(profiles, profile, &WindProfileFacts::profile);
}

WindSettings windSettings(const WindTree& tree, std::span<const std::span<const WindVertex>> meshes)
{
    WindSettings out;
    for (const auto& vertices : meshes)
        for (const WindVertex& vertex : vertices) {
            out.branchAmp = std::max(out.branchAmp, double(vertex.sway));
            out.detailAmp = std::max(out.detailAmp, double(vertex.flutter));
        }
    // Of (1 + h s)^4 - (1 + h s)^2 = lean of the top.
    if (tree.height > 0.0) {
        const double squared = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * trunkSway * tree.height));
        out.bendScale = (std::sqrt(squared) - 1.0) / tree.height;
    }
    return out;
}

WindColumns windColumns(WindProfile profile, std::span<const WindVertex> vertices,
                        const WindSettings& settings, const PivotTextures& textures)
{
    WindColumns out;
    out.profile = profile;
    out.settings = settings;
    for (const WindVertex& vertex : vertices)
        switch (profile) {
        case WindProfile::None:
            break;
        case WindProfile::Plain:
            out.numbers.emplace_back(vertex.phase, vertex.lean, vertex.sway, vertex.flutter);
            break;
        case WindProfile::Crysis:
            out.colours.emplace_back(bitsOf(shareOf(vertex.flutter, settings.detailAmp)),
                                     bitsOf(vertex.phase),
                                     bitsOf(1.0 - shareOf(vertex.sway, settings.branchAmp)), 65535);
            break;
        case WindProfile::Unity:
            out.colours.emplace_back(bitsOf(vertex.phase), bitsOf(vertex.flutter / unityDetailAmp), 0, 65535);
            out.uv.emplace_back(vertex.lean, 1.0F - vertex.sway);
            break;
        case WindProfile::PivotPainter:
            out.uv.push_back(textures.placeOf(vertex.element));
            break;
        }
    return out;
}

} // namespace ramure
