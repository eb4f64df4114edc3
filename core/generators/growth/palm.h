/// \file
/// Palms: one stem that never branches and a crown of leaves at its end (the model of Corner, as in Halle,
/// Oldeman, Tomlinson: "Tropical trees and forests", 1978). There is nothing for shoots to compete about, so
/// that a palm of any age follows at once from its parameters. Its one bud turns to the open sky where solids
/// hide a part of it, and stops below a roof.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/math/random.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Address of the stem, on which the only bud stands: a cut there is the palm's death.
inline constexpr std::uint64_t palmStemAddress = mixBits(0x50616C6Dull);

/// The palm at \p age years: a stem with the scars of its leaves as its pieces, fronds with their leaflets
/// and bunches of fruit as organs. What stands at one age stands in the same place at all later ones; fronds
/// open, bow and fall as they get older. \pre params.habit is GrowthHabit::Palm, and the parameters are
/// valid. \param seed decides about the lean of the stem and the chance in each frond
/// \param cuts of the stem or of fronds and bunches; those by a shape do nothing. The stem of a palm without
/// its bud stands as it was at that age, and all fronds are gone
Skeleton palmAtAge(const GrowthParams& params, std::uint64_t seed, double age, const GrowthCuts& cuts = {});

} // namespace ramure
