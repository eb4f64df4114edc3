/// \file
/// Years of weather that leaves follow: fixed means of each day, and how long days are.
#pragma once

#include "core/params/season_params.h"
#include <array>

namespace ramure {

inline constexpr int daysOfYear = 365;

struct Climate
{
    double latitude = 0.0;                 ///< degrees north
    std::array<double, daysOfYear> mean{}; ///< °C, of every day from the first of January on
};

/// Returns the climate, made once: a smooth year through the long-term means of twelve months, rounded to
/// half a degree. Oceanic is as in Rennes, continental as in Cracow, boreal as in Jyväskylä.
const Climate& climateOf(SeasonClimate climate);

/// Returns the hours from sunrise to sunset. \param day 1..365
double dayLength(double latitude, int day);

} // namespace ramure
