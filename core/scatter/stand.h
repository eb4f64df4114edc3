/// \file
/// A stand: trees of one age and species that grow up beside each other, compete for light and die of shade.
///
/// Each year the ground is shared out by the canopy: a place belongs to the tree whose crown stands highest
/// over it (perfect plasticity; Strigul, Pristinski, Purves, Dushoff, Pacala, "Scaling from trees to
/// forests", Ecological Monographs 2008). How much of the ground a tree holds, compared with what one of its
/// diameter needs, decides how fast it grows and whether it lives. What a diameter needs follows the species'
/// own line of self-thinning (Reineke 1933; exponents of Pretzsch and Biber 2005).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace ramure {

/// How trees of a species grow in a stand of the first site class. Lengths in m, times in years.
struct StandSpecies
{
    const char* name = "";                                       ///< of the preset
    double topHeight = 0.0, heightRate = 0.0, heightShape = 0.0; ///< H = top (1 - exp(-rate t)) ^ shape
    double diameter = 0.0, diameterRate = 0.0,
           diameterShape = 0.0; ///< likewise, of a tree that lacks nothing
    double thinning = 0.0;      ///< exponent: how the ground that a tree needs grows with its diameter
    double ground = 0.0;        ///< m² that a tree of .25 m needs
    double endurance = 0.0;     ///< share of that below which a tree dies
};

std::span<const StandSpecies> standSpecies();
/// Null where there is none of this name.
const StandSpecies* findStandSpecies(std::string_view name);

struct StandTree
{
    glm::dvec2 foot{0.0};                ///< m, along X and Z
    double height = 0.0, diameter = 0.0; ///< m; the diameter 1.3 m above the ground
    double crownRadius = 0.0, crownBase = 0.0;
    glm::dvec2 crownOffset{0.0}; ///< m, from the foot to the middle of the ground that it holds
    std::uint32_t number = 0;    ///< of its seedling
};

struct Seedling
{
    glm::dvec2 foot{0.0};                  ///< m
    const StandSpecies* species = nullptr; ///< outlives the call
};

inline constexpr std::size_t mostSeedlings = 50'000;

/// \param years 1 to 400
/// Returns the trees that live then, in the order of the seedlings, whose numbers they keep. The same
/// arguments give the same bytes. Errors: Invalid (no seedlings, years out of range), Limit (too many, or
/// farther than 1 km from the origin), Cancelled.
Expected<std::vector<StandTree>> grownStand(std::span<const Seedling> seedlings, int years,
                                            std::uint64_t seed, const Progress& progress = {});
/// m: how high the tallest trees of a species are at an age.
double topHeightAt(const StandSpecies& species, double years);

} // namespace ramure
