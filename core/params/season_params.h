/// \file
/// The day of the year that a tree is shown on, and what its year depends on.
#pragma once

#include <cstdint>

namespace ramure {

/// Three years of daily temperatures, in core/surface/season/climate.cpp.
enum class SeasonClimate : std::uint8_t { Oceanic, Continental, Boreal };

struct SeasonParams
{
    double day = 0.0; ///< 1: the first of January .. 365; below 1: no day, LeafParams::season counts
    SeasonClimate climate = SeasonClimate::Oceanic;
    bool purple = false;  ///< leaves are dark red all summer, as those of a copper beech
    double redness = 1.0; ///< anthocyanin of leaves that turn, against that of their plant; 0: yellow ones
    bool operator==(const SeasonParams&) const = default;
};

/// Does the tree stand on a day of the year?
inline bool hasDay(const SeasonParams& season)
{
    return season.day >= 1.0;
}

} // namespace ramure
