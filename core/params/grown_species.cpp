#include "core/math/angle.h"
#include "core/params/species.h"

#include "core/math/angle.h"
#include <algorithm>
#include <array>

namespace ramure {
namespace {

using P = Phyllotaxis;

// Heights, spreads and years are those of trees that stand free in a park of the temperate zone; how the
// shoots stand is in every flora. Angles in degrees.
// clang-format off
const std::array grown{
    GrownSpecies{"EnglishOak", "Quercus robur", RAMURE_NOOP("Limbs as thick as trunks, crooked to their tips"), false, {15, 60, 140},
        {.age = 60, .height = 20, .crownWidth = 19, .crownBase = 0.2, .maturity = 90, .density = 0.8, .leaderUntil = 22, .axil = 57, .branching = 0.75,
         .shedding = 0.6, .upright = 0.05, .wander = 0.4, .reiteration = 0.01, .pipeExponent = 2.0, .tipRadius = 0.003, .girth = 0.4}},
    GrownSpecies{"EuropeanBeech", "Fagus sylvatica", RAMURE_NOOP("Fine rising limbs, twigs in flat sprays"), false, {15, 60, 120},
        {.age = 60, .height = 25, .crownWidth = 19, .crownBase = 0.06, .crownTop = 0.6, .maturity = 90, .density = 0.75, .leaderUntil = 28, .apicalControl = 0.6,
         .phyllotaxis = P::Alternate, .axil = 49, .branching = 0.75, .autonomy = 0.5, .shadeTolerance = 0.75, .shedding = 0.3, .light = 0.2, .plagiotropy = 0.12,
         .wander = 0.3, .pipeExponent = 2.1, .tipRadius = 0.0028}},
    GrownSpecies{"SilverBirch", "Betula pendula", RAMURE_NOOP("A slender stem, its finest twigs hanging"), false, {8, 35, 70},
        {.age = 35, .height = 20, .crownWidth = 10, .crownBase = 0.18, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 50, .leaderUntil = 60, .axil = 40,
         .branching = 0.6, .shadeTolerance = 0.25, .upright = 0.04, .weeping = 0.3, .wander = 0.2, .tipRadius = 0.0025}},
    GrownSpecies{"SmallLeavedLinden", "Tilia cordata", RAMURE_NOOP("A dense tall dome on bowed limbs"), false, {12, 50, 120},
        {.age = 50, .height = 22, .crownWidth = 14, .crownBase = 0.12, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 80, .leaderUntil = 45, .apicalControl = 0.55,
         .phyllotaxis = P::Alternate, .axil = 55, .branching = 0.8, .sympodial = 0.15, .shadeTolerance = 0.75, .shedding = 0.4, .upright = 0.08, .wander = 0.25,
         .droop = 0.35, .tipRadius = 0.0028}},
    GrownSpecies{"WeepingWillow", "Salix babylonica", RAMURE_NOOP("A short trunk under curtains of hanging shoots"), false, {6, 25, 50},
        {.age = 25, .height = 13, .crownWidth = 14, .crownBase = 0.02, .maturity = 35, .leaderUntil = 8, .axil = 46, .branching = 0.5, .orders = 7, .shedding = 0.35,
         .upright = 0.15, .weeping = 1.1, .droop = 0.06, .pipeExponent = 2.1, .tipRadius = 0.0028}},
    GrownSpecies{"OrchardApple", "Malus domestica", RAMURE_NOOP("A low spreading head of spurs and crooked limbs"), false, {5, 25, 60},
        {.age = 25, .height = 6, .crownWidth = 7, .crownBase = 0.2, .maturity = 25, .leaderUntil = 5, .internode = 0.08, .axil = 55, .acrotony = 0.45, .branching = 0.8,
         .shortShoots = 0.8, .sympodial = 0.1, .shadeTolerance = 0.45, .upright = 0.08, .wander = 0.45, .droop = 0.4, .tipRadius = 0.0028}},
    GrownSpecies{"OliveTree", "Olea europaea", RAMURE_NOOP("A stout twisted trunk under a loose grey crown"), false, {10, 80, 300},
        {.age = 80, .height = 7, .crownWidth = 7, .crownBase = 0.2, .maturity = 60, .leaderUntil = 6, .internode = 0.08, .phyllotaxis = P::Opposite, .axil = 45,
         .branching = 0.7, .shadeTolerance = 0.35, .shedding = 0.5, .upright = 0.1, .wander = 0.6, .droop = 0.2, .reiteration = 0.02, .pipeExponent = 2.0,
         .tipRadius = 0.0028, .girth = 0.8}},
    GrownSpecies{"LombardyPoplar", "Populus nigra 'Italica'", RAMURE_NOOP("A column of limbs that rise along the trunk"), false, {6, 25, 50},
        {.age = 25, .height = 25, .crownWidth = 4, .crownBase = 0.04, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 35, .leaderUntil = 1000, .apicalControl = 0.6,
         .axil = 28, .branching = 0.6, .shadeTolerance = 0.4, .shedding = 0.4, .light = 0.1, .upright = 0.5, .wander = 0.15, .droop = 0.05, .tipRadius = 0.003}},
    GrownSpecies{"ScotsPine", "Pinus sylvestris", RAMURE_NOOP("A high crown in clouds on a bare red stem"), true, {12, 60, 140},
        {.age = 60, .height = 22, .crownWidth = 13, .crownBase = 0.5, .crownWidest = 0.6, .crownTop = 0.4, .maturity = 65, .leaderUntil = 45, .sideLength = 0.75, .axil = 74,
         .branching = 0.6, .whorl = 4, .autonomy = 0.55, .shadeTolerance = 0.35, .shedding = 0.9, .light = 0.25, .upright = 0.1, .plagiotropy = 0.25, .wander = 0.3,
         .droop = 0.1, .tipRadius = 0.004}},
    GrownSpecies{"NorwaySpruce", "Picea abies", RAMURE_NOOP("A spire of whorls, each limb hung with twigs"), true, {12, 50, 100},
        {.age = 50, .height = 28, .crownWidth = 10, .crownBase = 0.05, .crownWidest = 0.05, .crownTop = 1, .maturity = 80, .density = 0.8, .leaderUntil = 1000,
         .apicalControl = 0.9, .sideLength = 0.6, .axil = 83, .whorl = 5, .shadeTolerance = 0.9, .shedding = 0.3, .upright = 0.05, .plagiotropy = 0.5, .wander = 0.1}},
    GrownSpecies{"LebanonCedar", "Cedrus libani", RAMURE_NOOP("Level limbs in storeys, a flat top when old"), true, {15, 70, 160},
        {.age = 70, .height = 22, .crownWidth = 20, .crownBase = 0.1, .crownWidest = 0.3, .crownTop = 0.35, .maturity = 80, .leaderUntil = 40, .apicalControl = 0.7,
         .sideLength = 0.8, .axil = 80, .branching = 0.8, .autonomy = 0.5, .shortShoots = 0.8, .shadeTolerance = 0.6, .shedding = 0.4, .light = 0.2, .upright = 0.02,
         .plagiotropy = 0.8, .wander = 0.2, .droop = 0.05, .pipeExponent = 2.1, .tipRadius = 0.0035}},
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
    // Leaves are as large as on the other tree of the species, and stand on the shoots of the last years.
    params.leaf.size *= trunkRadius(dress) / trunkRadius(params);
    params.fruit.size *= trunkRadius(dress) / trunkRadius(params);
    constexpr double leafyTips = 2.0;
    params.foliage.leavesCutoff = leafyTips * params.growth.tipRadius / trunkRadius(params);
    return params;
}

} // namespace ramure
