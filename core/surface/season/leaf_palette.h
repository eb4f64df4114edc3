/// \file
/// The colours of one plant's leaves by their age, from pigments, as photographs have them.
#pragma once

#include "core/params/season_params.h"
#include "core/surface/season/leaf_pigments.h"
#include "core/surface/season/phenology.h"
#include <array>
#include <memory>

namespace ramure {

/// Of a leaf: 0 it leaves the bud, 1 it is unfolded, 2 it is dark and grown up, 3 it has turned, 4 it is
/// withered.
inline constexpr float leafUnfolded = 1.0F, leafGrown = 2.0F, leafTurned = 3.0F, leafWithered = 4.0F;

class LeafPalette
{
public:
    /// \param purple anthocyanin hides the green all summer \param redness SeasonParams::redness
    LeafPalette(const PlantYear& plant, bool purple, double redness = 1.0);

    /// \param light 0..1: leaves in the light turn redder
    [[nodiscard]] LeafColours at(float age, float light) const;

private:
    static constexpr int steps = 6, ages = 4 * steps + 1, lights = 3;

    std::array<std::array<LeafColours, lights>, ages> m_colours;
};

/// Returns the palette of a plant, from those made last where it is among them. From any thread. \pre not
/// Faithful.
std::shared_ptr<const LeafPalette> paletteOf(LeafShape shape, const SeasonParams& season);

} // namespace ramure
