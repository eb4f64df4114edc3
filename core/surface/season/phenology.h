/// \file
/// When the leaves of a species come, turn and fall in a climate, and what they hold.
#pragma once

#include "core/params/leaf_params.h"
#include "core/surface/season/climate.h"
#include "core/surface/season/leaf_pigments.h"
#include <optional>

namespace ramure {

/// Menzel, "Phänologie von Waldbäumen unter sich ändernden Klimabedingungen", 1997: buds burst when the
/// warmth above a threshold since the first of February, in degree days, reaches a + b ln(chill days). Chill
/// days are those since the first of November that are not warmer than another threshold.
struct BudModel
{
    double chill, warmth; ///< the thresholds, °C
    double a, b;
};
enum class BudKind : std::uint8_t { Larch, Spruce, Pine, Birch, Oak, SessileOak, Beech };
BudModel budModel(BudKind kind);

/// Returns the day of the year on which buds burst; nothing where no winter chills them or no spring warms
/// them until the end of August.
std::optional<int> budburst(const BudModel& model, const Climate& climate);

/// Returns the day on which leaves are coloured (Delpierre et al., "Modelling interannual and spatial
/// variability of leaf senescence for three deciduous tree species in France", 2009): the sum of
/// (28.5 °C - temperature)² (day length / 14.5 h)² over all days after midsummer that are shorter and colder
/// than these has reached 8268. \param share of that sum. Nothing where the year ends before.
std::optional<int> colouring(const Climate& climate, double share = 1.0);

/// What is known of the year of one plant's leaves.
struct PlantYear
{
    LeafShape shape = LeafShape::Faithful;
    BudKind buds = BudKind::Oak;
    double later = 0.0;     ///< days by which its buds burst after those of the model
    double turns = 1.0;     ///< share of Delpierre's sum when half of the leaves have turned
    double fallWeeks = 4.0; ///< from a tenth of the leaves fallen to nine tenths
    float redYoung = 1.0F;  ///< anthocyanin of leaves that unfold
    Pigments summer{45, 10, 1, 0};
    Pigments autumn{3, 6, 0, 0.05F};
    float withers = 0.3F;     ///< brown pigments that are added before a leaf falls
    float byLight = 0.5F;     ///< share of the anthocyanin of autumn that only light makes
    float keeps = 0.0F;       ///< share of the leaves that stay on the twigs, brown, until spring
    double needleYears = 0.0; ///< evergreen: years that leaves stay; 0: for longer, nothing is seen of a year
    double flowers = 1000.0;  ///< days from budburst until flowers open; 1000: none are shown
    double ripe = 260.0;      ///< day of the year when fruit are ripe
};

/// \pre not Faithful.
const PlantYear& plantYear(LeafShape shape);

/// The dates of a species in a climate, in days of the year; fractions count.
struct YearDates
{
    double burst = 0.0, unfolded = 0.0;     ///< of the mean leaf; 300 degree days above 5 °C lie between
    double turned = 0.0;                    ///< half of the leaves have turned
    double firstFall = 0.0, lastFall = 0.0; ///< a tenth, nine tenths have fallen
};

/// Nothing where the climate has no winter or no spring: leaves stay as they are in summer.
std::optional<YearDates> datesOf(const PlantYear& plant, const Climate& climate);

} // namespace ramure
