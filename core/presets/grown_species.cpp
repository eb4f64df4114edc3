#include "core/math/angle.h"
#include "core/presets/species.h"

#include "core/math/angle.h"
#include <algorithm>
#include <array>

namespace ramure {
namespace {

using P = Phyllotaxis;

// Heights, spreads and years are those of trees that stand free in a park of the temperate zone; how the
// shoots stand is in every flora. Angles in degrees. In the end, the lengths of a leaf and from leaf to leaf
// over what they are shares of (leaf_table.cpp); of needles, those of a shoot.
// clang-format off
const std::array grown{
    GrownSpecies{"EnglishOak", "Quercus robur", RAMURE_NOOP("Limbs as thick as trunks, crooked to their tips"), false, {15, 60, 140},
        {.age = 60, .height = 18, .crownWidth = 19, .crownBase = 0.16, .crownWidest = 0.35, .crownTop = 0.45, .maturity = 42, .density = 0.62,
         .leaderUntil = 13, .apicalControl = 0.62, .axil = 66, .branching = 0.7, .autonomy = 0.45, .shedding = 0.6, .light = 0.25, .upright = 0.03,
         .wander = 0.75, .droop = 0.3, .reiteration = 0.01, .pipeExponent = 2.0, .tipRadius = 0.0034, .girth = 0.4},
        0.11 / 0.58, 0.025 / 0.18},
    GrownSpecies{"EuropeanBeech", "Fagus sylvatica", RAMURE_NOOP("Fine rising limbs, twigs in flat sprays"), false, {15, 60, 120},
        {.age = 60, .height = 23, .crownWidth = 18, .crownBase = 0.06, .crownTop = 0.55, .maturity = 58, .density = 0.66, .leaderUntil = 25,
         .apicalControl = 0.62, .sideLength = 0.85, .phyllotaxis = P::Alternate, .axil = 50, .branching = 0.62, .autonomy = 0.5,
         .shadeTolerance = 0.75, .shedding = 0.3, .light = 0.2, .upright = 0.06, .plagiotropy = 0.12, .wander = 0.3, .pipeExponent = 2.05,
         .tipRadius = 0.0031},
        0.08 / 0.45, 0.022 / 0.17},
    GrownSpecies{"SilverBirch", "Betula pendula", RAMURE_NOOP("A slender stem, its finest twigs hanging"), false, {10, 35, 70},
        {.age = 35, .height = 20, .crownWidth = 10, .crownBase = 0.18, .crownWidest = 0.3, .crownTop = 0.65, .maturity = 45, .density = 1.4,
         .leaderUntil = 70, .apicalControl = 0.5, .axil = 42, .branching = 0.75, .endBuds = 1, .autonomy = 0.5, .shadeTolerance = 0.25, .light = 0.3,
         .upright = 0.14, .weeping = 0.9, .wander = 0.2, .tipRadius = 0.0029, .girth = 0.5},
        0.05 / 0.42, 0.015 / 0.15},
    GrownSpecies{"SmallLeavedLinden", "Tilia cordata", RAMURE_NOOP("A dense tall dome on bowed limbs"), false, {12, 50, 120},
        {.age = 50, .height = 20, .crownWidth = 13, .crownBase = 0.1, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 48, .density = 1.15,
         .leaderUntil = 20, .apicalControl = 0.5, .phyllotaxis = P::Alternate, .axil = 58, .branching = 0.8, .autonomy = 0.45,
         .shadeTolerance = 0.75, .shedding = 0.4, .light = 0.2, .upright = 0.03, .weeping = 0.08, .wander = 0.35, .droop = 1.0,
         .pipeExponent = 2.1, .tipRadius = 0.0028},
        0.07 / 0.52, 0.022 / 0.19},
    GrownSpecies{"WeepingWillow", "Salix babylonica", RAMURE_NOOP("A short trunk under curtains of hanging shoots"), false, {6, 25, 50},
        {.age = 25, .height = 12, .crownWidth = 14, .crownBase = 0.12, .crownTop = 0.5, .maturity = 14, .leaderUntil = 1, .apicalControl = 0.45,
         .axil = 50, .branching = 0.6, .endBuds = 1, .orders = 7, .shedding = 0.35, .upright = 0.38, .weeping = 1.3, .droop = 0.06,
         .pipeExponent = 1.9, .tipRadius = 0.0032, .girth = 0.5},
        0.12 / 0.60, 0.02 / 0.13},
    GrownSpecies{"OrchardApple", "Malus domestica", RAMURE_NOOP("A low spreading head of spurs and crooked limbs"), false, {7, 25, 60},
        {.age = 25, .height = 5.5, .crownWidth = 8, .crownBase = 0.25, .crownTop = 0.4, .maturity = 11, .density = 0.6, .leaderUntil = 3,
         .internode = 0.12, .axil = 62, .acrotony = 0.45, .branching = 1.1, .endBuds = 1, .autonomy = 0.45, .shortShoots = 0.7,
         .shadeTolerance = 0.45, .light = 0.25, .upright = 0.0, .wander = 0.6, .droop = 0.4, .pipeExponent = 2.0, .tipRadius = 0.0018},
        0.08 / 0.48, 0.01 / 0.18},
    GrownSpecies{"OliveTree", "Olea europaea", RAMURE_NOOP("A stout twisted trunk under a loose grey crown"), false, {10, 80, 300},
        {.age = 80, .height = 7, .crownWidth = 7, .crownBase = 0.24, .crownTop = 0.55, .maturity = 60, .density = 0.75, .leaderUntil = 8,
         .internode = 0.11, .phyllotaxis = P::Opposite, .axil = 60, .branching = 0.85, .shadeTolerance = 0.3, .shedding = 0.4, .light = 0.25,
         .upright = 0.03, .wander = 0.65, .droop = 0.35, .reiteration = 0.004, .pipeExponent = 1.9, .tipRadius = 0.0026, .girth = 0.8},
        0.06 / 0.36, 0.014 / 0.13},
    GrownSpecies{"LombardyPoplar", "Populus nigra 'Italica'", RAMURE_NOOP("A column of limbs that rise along the trunk"), false, {6, 25, 50},
        {.age = 25, .height = 25, .crownWidth = 5.5, .crownBase = 0.03, .crownWidest = 0.35, .crownTop = 0.7, .maturity = 32, .density = 3.3,
         .leaderUntil = 1000, .apicalControl = 0.6, .axil = 32, .branching = 0.9, .autonomy = 0.6, .shadeTolerance = 0.8, .shedding = 0.2,
         .light = 0.1, .upright = 0.5, .wander = 0.2, .droop = 0.05, .pipeExponent = 2.05, .tipRadius = 0.0022, .girth = 0.5},
        0.07 / 0.40, 0.022 / 0.16},
    GrownSpecies{"ScotsPine", "Pinus sylvestris", RAMURE_NOOP("A high crown in clouds on a bare red stem"), true, {12, 60, 140},
        {.age = 60, .height = 20, .crownWidth = 14, .crownBase = 0.45, .crownWidest = 0.5, .crownTop = 0.6, .maturity = 60, .density = 1.4,
         .leaderUntil = 40, .apicalControl = 0.7, .sideLength = 0.8, .axil = 72, .acrotony = 1.0, .branching = 0.6, .whorl = 5, .autonomy = 0.55,
         .shadeTolerance = 0.35, .shedding = 0.85, .light = 0.08, .upright = 0.03, .plagiotropy = 0.5, .wander = 0.35, .droop = 0.05,
         .reiteration = 0.01, .tipRadius = 0.0032},
        0.18 / 0.42, 0.045 / 0.11},
    GrownSpecies{"NorwaySpruce", "Picea abies", RAMURE_NOOP("A spire of whorls, each limb hung with twigs"), true, {12, 50, 100},
        {.age = 50, .height = 26, .crownWidth = 10, .crownBase = 0.03, .crownWidest = 0.05, .crownTop = 0.85, .maturity = 65, .density = 1.4,
         .leaderUntil = 1000, .apicalControl = 0.9, .sideLength = 0.65, .axil = 78, .acrotony = 0.0, .branching = 0.9, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.0, .upright = 0.1, .weeping = 0.5, .wander = 0.15, .droop = 0.7,
         .tipRadius = 0.0034},
        0.19 / 0.22, 0.028 / 0.07},
    GrownSpecies{"LebanonCedar", "Cedrus libani", RAMURE_NOOP("Level limbs in storeys, a flat top when old"), true, {15, 70, 160},
        {.age = 70, .height = 20, .crownWidth = 20, .crownBase = 0.1, .crownWidest = 0.4, .crownTop = 0.3, .maturity = 60, .density = 0.6,
         .leaderUntil = 30, .apicalControl = 0.7, .sideLength = 0.85, .axil = 76, .acrotony = 0.9, .branching = 1.0, .autonomy = 0.6,
         .shortShoots = 0.3, .shadeTolerance = 0.5, .shedding = 0.5, .light = 0.1, .upright = 0.0, .plagiotropy = 0.9, .wander = 0.25,
         .droop = 0.05, .pipeExponent = 2.1, .tipRadius = 0.0036},
        0.25 / 0.22, 0.05 / 0.075},
};
// clang-format on

} // namespace

std::span<const GrownSpecies> grownSpecies()
{
    return grown;
}

NodeParams grownParams(const GrownSpecies& species, const NodeParams& dress)
{
    NodeParams params = dress;
    params.generator.kind = TreeGenerator::Growth;
    params.weberPenn = {};
    params.growth = species.growth;
    params.growth.axil *= oneDegree;
    // Leaves stand on the shoots of the last years; fruit is as large as on the other tree of the species.
    params.leaf.size = species.leaf / trunkRadius(params);
    params.leaf.internode = species.leafInternode / trunkRadius(params);
    params.fruit.size *= trunkRadius(dress) / trunkRadius(params);
    const double leafyTips = species.conifer ? 3.0 : 2.0; // needles stay for years
    params.foliage.leavesCutoff = leafyTips * params.growth.tipRadius / trunkRadius(params);
    return params;
}

} // namespace ramure
