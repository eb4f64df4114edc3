/// \file
/// Time as keys have it: whole numbers, so that equal times are equal and frame 1,000,000 is exact.
#pragma once

#include <cmath>
#include <cstdint>

namespace ramure {

/// A second has as many as there are "flicks": 24, 25, 30, 48, 50, 60, 90, 100, 120 frames a second, their
/// thousandths and the sample rates of sound all fall on whole ticks. Negative times are times before 0 s.
using Ticks = std::int64_t;
inline constexpr Ticks ticksPerSecond = 705'600'000;
/// No key lies further from 0 s than this (about 11 days): below, every tick is exact in a double.
inline constexpr Ticks mostTicks = 1'000'000 * ticksPerSecond;

inline double secondsOf(Ticks ticks)
{
    return double(ticks) / double(ticksPerSecond);
}

/// The nearest tick. \pre |seconds| <= 1e6.
inline Ticks ticksOf(double seconds)
{
    return std::llround(seconds * double(ticksPerSecond));
}

/// A time of a frame, computed in seconds, may miss the tick it means by the rounding of the last digit: a
/// CONSTANT key would then show one frame late. So close to a tick, the tick is meant.
inline double exactTicks(double seconds)
{
    const double ticks = seconds * double(ticksPerSecond);
    const double whole = std::nearbyint(ticks);
    return std::abs(ticks - whole) <= 1e-3 + 4e-16 * std::abs(ticks) ? whole : ticks;
}

} // namespace ramure
