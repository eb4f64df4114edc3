/// \file
/// Published sizes of grown trees, species by species, as foresters measure them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace ramure {

/// All in m.
struct TreeMeasures
{
    double height = 0.0;
    double stemDiameter = 0.0; ///< 1.3 m above the ground; 0 of a tree that is not so high
    double crownWidth = 0.0;   ///< mean over all directions
};

struct PublishedMeasures
{
    std::string_view latin; ///< see Preset
    TreeMeasures mean;      ///< mean of the quarter with the thickest stems
    int measured = 0;       ///< trees in all
    const char* source = "";
};

std::span<const PublishedMeasures> publishedMeasures();
/// nullptr of a species that is not among them.
const PublishedMeasures* publishedMeasures(std::string_view latin);

} // namespace ramure
