#include "core/presets/species.h"

#include "core/math/angle.h"
#include "core/params/source_facts.h"
#include <algorithm>
#include <array>
#include <string_view>

namespace ramure {
namespace {

using P = Phyllotaxis;

// Heights, spreads and years are those of trees that stand free in a park of the temperate zone; how the
// shoots stand is in every flora. Angles in degrees. In the end, the leaves: see GrownLeaves.
// clang-format off
const std::array grownTable{
    GrownSpecies{"EnglishOak", "Quercus robur", RAMURE_NOOP("Limbs as thick as trunks, crooked to their tips"), false, {15, 60, 140},
        {.age = 60, .height = 18, .crownWidth = 19, .crownBase = 0.16, .crownWidest = 0.35, .crownTop = 0.45, .maturity = 42, .density = 0.62,
         .leaderUntil = 13, .apicalControl = 0.62, .axil = 66, .branching = 0.7, .autonomy = 0.45, .shedding = 0.6, .light = 0.25, .upright = 0.03,
         .wander = 0.75, .droop = 0.3, .reiteration = 0.01, .pipeExponent = 2.0, .tipRadius = 0.0034, .girth = 0.4},
        {0.11, 1.22, 5}},
    GrownSpecies{"EuropeanBeech", "Fagus sylvatica", RAMURE_NOOP("Fine rising limbs, twigs in flat sprays"), false, {15, 60, 120},
        {.age = 60, .height = 23, .crownWidth = 18, .crownBase = 0.06, .crownTop = 0.55, .maturity = 58, .density = 0.66, .leaderUntil = 25,
         .apicalControl = 0.62, .sideLength = 0.85, .phyllotaxis = P::Alternate, .axil = 50, .branching = 0.62, .autonomy = 0.5,
         .shadeTolerance = 0.75, .shedding = 0.3, .light = 0.2, .upright = 0.06, .plagiotropy = 0.12, .wander = 0.3, .pipeExponent = 2.05,
         .tipRadius = 0.0031},
        {0.08, 0.74, 5}},
    GrownSpecies{"SilverBirch", "Betula pendula", RAMURE_NOOP("A slender stem, its finest twigs hanging"), false, {10, 35, 70},
        {.age = 35, .height = 20, .crownWidth = 10, .crownBase = 0.18, .crownWidest = 0.3, .crownTop = 0.65, .maturity = 45, .density = 1.4,
         .leaderUntil = 70, .apicalControl = 0.5, .axil = 42, .branching = 0.75, .endBuds = 1, .autonomy = 0.5, .shadeTolerance = 0.25, .light = 0.3,
         .upright = 0.14, .weeping = 0.9, .wander = 0.2, .tipRadius = 0.0029, .girth = 0.5},
        {0.05, 1.27, 4}},
    GrownSpecies{"SmallLeavedLinden", "Tilia cordata", RAMURE_NOOP("A dense tall dome on bowed limbs"), false, {12, 50, 120},
        {.age = 50, .height = 20, .crownWidth = 13, .crownBase = 0.1, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 48, .density = 1.15,
         .leaderUntil = 20, .apicalControl = 0.5, .phyllotaxis = P::Alternate, .axil = 58, .branching = 0.8, .autonomy = 0.45,
         .shadeTolerance = 0.75, .shedding = 0.4, .light = 0.2, .upright = 0.03, .weeping = 0.08, .wander = 0.35, .droop = 1.0,
         .pipeExponent = 2.1, .tipRadius = 0.0028},
        {0.07, 1.77, 4}},
    GrownSpecies{"WeepingWillow", "Salix babylonica", RAMURE_NOOP("A short trunk under curtains of hanging shoots"), false, {6, 25, 50},
        {.age = 25, .height = 12, .crownWidth = 14, .crownBase = 0.12, .crownTop = 0.5, .maturity = 14, .leaderUntil = 1, .apicalControl = 0.45,
         .axil = 50, .branching = 0.6, .endBuds = 1, .orders = 7, .shedding = 0.35, .upright = 0.38, .weeping = 1.3, .droop = 0.06,
         .pipeExponent = 1.9, .tipRadius = 0.0032, .girth = 0.5},
        {0.12, 0.89, 3}},
    GrownSpecies{"OrchardApple", "Malus domestica", RAMURE_NOOP("A low spreading head of spurs and crooked limbs"), false, {7, 25, 60},
        {.age = 25, .height = 5.5, .crownWidth = 8, .crownBase = 0.25, .crownTop = 0.4, .maturity = 11, .density = 0.6, .leaderUntil = 3,
         .internode = 0.12, .axil = 62, .acrotony = 0.45, .branching = 1.1, .endBuds = 1, .autonomy = 0.45, .shortShoots = 0.7,
         .shadeTolerance = 0.45, .light = 0.25, .upright = 0.0, .wander = 0.6, .droop = 0.4, .pipeExponent = 2.0, .tipRadius = 0.0018},
        {0.08, 0.83, 4}},
    GrownSpecies{"OliveTree", "Olea europaea", RAMURE_NOOP("A stout twisted trunk under a loose grey crown"), false, {10, 80, 300},
        {.age = 80, .height = 7, .crownWidth = 7, .crownBase = 0.24, .crownTop = 0.55, .maturity = 60, .density = 0.75, .leaderUntil = 8,
         .internode = 0.11, .phyllotaxis = P::Opposite, .axil = 60, .branching = 0.85, .shadeTolerance = 0.3, .shedding = 0.4, .light = 0.25,
         .upright = 0.03, .wander = 0.65, .droop = 0.35, .reiteration = 0.004, .pipeExponent = 1.93, .tipRadius = 0.0026, .girth = 0.7},
        {0.06, 1.4, 6}},
    GrownSpecies{"LombardyPoplar", "Populus nigra 'Italica'", RAMURE_NOOP("A column of limbs that rise along the trunk"), false, {6, 25, 50},
        {.age = 25, .height = 25, .crownWidth = 5.5, .crownBase = 0.03, .crownWidest = 0.35, .crownTop = 0.7, .maturity = 32, .density = 3.0,
         .leaderUntil = 1000, .apicalControl = 0.6, .axil = 36, .branching = 0.9, .autonomy = 0.6, .shadeTolerance = 0.8, .shedding = 0.2,
         .light = 0.1, .upright = 0.5, .wander = 0.2, .droop = 0.05, .pipeExponent = 2.045, .tipRadius = 0.0023, .girth = 0.8},
        {0.07, 2.46, 4}},
    GrownSpecies{"SugarMaple", "Acer saccharum", RAMURE_NOOP("A dense oval crown on rising, forked limbs"), false, {12, 50, 120},
        {.age = 50, .height = 23, .crownWidth = 19, .crownBase = 0.14, .crownWidest = 0.35, .crownTop = 0.5, .maturity = 46, .density = 0.68,
         .leaderUntil = 18, .apicalControl = 0.55, .phyllotaxis = P::Opposite, .axil = 48, .branching = 0.75, .autonomy = 0.45,
         .shadeTolerance = 0.7, .shedding = 0.45, .light = 0.22, .upright = 0.04, .wander = 0.3, .droop = 0.2, .pipeExponent = 2.1,
         .tipRadius = 0.003, .girth = 0.4},
        {0.11, 1.75, 5}},
    GrownSpecies{"NorwayMaple", "Acer platanoides", RAMURE_NOOP("A broad dome of twigs in pairs"), false, {12, 45, 100},
        {.age = 45, .height = 17, .crownWidth = 21, .crownBase = 0.16, .crownWidest = 0.4, .crownTop = 0.4, .maturity = 27, .density = 0.66,
         .leaderUntil = 10, .apicalControl = 0.46, .phyllotaxis = P::Opposite, .axil = 52, .branching = 0.75, .autonomy = 0.45,
         .shadeTolerance = 0.75, .shedding = 0.45, .light = 0.22, .upright = 0.03, .wander = 0.3, .droop = 0.25, .pipeExponent = 2.05,
         .tipRadius = 0.0034, .girth = 0.4},
        {0.13, 1.92, 5}, 0.05},
    GrownSpecies{"JapaneseMaple", "Acer palmatum", RAMURE_NOOP("Level sprays on a low, forked trunk"), false, {8, 35, 90},
        {.age = 35, .height = 8.5, .crownWidth = 14, .crownBase = 0.15, .crownWidest = 0.5, .crownTop = 0.35, .maturity = 14, .density = 0.6,
         .leaderUntil = 6, .apicalControl = 0.45, .internode = 0.12, .phyllotaxis = P::Opposite, .axil = 52, .branching = 0.75, .autonomy = 0.5,
         .sympodial = 0.02, .shadeTolerance = 0.6, .shedding = 0.4, .light = 0.25, .upright = 0.05, .plagiotropy = 0.35, .wander = 0.45,
         .droop = 0.25, .pipeExponent = 2.0, .tipRadius = 0.0018, .girth = 0.5},
        {0.06, 1.19, 5}},
    GrownSpecies{"CommonAsh", "Fraxinus excelsior", RAMURE_NOOP("Open rising limbs with stout twigs in pairs"), false, {12, 50, 110},
        {.age = 50, .height = 19, .crownWidth = 16, .crownBase = 0.2, .crownWidest = 0.45, .crownTop = 0.45, .maturity = 45, .density = 0.62,
         .leaderUntil = 16, .apicalControl = 0.5, .phyllotaxis = P::Opposite, .axil = 46, .acrotony = 0.7, .branching = 0.6, .autonomy = 0.45,
         .shadeTolerance = 0.4, .shedding = 0.6, .light = 0.25, .upright = 0.12, .wander = 0.25, .droop = 0.6, .pipeExponent = 2.15,
         .tipRadius = 0.0046, .girth = 0.4},
        {0.27, 1.05, 3}},
    GrownSpecies{"HorseChestnut", "Aesculus hippocastanum", RAMURE_NOOP("A tall dome whose limbs sink and turn up at their ends"), false, {12, 50, 110},
        {.age = 50, .height = 18, .crownWidth = 17, .crownBase = 0.12, .crownWidest = 0.4, .crownTop = 0.5, .maturity = 45, .density = 0.6,
         .leaderUntil = 16, .apicalControl = 0.4, .phyllotaxis = P::Opposite, .axil = 54, .acrotony = 0.65, .branching = 0.75, .autonomy = 0.45,
         .sympodial = 0.06, .shadeTolerance = 0.75, .shedding = 0.5, .light = 0.2, .upright = 0.12, .wander = 0.25, .droop = 1.0, .pipeExponent = 2.22,
         .tipRadius = 0.006, .girth = 0.35},
        {0.28, 1.2}},
    GrownSpecies{"WildCherry", "Prunus avium", RAMURE_NOOP("Limbs in storeys with short spurs along them"), false, {8, 30, 60},
        {.age = 30, .height = 10.5, .crownWidth = 14, .crownBase = 0.12, .crownWidest = 0.3, .crownTop = 0.6, .maturity = 28, .density = 0.9,
         .leaderUntil = 22, .apicalControl = 0.5, .sideLength = 0.9, .internode = 0.16, .axil = 56, .acrotony = 0.7, .branching = 0.7,
         .endBuds = 3, .autonomy = 0.45, .shortShoots = 0.6, .shadeTolerance = 0.35, .shedding = 0.5, .light = 0.2, .upright = 0.03,
         .wander = 0.2, .droop = 0.2, .pipeExponent = 2.15, .tipRadius = 0.0028, .girth = 0.6},
        {0.1, 0.6, 4}},
    GrownSpecies{"LondonPlane", "Platanus × hispanica", RAMURE_NOOP("A massive trunk under wide, winding limbs"), false, {10, 50, 120},
        {.age = 50, .height = 23, .crownWidth = 22, .crownBase = 0.18, .crownWidest = 0.45, .crownTop = 0.45, .maturity = 42, .density = 0.52,
         .leaderUntil = 18, .apicalControl = 0.55, .phyllotaxis = P::Alternate, .axil = 56, .branching = 0.65, .autonomy = 0.45,
         .shadeTolerance = 0.5, .shedding = 0.55, .light = 0.25, .upright = 0.03, .weeping = 0.15, .wander = 0.55, .droop = 0.4,
         .pipeExponent = 2.08, .tipRadius = 0.0036, .girth = 0.4},
        {0.15, 0.82, 3}},
    GrownSpecies{"AmericanElm", "Ulmus americana", RAMURE_NOOP("A vase: limbs rise and part, and their twigs hang over"), false, {12, 50, 110},
        {.age = 50, .height = 24, .crownWidth = 26, .crownBase = 0.22, .crownWidest = 0.62, .crownTop = 0.45, .maturity = 38, .density = 0.54,
         .leaderUntil = 6, .apicalControl = 0.55, .phyllotaxis = P::Alternate, .axil = 40, .branching = 0.7, .autonomy = 0.45,
         .shadeTolerance = 0.5, .shedding = 0.6, .light = 0.25, .upright = 0.12, .weeping = 0.45, .wander = 0.3, .droop = 0.3,
         .pipeExponent = 2.045, .tipRadius = 0.0026, .girth = 0.4},
        {0.1, 0.88, 5}},
    GrownSpecies{"Hawthorn", "Crataegus monogyna", RAMURE_NOOP("A low, dense and crooked crown of spurs"), false, {7, 30, 80},
        {.age = 30, .height = 6, .crownWidth = 8, .crownBase = 0.14, .crownWidest = 0.5, .crownTop = 0.45, .maturity = 13, .density = 0.62,
         .leaderUntil = 4, .apicalControl = 0.5, .internode = 0.1, .axil = 64, .branching = 1.0, .endBuds = 1, .autonomy = 0.45,
         .shortShoots = 0.7, .shadeTolerance = 0.45, .shedding = 0.35, .light = 0.25, .upright = 0.02, .wander = 0.7, .droop = 0.25,
         .pipeExponent = 2.1, .tipRadius = 0.0016, .girth = 0.25},
        {0.04, 0.51, 4}},
    GrownSpecies{"RedOak", "Quercus rubra", RAMURE_NOOP("A straight trunk with stout spreading limbs"), false, {12, 50, 110},
        {.age = 50, .height = 25, .crownWidth = 25, .crownBase = 0.15, .crownWidest = 0.4, .crownTop = 0.5, .maturity = 45, .density = 0.58,
         .leaderUntil = 25, .apicalControl = 0.6, .axil = 60, .acrotony = 0.75, .branching = 0.7, .endBuds = 3, .autonomy = 0.45,
         .shadeTolerance = 0.45, .shedding = 0.6, .light = 0.25, .upright = 0.05, .wander = 0.4, .droop = 0.25, .pipeExponent = 2.1,
         .tipRadius = 0.0036, .girth = 0.4},
        {0.16, 0.73, 4}},
    GrownSpecies{"LiveOak", "Quercus virginiana", RAMURE_NOOP("Wider than high, with long limbs that wander"), false, {12, 60, 150},
        {.age = 60, .height = 16.5, .crownWidth = 29, .crownBase = 0.14, .crownWidest = 0.4, .crownTop = 0.35, .maturity = 20, .density = 0.35,
         .leaderUntil = 6, .apicalControl = 0.62, .axil = 64, .branching = 0.75, .autonomy = 0.45, .shadeTolerance = 0.6, .shedding = 0.5,
         .light = 0.22, .upright = 0.0, .plagiotropy = 0.05, .wander = 0.7, .droop = 0.1, .reiteration = 0.001, .pipeExponent = 1.95,
         .tipRadius = 0.003, .girth = 0.4},
        {0.085, 0.8, 4}},
    GrownSpecies{"SweetChestnut", "Castanea sativa", RAMURE_NOOP("A massive trunk under a rounded crown"), false, {12, 60, 150},
        {.age = 60, .height = 18, .crownWidth = 17, .crownBase = 0.16, .crownWidest = 0.4, .crownTop = 0.5, .maturity = 45, .density = 0.62,
         .leaderUntil = 18, .apicalControl = 0.6, .axil = 58, .branching = 0.7, .autonomy = 0.45, .shadeTolerance = 0.6, .shedding = 0.5,
         .light = 0.25, .upright = 0.05, .wander = 0.5, .droop = 0.3, .reiteration = 0.004, .pipeExponent = 1.9, .tipRadius = 0.0036,
         .girth = 0.8},
        {0.18, 0.65, 3}},
    GrownSpecies{"TulipTree", "Liriodendron tulipifera", RAMURE_NOOP("A straight trunk to the top of a tall crown"), false, {12, 50, 110},
        {.age = 50, .height = 25, .crownWidth = 18, .crownBase = 0.16, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 50, .density = 0.8,
         .leaderUntil = 60, .apicalControl = 0.6, .axil = 52, .branching = 0.65, .autonomy = 0.5, .shadeTolerance = 0.3, .shedding = 0.6,
         .light = 0.25, .upright = 0.1, .wander = 0.25, .droop = 0.3, .pipeExponent = 2.09, .tipRadius = 0.0038, .girth = 0.4},
        {0.13, 0.93, 3}},
    GrownSpecies{"Sweetgum", "Liquidambar styraciflua", RAMURE_NOOP("A straight trunk with limbs that get shorter upwards"), false, {12, 45, 90},
        {.age = 45, .height = 22, .crownWidth = 16, .crownBase = 0.12, .crownWidest = 0.25, .crownTop = 0.65, .maturity = 45, .density = 0.95,
         .leaderUntil = 70, .apicalControl = 0.55, .axil = 56, .branching = 0.75, .autonomy = 0.5, .shadeTolerance = 0.35, .shedding = 0.5,
         .light = 0.2, .upright = 0.05, .wander = 0.25, .droop = 0.3, .pipeExponent = 2.15, .tipRadius = 0.003, .girth = 0.45},
        {0.12, 0.98, 3}},
    GrownSpecies{"BlackLocust", "Robinia pseudoacacia", RAMURE_NOOP("Crooked rising limbs in a narrow, open crown"), false, {8, 35, 80},
        {.age = 35, .height = 20, .crownWidth = 13, .crownBase = 0.25, .crownWidest = 0.5, .crownTop = 0.4, .maturity = 32, .density = 0.8,
         .leaderUntil = 12, .apicalControl = 0.55, .phyllotaxis = P::Alternate, .axil = 42, .branching = 0.65, .autonomy = 0.45,
         .shadeTolerance = 0.2, .shedding = 0.65, .light = 0.3, .upright = 0.12, .wander = 0.65, .droop = 0.2, .pipeExponent = 1.98,
         .tipRadius = 0.0032, .girth = 0.5},
        {0.22, 0.42, 3}},
    GrownSpecies{"Rowan", "Sorbus aucuparia", RAMURE_NOOP("A small crown of rising limbs"), false, {6, 25, 50},
        {.age = 25, .height = 8, .crownWidth = 9, .crownBase = 0.16, .crownWidest = 0.45, .crownTop = 0.5, .maturity = 24, .density = 0.75,
         .leaderUntil = 10, .apicalControl = 0.5, .internode = 0.13, .axil = 44, .branching = 0.75, .autonomy = 0.45, .shortShoots = 0.55,
         .shadeTolerance = 0.4, .shedding = 0.4, .light = 0.25, .upright = 0.1, .wander = 0.25, .droop = 0.2, .pipeExponent = 2.18,
         .tipRadius = 0.0026, .girth = 0.3},
        {0.17, 0.75, 3}},
    GrownSpecies{"Hornbeam", "Carpinus betulus", RAMURE_NOOP("Many fine rising limbs, dense nearly to the ground"), false, {10, 45, 100},
        {.age = 45, .height = 14, .crownWidth = 13, .crownBase = 0.1, .crownWidest = 0.45, .crownTop = 0.45, .maturity = 28, .density = 0.7,
         .leaderUntil = 10, .apicalControl = 0.55, .sideLength = 0.85, .phyllotaxis = P::Alternate, .axil = 42, .branching = 0.7,
         .autonomy = 0.5, .shadeTolerance = 0.8, .shedding = 0.35, .light = 0.2, .upright = 0.06, .plagiotropy = 0.1, .wander = 0.35,
         .pipeExponent = 1.9, .tipRadius = 0.0026, .girth = 0.4},
        {0.08, 0.94, 5}},
    GrownSpecies{"CommonAlder", "Alnus glutinosa", RAMURE_NOOP("A slender cone around a trunk that reaches its top"), false, {8, 35, 70},
        {.age = 35, .height = 13.5, .crownWidth = 11.5, .crownBase = 0.14, .crownWidest = 0.3, .crownTop = 0.6, .maturity = 35, .density = 1.0,
         .leaderUntil = 50, .apicalControl = 0.5, .internode = 0.17, .axil = 56, .branching = 0.75, .autonomy = 0.5, .shadeTolerance = 0.3,
         .shedding = 0.5, .light = 0.25, .upright = 0.06, .wander = 0.25, .droop = 0.2, .pipeExponent = 2.06, .tipRadius = 0.003, .girth = 0.6},
        {0.075, 1.37, 4}},
    GrownSpecies{"CommonWalnut", "Juglans regia", RAMURE_NOOP("Stout limbs under a broad crown"), false, {10, 45, 100},
        {.age = 45, .height = 15, .crownWidth = 16, .crownBase = 0.18, .crownWidest = 0.45, .crownTop = 0.4, .maturity = 32, .density = 0.5,
         .leaderUntil = 7, .apicalControl = 0.5, .axil = 56, .acrotony = 0.7, .branching = 0.65, .autonomy = 0.45, .shadeTolerance = 0.35,
         .shedding = 0.55, .light = 0.25, .upright = 0.06, .wander = 0.45, .droop = 0.3, .pipeExponent = 2.23, .tipRadius = 0.005, .girth = 0.25},
        {0.33, 0.95, 3}},
    GrownSpecies{"Ginkgo", "Ginkgo biloba", RAMURE_NOOP("Stiff rising limbs studded with spurs"), false, {12, 50, 120},
        {.age = 50, .height = 18, .crownWidth = 16, .crownBase = 0.1, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 50, .density = 0.38,
         .leaderUntil = 40, .apicalControl = 0.65, .axil = 52, .branching = 0.7, .endBuds = 1, .autonomy = 0.5, .shortShoots = 0.7,
         .shadeTolerance = 0.2, .shedding = 0.35, .light = 0.2, .upright = 0.08, .wander = 0.3, .droop = 0.2, .pipeExponent = 2.2,
         .tipRadius = 0.0035, .girth = 0.3},
        {0.06, 0.96, 4}},
    GrownSpecies{"ScotsPine", "Pinus sylvestris", RAMURE_NOOP("A high crown in clouds on a bare red stem"), true, {12, 60, 140},
        {.age = 60, .height = 20, .crownWidth = 14, .crownBase = 0.45, .crownWidest = 0.5, .crownTop = 0.6, .maturity = 60, .density = 1.4,
         .leaderUntil = 40, .apicalControl = 0.7, .sideLength = 0.8, .axil = 72, .acrotony = 1.0, .branching = 0.6, .whorl = 5, .autonomy = 0.55,
         .shadeTolerance = 0.35, .shedding = 0.85, .light = 0.08, .upright = 0.03, .plagiotropy = 0.5, .wander = 0.35, .droop = 0.05,
         .reiteration = 0.01, .tipRadius = 0.0032, .girth = 0.7},
        {0.18, 1.43, 3}},
    GrownSpecies{"NorwaySpruce", "Picea abies", RAMURE_NOOP("A spire of whorls, each limb hung with twigs"), true, {12, 50, 100},
        {.age = 50, .height = 26, .crownWidth = 10, .crownBase = 0.03, .crownWidest = 0.05, .crownTop = 0.85, .maturity = 65, .density = 1.4,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.65, .axil = 78, .acrotony = 0.0, .branching = 0.9, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.0, .upright = 0.1, .weeping = 0.5, .wander = 0.15, .droop = 0.7,
         .tipRadius = 0.0034},
        {0.19, 0.82, 3, 0.7}},
    GrownSpecies{"LebanonCedar", "Cedrus libani", RAMURE_NOOP("Level limbs in storeys, a flat top when old"), true, {15, 70, 160},
        {.age = 70, .height = 20, .crownWidth = 20, .crownBase = 0.1, .crownWidest = 0.4, .crownTop = 0.3, .maturity = 60, .density = 0.6,
         .leaderUntil = 30, .apicalControl = 0.7, .sideLength = 0.85, .axil = 76, .acrotony = 0.9, .branching = 1.0, .autonomy = 0.6,
         .shortShoots = 0.3, .shadeTolerance = 0.5, .shedding = 0.5, .light = 0.1, .upright = 0.0, .plagiotropy = 0.9, .wander = 0.25,
         .droop = 0.05, .pipeExponent = 2.1, .tipRadius = 0.0036},
        {0.19, 0.6, 4, 1.35}},
    GrownSpecies{"EuropeanLarch", "Larix decidua", RAMURE_NOOP("A light cone whose twigs hang from level limbs"), true, {10, 45, 100},
        {.age = 45, .height = 20, .crownWidth = 11.5, .crownBase = 0.08, .crownWidest = 0.1, .crownTop = 0.8, .maturity = 50, .density = 0.95,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.65, .axil = 76, .acrotony = 0.2, .branching = 0.88, .whorl = 3,
         .autonomy = 0.5, .shortShoots = 0.6, .shadeTolerance = 0.6, .shedding = 0.1, .light = 0.1, .upright = 0.06, .weeping = 0.55,
         .plagiotropy = 0.2, .wander = 0.25, .droop = 0.5, .pipeExponent = 2.14, .tipRadius = 0.0028, .girth = 0.4},
        {0.14, 0.43, 3, 1.1}},
    GrownSpecies{"EasternWhitePine", "Pinus strobus", RAMURE_NOOP("Whorls of level limbs that end in plumes"), true, {12, 50, 110},
        {.age = 50, .height = 22, .crownWidth = 13, .crownBase = 0.2, .crownWidest = 0.3, .crownTop = 0.6, .maturity = 55, .density = 1.3,
         .leaderUntil = 200, .apicalControl = 0.65, .sideLength = 0.75, .axil = 76, .acrotony = 1.0, .branching = 0.65, .whorl = 5,
         .autonomy = 0.55, .shadeTolerance = 0.45, .shedding = 0.6, .light = 0.08, .upright = 0.05, .plagiotropy = 0.6, .wander = 0.25,
         .droop = 0.1, .tipRadius = 0.0032, .girth = 0.5},
        {0.2, 1.67, 3}},
    GrownSpecies{"BlueSpruce", "Picea pungens", RAMURE_NOOP("A stiff blue cone of whorled limbs"), true, {10, 40, 80},
        {.age = 40, .height = 17, .crownWidth = 13.5, .crownBase = 0.02, .crownWidest = 0.05, .crownTop = 0.85, .maturity = 55, .density = 1.6,
         .leaderUntil = 1000, .apicalControl = 0.55, .sideLength = 0.72, .axil = 78, .acrotony = 0.0, .branching = 1.1, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.0, .upright = 0.08, .weeping = 0.12, .wander = 0.12, .droop = 0.35,
         .pipeExponent = 2.07, .tipRadius = 0.0034, .girth = 0.3},
        {0.19, 0.68, 3, 0.7}},
    GrownSpecies{"DeodarCedar", "Cedrus deodara", RAMURE_NOOP("A cone of level limbs with hanging tips"), true, {12, 55, 120},
        {.age = 55, .height = 23, .crownWidth = 24, .crownBase = 0.05, .crownWidest = 0.15, .crownTop = 0.7, .maturity = 55, .density = 0.54,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.8, .axil = 74, .acrotony = 0.7, .branching = 0.9, .autonomy = 0.55,
         .shortShoots = 0.4, .shadeTolerance = 0.6, .shedding = 0.3, .light = 0.08, .upright = 0.0, .weeping = 0.5, .plagiotropy = 0.4,
         .wander = 0.2, .droop = 0.3, .pipeExponent = 2.1, .tipRadius = 0.0032, .girth = 0.4},
        {0.19, 0.6, 4, 1.35}},
    GrownSpecies{"WhiteWillow", "Salix alba", RAMURE_NOOP("A tall silvery head on leaning limbs"), false, {8, 35, 70},
        {.age = 35, .height = 17, .crownWidth = 21, .crownBase = 0.14, .crownWidest = 0.45, .crownTop = 0.45, .maturity = 28, .density = 0.6,
         .leaderUntil = 8, .apicalControl = 0.5, .axil = 42, .branching = 0.68, .endBuds = 1, .autonomy = 0.45, .shadeTolerance = 0.3,
         .shedding = 0.5, .light = 0.25, .upright = 0.14, .weeping = 0.5, .wander = 0.45, .droop = 0.3, .pipeExponent = 1.83, .tipRadius = 0.0028,
         .girth = 0.6},
        {0.09, 1.3, 6, 1.6}},
    GrownSpecies{"HoneyLocust", "Gleditsia triacanthos", RAMURE_NOOP("A light open crown that lets the sun through"), false, {10, 45, 90},
        {.age = 45, .height = 20, .crownWidth = 19, .crownBase = 0.2, .crownWidest = 0.55, .crownTop = 0.42, .maturity = 34, .density = 0.55,
         .leaderUntil = 8, .apicalControl = 0.5, .phyllotaxis = P::Alternate, .axil = 54, .branching = 0.65, .autonomy = 0.45,
         .shadeTolerance = 0.2, .shedding = 0.6, .light = 0.3, .upright = 0.06, .wander = 0.4, .droop = 0.3, .pipeExponent = 2.15,
         .tipRadius = 0.0034, .girth = 0.45},
        {0.22, 0.6, 3, 1.4}},
    GrownSpecies{"RainTree", "Samanea saman", RAMURE_NOOP("A vast flat parasol on a short stout trunk"), false, {10, 45, 100},
        {.age = 45, .height = 18.5, .crownWidth = 40, .crownBase = 0.25, .crownWidest = 0.65, .crownTop = 0.5, .maturity = 22, .density = 0.3,
         .leaderUntil = 2, .apicalControl = 0.5, .phyllotaxis = P::Alternate, .axil = 58, .branching = 0.68, .autonomy = 0.45,
         .shadeTolerance = 0.3, .shedding = 0.65, .light = 0.3, .upright = 0.02, .plagiotropy = 0.1, .wander = 0.5, .droop = 0.15,
         .pipeExponent = 2.0, .tipRadius = 0.0038, .girth = 0.5},
        {0.3, 0.34, 2}},
    GrownSpecies{"DouglasFir", "Pseudotsuga menziesii", RAMURE_NOOP("A very tall dense spire on a furrowed trunk"), true, {12, 60, 140},
        {.age = 60, .height = 31, .crownWidth = 17, .crownBase = 0.08, .crownWidest = 0.08, .crownTop = 0.8, .maturity = 65, .density = 0.58,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.65, .axil = 76, .acrotony = 0.3, .branching = 0.9, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.1, .upright = 0.08, .weeping = 0.3, .plagiotropy = 0.3, .wander = 0.15,
         .droop = 0.5, .pipeExponent = 2.05, .tipRadius = 0.0034, .girth = 0.4},
        {0.2, 0.85, 4}},
    GrownSpecies{"StonePine", "Pinus pinea", RAMURE_NOOP("An umbrella on a tall bare trunk"), true, {10, 60, 120},
        {.age = 60, .height = 14.5, .crownWidth = 14, .crownBase = 0.65, .crownWidest = 0.35, .crownTop = 0.6, .maturity = 38, .density = 1.0,
         .leaderUntil = 20, .apicalControl = 0.6, .sideLength = 0.9, .axil = 72, .acrotony = 1.0, .branching = 0.65, .whorl = 4, .autonomy = 0.55,
         .shadeTolerance = 0.2, .shedding = 0.9, .light = 0.15, .upright = 0.08, .plagiotropy = 0.2, .wander = 0.4, .droop = 0.05,
         .pipeExponent = 2.0, .tipRadius = 0.0036, .girth = 0.5},
        {0.2, 0.8, 3}},
    GrownSpecies{"ItalianCypress", "Cupressus sempervirens", RAMURE_NOOP("A dark green flame, hardly wider than its trunk"), true, {8, 40, 100},
        {.age = 40, .height = 17.5, .crownWidth = 3.6, .crownBase = 0.02, .crownWidest = 0.3, .crownTop = 0.75, .maturity = 38, .density = 4.2,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.8, .axil = 36, .branching = 0.95, .endBuds = 1, .autonomy = 0.6, .shadeTolerance = 0.9,
         .shedding = 0.1, .light = 0.05, .upright = 0.5, .wander = 0.12, .droop = 0.0, .pipeExponent = 1.95, .tipRadius = 0.0022, .girth = 0.5},
        {0.14, 1.5, 3, 1.3}},
    GrownSpecies{"GiantSequoia", "Sequoiadendron giganteum", RAMURE_NOOP("A massive column under a narrow crown of upturned limbs"), true, {20, 120, 250},
        {.age = 120, .height = 46, .crownWidth = 17, .crownBase = 0.12, .crownWidest = 0.3, .crownTop = 0.6, .maturity = 130, .density = 0.35,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.65, .axil = 78, .acrotony = 0.3, .branching = 0.9, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.2, .light = 0.1, .upright = 0.1, .weeping = 0.1, .plagiotropy = 0.0,
         .wander = 0.25, .droop = 0.9, .pipeExponent = 1.82, .tipRadius = 0.004, .girth = 0.5},
        {0.22, 1.0, 6, 1.6}},
    GrownSpecies{"CommonYew", "Taxus baccata", RAMURE_NOOP("A broad dark dome, dense to the ground"), true, {15, 90, 250},
        {.age = 90, .height = 14, .crownWidth = 13.5, .crownBase = 0.04, .crownWidest = 0.3, .crownTop = 0.5, .maturity = 85, .density = 1.0,
         .leaderUntil = 45, .apicalControl = 0.6, .sideLength = 0.9, .phyllotaxis = P::Alternate, .axil = 62, .acrotony = 0.4, .branching = 0.9,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.1, .light = 0.15, .upright = 0.04, .plagiotropy = 0.3, .wander = 0.3, .droop = 0.3,
         .pipeExponent = 2.0, .tipRadius = 0.0026, .girth = 0.4},
        {0.17, 0.75, 4}},
    GrownSpecies{"BalsamFir", "Abies balsamea", RAMURE_NOOP("A narrow regular spire, dense to the ground"), true, {10, 45, 90},
        {.age = 45, .height = 16, .crownWidth = 8.5, .crownBase = 0.02, .crownWidest = 0.05, .crownTop = 0.8, .maturity = 50, .density = 2.0,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.65, .axil = 80, .acrotony = 0.0, .branching = 1.1, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.0, .upright = 0.1, .plagiotropy = 0.3, .wander = 0.1, .droop = 0.2,
         .pipeExponent = 2.2, .tipRadius = 0.003, .girth = 0.3},
        {0.16, 0.8, 3, 0.8}},
    GrownSpecies{"CoastRedwood", "Sequoia sempervirens", RAMURE_NOOP("A tower with a narrow crown of sinking limbs"), true, {12, 60, 140},
        {.age = 60, .height = 33, .crownWidth = 14, .crownBase = 0.1, .crownWidest = 0.15, .crownTop = 0.75, .maturity = 70, .density = 0.72,
         .leaderUntil = 1000, .apicalControl = 0.6, .sideLength = 0.65, .axil = 78, .acrotony = 0.0, .branching = 0.9, .whorl = 4,
         .autonomy = 0.55, .shadeTolerance = 1.0, .shedding = 0.1, .light = 0.05, .upright = 0.04, .weeping = 0.35, .plagiotropy = 0.3,
         .wander = 0.18, .droop = 0.8, .pipeExponent = 1.98, .tipRadius = 0.0034, .girth = 0.5},
        {0.2, 0.53, 5}},
    GrownSpecies{"EasternCottonwood", "Populus deltoides", RAMURE_NOOP("A tall wide vase of stout limbs"), false, {8, 40, 80},
        {.age = 40, .height = 28, .crownWidth = 25, .crownBase = 0.2, .crownWidest = 0.55, .crownTop = 0.45, .maturity = 36, .density = 1.0,
         .leaderUntil = 12, .apicalControl = 0.55, .axil = 48, .branching = 0.68, .autonomy = 0.45, .shadeTolerance = 0.2, .shedding = 0.6,
         .light = 0.25, .upright = 0.1, .wander = 0.4, .droop = 0.3, .pipeExponent = 2.1, .tipRadius = 0.0036, .girth = 0.5},
        {0.1, 0.6, 4}},
    GrownSpecies{"FieldElm", "Ulmus minor", RAMURE_NOOP("A tall crown in clouds on winding limbs"), false, {10, 50, 110},
        {.age = 50, .height = 22, .crownWidth = 17, .crownBase = 0.18, .crownWidest = 0.55, .crownTop = 0.45, .maturity = 42, .density = 0.75,
         .leaderUntil = 12, .apicalControl = 0.55, .phyllotaxis = P::Alternate, .axil = 46, .branching = 0.75, .autonomy = 0.45,
         .shadeTolerance = 0.5, .shedding = 0.5, .light = 0.25, .upright = 0.08, .wander = 0.45, .droop = 0.25, .reiteration = 0.004,
         .pipeExponent = 2.0, .tipRadius = 0.0026, .girth = 0.45},
        {0.08, 0.8, 5}},
    GrownSpecies{"Jacaranda", "Jacaranda mimosifolia", RAMURE_NOOP("A loose vase of ferny leaves on crooked limbs"), false, {8, 35, 70},
        {.age = 35, .height = 12.5, .crownWidth = 14, .crownBase = 0.22, .crownWidest = 0.6, .crownTop = 0.4, .maturity = 22, .density = 0.7,
         .leaderUntil = 5, .apicalControl = 0.5, .phyllotaxis = P::Opposite, .axil = 48, .branching = 0.65, .autonomy = 0.45,
         .shadeTolerance = 0.25, .shedding = 0.55, .light = 0.3, .upright = 0.08, .wander = 0.6, .droop = 0.2, .pipeExponent = 2.2,
         .tipRadius = 0.004, .girth = 0.4},
        {0.35, 0.65, 2}},
    GrownSpecies{"BlueGum", "Eucalyptus globulus", RAMURE_NOOP("A tall pale stem that sheds its bark, with hanging leaves"), false, {8, 40, 80},
        {.age = 40, .height = 37, .crownWidth = 24, .crownBase = 0.3, .crownWidest = 0.5, .crownTop = 0.5, .maturity = 48, .density = 2.0,
         .leaderUntil = 22, .apicalControl = 0.6, .axil = 44, .branching = 0.65, .autonomy = 0.45, .shadeTolerance = 0.2, .shedding = 0.7,
         .light = 0.3, .upright = 0.15, .weeping = 0.2, .wander = 0.35, .droop = 0.25, .pipeExponent = 2.1, .tipRadius = 0.0036, .girth = 0.5},
        {0.2, 0.44, 5}},
    GrownSpecies{"SouthernMagnolia", "Magnolia grandiflora", RAMURE_NOOP("A dark pyramid of leather leaves, clothed to the ground"), false, {10, 50, 110},
        {.age = 50, .height = 15, .crownWidth = 16, .crownBase = 0.05, .crownWidest = 0.25, .crownTop = 0.6, .maturity = 36, .density = 0.75,
         .leaderUntil = 60, .apicalControl = 0.55, .axil = 58, .branching = 0.72, .autonomy = 0.5, .shadeTolerance = 0.8, .shedding = 0.3,
         .light = 0.2, .upright = 0.06, .wander = 0.3, .droop = 0.3, .pipeExponent = 2.08, .tipRadius = 0.0046, .girth = 0.5},
        {0.17, 1.3, 5}},
    // 12 to 16 fronds of 4 to 6 m open in a year and last for two to three; a bunch of nuts stands in the axil of each
    // (Chan, Elevitch, "Cocos nucifera (coconut)", Species Profiles for Pacific Island Agroforestry, 2006).
    GrownSpecies{"CoconutPalm", "Cocos nucifera", RAMURE_NOOP("A leaning stem that never branches under a crown of fronds"), false, {6, 40, 80},
        {.age = 40, .habit = GrowthHabit::Palm, .height = 20, .maturity = 45, .wander = 0.8, .stemRadius = 0.18}, {}},
};
// clang-format on

} // namespace

std::span<const GrownSpecies> grownSpecies()
{
    return grownTable;
}

namespace {

/// What is usual of collars and feet is too much where limbs stand close, or where a stem forks or thins
/// before breast height.
struct GrownWood
{
    std::string_view name;
    double collar = 0.5, rootLength = 0.55, rootHeight = 1.0; ///< see MeshParams
};
constexpr std::array grownWoods{
    GrownWood{.name = "EnglishOak", .collar = 0.3},
    GrownWood{.name = "LiveOak", .collar = 0.2},
    GrownWood{.name = "AmericanElm", .collar = 0.35},
    GrownWood{.name = "CommonWalnut", .rootLength = 0.35},
    GrownWood{.name = "EuropeanBeech", .rootLength = 0.4},
    GrownWood{.name = "Ginkgo", .rootLength = 0.45},
    GrownWood{.name = "Hawthorn", .rootLength = 0.1, .rootHeight = 0.5},
    GrownWood{.name = "Hornbeam", .rootLength = 0.45},
    GrownWood{.name = "HorseChestnut", .rootLength = 0.36},
    GrownWood{.name = "CommonYew", .rootLength = 0.42},
    GrownWood{.name = "ItalianCypress", .rootLength = 0.45},
    GrownWood{.name = "Jacaranda", .rootLength = 0.44},
    GrownWood{.name = "JapaneseMaple", .rootLength = 0.2},
    GrownWood{.name = "LombardyPoplar", .collar = 0.4, .rootLength = 0.42},
    GrownWood{.name = "LondonPlane", .rootLength = 0.48},
    GrownWood{.name = "OliveTree", .rootLength = 0.1},
    GrownWood{.name = "OrchardApple", .rootLength = 0.45},
    GrownWood{.name = "RainTree", .collar = 0.15},
    GrownWood{.name = "Sweetgum", .rootLength = 0.4},
    GrownWood{.name = "WeepingWillow", .rootLength = 0.4},
};

void setWood(MeshParams& mesh, std::string_view name)
{
    constexpr std::int64_t mostRoots = 5; // some fork
    const auto own = std::ranges::find(grownWoods, name, &GrownWood::name);
    const GrownWood wood = own != grownWoods.end() ? *own : GrownWood{};
    mesh.collar = wood.collar;
    mesh.rootLength = wood.rootLength;
    mesh.rootHeight = wood.rootHeight;
    mesh.roots = std::min(mesh.roots, mostRoots);
}

/// What old trees of a species are known by: eyes of beeches, burrs of lindens, planes and
/// walnuts, hollow olives and chestnuts (Mitchell, "A field guide to the trees of Britain and Northern
/// Europe", 1974).
struct GrownMarks
{
    std::string_view name;
    double scars = 1.0, hollows = 0.0, burrs = 0.0; ///< see GrowthParams
};
constexpr std::array grownMarks{
    GrownMarks{.name = "CommonWalnut", .burrs = 0.4},
    GrownMarks{.name = "EuropeanBeech"},
    GrownMarks{.name = "LondonPlane", .scars = 0.0, .burrs = 0.3},
    GrownMarks{.name = "OliveTree", .hollows = 0.5, .burrs = 0.4},
    GrownMarks{.name = "SmallLeavedLinden", .burrs = 0.6},
    GrownMarks{.name = "SweetChestnut", .hollows = 0.4, .burrs = 0.2},
};

void setMarks(GrowthParams& growth, std::string_view name)
{
    if (const auto own = std::ranges::find(grownMarks, name, &GrownMarks::name); own != grownMarks.end()) {
        growth.scars = own->scars;
        growth.hollows = own->hollows;
        growth.burrs = own->burrs;
    }
}

} // namespace

NodeParams grownParams(const GrownSpecies& species, const NodeParams& dress)
{
    NodeParams params = dress;
    params.generator.kind = EditOperation::Growth;
    params.weberPenn = {};
    params.growth = species.growth;
    params.season.redness = species.redness;
    if (species.growth.habit == GrowthHabit::Palm) { // its fronds carry leaves and fruit of their own
        params.grammar = {};
        params.leaf.shape = LeafShape::Bamboo; // linear and evergreen
        params.leaf.width = 0.45;
        return params;
    }
    params.growth.axil *= oneDegree;
    setWood(params.mesh, species.name);
    setMarks(params.growth, species.name);
    // Leaves stand on the shoots of the last years.
    setLeaves(params, species.leaves);
    const double leafyTips = species.conifer ? 3.0 : 2.0; // needles stay for years
    params.foliage.leavesCutoff = leafyTips * params.growth.tipRadius / trunkRadius(params);
    return params;
}

} // namespace ramure
