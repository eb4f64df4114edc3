/// \file
/// The leaves and fruit of a tree on a day of the year: swelling, unfolding, green, turned or fallen.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/foliage.h"
#include <vector>

namespace ramure {

/// Returns the foliage as it is on the day. Every leaf has its own time, which depends on how much light it
/// gets (high and outside in the crown or not), on its neighbourhood and on its address: what a day shows of
/// a leaf never depends on the days before, and no leaf moves. Leaves that have fallen, or have not come, are
/// missing and count as shed (toCome: those that have not come); those that unfold are smaller. Colours come
/// from pigments and are whole: tints are colours, tones are 1, and the form says so. Evergreens bear young
/// tips in spring and drop their oldest needles. Trees that flower do so before, with or after their leaves;
/// fruit grow, ripen and fall.
///
/// Faithful leaves and fruit stay as they are, and so do palms. Where the climate has no winter, it is always
/// summer.
/// \param placed as it was placed, in no other season. \param alpha the grammar's length, m.
/// \pre hasDay(season)
Foliage foliageOnDay(const Foliage& placed, const Skeleton& skeleton, const SeasonParams& season,
                     double alpha);

/// Places the leaves and fruit of a tree: in its season, or as foliageOnDay wants them where it has a day.
/// Errors: those of placeFoliage.
Expected<Foliage> placedFoliage(const Skeleton& skeleton, const NodeParams& params,
                                const Progress& progress = {});
/// The same, on the day of \p params where it has one: as trees show it that have no bark to stand on.
Expected<Foliage> foliageOf(const Skeleton& skeleton, const NodeParams& params,
                            const Progress& progress = {});

/// Returns when a leaf has its turn among those of its tree: 0 is the first to turn in autumn, 1 the last.
/// One number for each leaf, in their order.
std::vector<float> leafPhases(const Foliage& foliage, const Skeleton& skeleton);

} // namespace ramure
