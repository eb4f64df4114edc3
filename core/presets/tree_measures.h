/// \file
/// Published sizes of grown trees, as foresters measure them, and of their leaves, as floras give them.
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

struct PublishedRange
{
    double from = 0.0, to = 0.0;
};

struct PublishedLeaves
{
    std::string_view latin;
    PublishedRange length; ///< m, of a leaf without its petiole; of needles, of the spray that carries them
    PublishedRange areaIndex; ///< leaf area over the ground below the crown
};
/// Where the ranges of all PublishedLeaves come from.
extern const char* const publishedLeavesSource;

std::span<const PublishedLeaves> publishedLeaves();
/// nullptr of a species that is not among them.
const PublishedLeaves* publishedLeaves(std::string_view latin);

std::span<const PublishedMeasures> publishedMeasures();
/// nullptr of a species that is not among them.
const PublishedMeasures* publishedMeasures(std::string_view latin);

} // namespace ramure
