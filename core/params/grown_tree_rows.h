/// \file
/// Rows of trees that grow year by year. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"
#include "core/params/source_facts.h"

namespace ramure::rows {

inline constexpr const char* ageGroup = RAMURE_NOOP("Age");
inline constexpr const char* grownSizeGroup = RAMURE_NOOP("Size of the grown tree");
inline constexpr const char* shootsGroup = RAMURE_NOOP("Shoots");
inline constexpr const char* lightGroup = RAMURE_NOOP("Light");
inline constexpr const char* siteGroup = RAMURE_NOOP("Site");
inline constexpr const char* habitGroup = RAMURE_NOOP("Habit");
inline constexpr const char* woodGroup = RAMURE_NOOP("Wood");
inline constexpr const char* barkMarksGroup = RAMURE_NOOP("Marks of the bark");
inline constexpr const char* palmGroup = RAMURE_NOOP("Palm");

inline constexpr Condition* growsByYears = [](const NodeParams& p) {
    return p.generator.kind == EditOperation::Growth;
};
inline constexpr Condition* branches = [](const NodeParams& p) {
    return growsByYears(p) && p.growth.habit == GrowthHabit::Branching;
};
inline constexpr Condition* isPalm = [](const NodeParams& p) {
    return growsByYears(p) && p.growth.habit == GrowthHabit::Palm;
};
inline constexpr Condition* hasSpiral = [](const NodeParams& p) {
    return branches(p) && p.growth.phyllotaxis == Phyllotaxis::Spiral;
};
inline constexpr Condition* hasNoWhorl = [](const NodeParams& p) {
    return branches(p) && p.growth.whorl == 0;
};

inline constexpr Condition* hasScars = [](const NodeParams& p) {
    return branches(p) && p.growth.scars > 0.0;
};

inline constexpr SourceFacts growthFacts{
    EditOperation::Growth, "growth.age",
    [](const NodeParams& p) { // whatever its age: leaves do not grow with the trunk
        return p.growth.habit == GrowthHabit::Palm ? p.growth.stemRadius : 0.018 * p.growth.height;
    },
    [](const NodeParams& p) { return 0.5 * p.growth.crownWidth; },
    [](const NodeParams& p) {
        return p.growth.sees == GrowthLight::Space ? SolidUse::Fills : SolidUse::Around;
    }};

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
/// Everything but the age is of the history, which any age is cut out of.
template <auto Member>
constexpr ParamDef grownRow(const Words& words, ParamUnit unit, const Range& range, std::uint16_t flags = paramNone,
                            Condition* matters = branches)
{
    return row<&NodeParams::growth, Member>(words, unit, range, Stage::Symbols, flags, treeOnly, matters);
}

inline constexpr std::array grownTreeRows{
    row<&NodeParams::growth, &GrowthParams::age>(
        {"growth.age", ageGroup, RAMURE_NOOP("Age"),
         RAMURE_NOOP("Years since the tree was a seed. All ages belong to one life: a branch that exists at 40 existed at 30, or has grown since.")},
        ParamUnit::Year, {0, 2000, 0, 150, 1, 2}, Stage::Skeleton, paramAnimatable, treeOnly, growsByYears),
    grownRow<&GrowthParams::habit>(
        {"growth.habit", ageGroup, RAMURE_NOOP("Habit"),
         RAMURE_NOOP("Branching: shoots that compete for light. Palm: one stem that never branches under a crown of fronds, which open, bow and "
                     "fall as they get older.")},
        ParamUnit::None, {}, paramNone, growsByYears),
    grownRow<&GrowthParams::leaderUntil>(
        {"growth.leaderUntil", ageGroup, RAMURE_NOOP("Leader until"),
         RAMURE_NOOP("The year in which the trunk loses its lead and becomes a limb among limbs. Late: one trunk to the top. Early: a crown "
                     "of many limbs on a short trunk.")},
        ParamUnit::Year, {0, 1e5, 0, 150, 1, 1}),
    grownRow<&GrowthParams::maturity>(
        {"growth.maturity", ageGroup, RAMURE_NOOP("Mature at"),
         RAMURE_NOOP("Years until the height is nearly reached.")},
        ParamUnit::Year, {2, 2000, 5, 200, 1, 0}, paramNone, growsByYears),

    grownRow<&GrowthParams::height>(
        {"growth.height", grownSizeGroup, RAMURE_NOOP("Height"),
         RAMURE_NOOP("Height of the mature tree.")},
        ParamUnit::Metre, {0.05, 150, 1, 50, 0.5, 2}, paramNone, growsByYears),
    grownRow<&GrowthParams::crownWidth>(
        {"growth.crownWidth", grownSizeGroup, RAMURE_NOOP("Spread"),
         RAMURE_NOOP("Width of the mature crown.")},
        ParamUnit::Metre, {0.02, 150, 0.5, 40, 0.5, 2}),
    grownRow<&GrowthParams::crownBase>(
        {"growth.crownBase", grownSizeGroup, RAMURE_NOOP("Crown begins at"),
         RAMURE_NOOP("Length of the bare trunk, as a share of the height. In the mature tree, limbs below get no light.")},
        ParamUnit::Share, {0, 0.95, 0, 0.8, 0.01, 2}),
    grownRow<&GrowthParams::crownWidest>(
        {"growth.crownWidest", grownSizeGroup, RAMURE_NOOP("Widest at"),
         RAMURE_NOOP("Height at which the crown is widest, as a share of the crown's height.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}),
    grownRow<&GrowthParams::crownTop>(
        {"growth.crownTop", grownSizeGroup, RAMURE_NOOP("Shape of the top"),
         RAMURE_NOOP("How the crown narrows towards its top: 0.2 as an umbrella, 0.5 round, 1 as a cone.")},
        ParamUnit::None, {0.05, 3, 0.1, 1.5, 0.05, 2}),
    grownRow<&GrowthParams::density>(
        {"growth.density", grownSizeGroup, RAMURE_NOOP("Density"),
         RAMURE_NOOP("How many shoots the crown has: 1 is usual. More take longer.")},
        ParamUnit::Factor, {0.05, 10, 0.2, 2, 0.05, 2}),
    grownRow<&GrowthParams::stems>(
        {"growth.stems", grownSizeGroup, RAMURE_NOOP("Stems"),
         RAMURE_NOOP("How many stems leave the ground, as of a birch in a clump or of a coppiced hazel.")},
        ParamUnit::Count, {1, 12, 1, 8, 1, 0}),

    grownRow<&GrowthParams::internode>(
        {"growth.internode", shootsGroup, RAMURE_NOOP("Internode"),
         RAMURE_NOOP("From one bud to the next on a long shoot. Short ones make a finer tree, and take longer.")},
        ParamUnit::Metre, {0.001, 5, 0.05, 0.5, 0.01, 3}),
    grownRow<&GrowthParams::phyllotaxis>(
        {"growth.phyllotaxis", shootsGroup, RAMURE_NOOP("Phyllotaxis"),
         RAMURE_NOOP("How buds follow each other along a shoot. Spiral: one at a time, turned on, as of oaks. Opposite: in crossed pairs, as "
                     "of maples and ashes. Alternate: left and right in turn, as of beeches and lindens.")},
        ParamUnit::None, {}),
    grownRow<&GrowthParams::divergence>(
        {"growth.divergence", shootsGroup, RAMURE_NOOP("Divergence"),
         RAMURE_NOOP("How far each bud of a spiral is turned about the shoot from the one before.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, 0, pi, pi / 180, 4}, paramAdvanced, hasSpiral),
    grownRow<&GrowthParams::axil>(
        {"growth.axil", shootsGroup, RAMURE_NOOP("Insertion"),
         RAMURE_NOOP("The angle between an axis and the shoots that leave it.")},
        ParamUnit::Radian, {0, 2.6, pi / 9, pi / 2, pi / 180, 4}),
    grownRow<&GrowthParams::whorl>(
        {"growth.whorl", shootsGroup, RAMURE_NOOP("Limbs of a whorl"),
         RAMURE_NOOP("How many limbs stand around the end of each year's shoot of the trunk, as of pines and spruces. 0: none do.")},
        ParamUnit::Count, {0, 8, 0, 8, 1, 0}),
    grownRow<&GrowthParams::endBuds>(
        {"growth.endBuds", shootsGroup, RAMURE_NOOP("Buds at the end"),
         RAMURE_NOOP("How many side buds stand around the end of each year's shoot.")},
        ParamUnit::Count, {1, 8, 1, 5, 1, 0}, paramAdvanced, hasNoWhorl),
    grownRow<&GrowthParams::acrotony>(
        {"growth.acrotony", shootsGroup, RAMURE_NOOP("Acrotony"),
         RAMURE_NOOP("Which buds of a year's shoot grow: 0 all alike, 1 only those near its end.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::branching>(
        {"growth.branching", shootsGroup, RAMURE_NOOP("Branching"),
         RAMURE_NOOP("How much of the vigour goes into side shoots: low makes long whips, high makes bushy twigs.")},
        ParamUnit::Factor, {0, 2, 0.2, 1.5, 0.05, 2}),
    grownRow<&GrowthParams::shortShoots>(
        {"growth.shortShoots", shootsGroup, RAMURE_NOOP("Short shoots"),
         RAMURE_NOOP("How weak a bud may be and still make a short shoot: 0 none does, 1 all do.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::orders>(
        {"growth.orders", shootsGroup, RAMURE_NOOP("Orders"),
         RAMURE_NOOP("How many orders of axes there may be: trunk, limbs, boughs and so on.")},
        ParamUnit::Count, {1, 12, 2, 10, 1, 0}, paramAdvanced),

    grownRow<&GrowthParams::sees>(
        {"growth.sees", lightGroup, RAMURE_NOOP("Buds see"),
         RAMURE_NOOP("The resource that buds compete for. Light: the part of the sky that no leaves above hide. Room: free space in the crown, or in the solid that the tree fills.")},
        ParamUnit::None, {}, paramAdvanced),
    grownRow<&GrowthParams::shadeTolerance>(
        {"growth.shadeTolerance", lightGroup, RAMURE_NOOP("Shade tolerance"),
         RAMURE_NOOP("0: a light crown of few layers, as of birches and pines. 1: a deep and dense one, as of beeches and spruces.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::shedding>(
        {"growth.shedding", lightGroup, RAMURE_NOOP("Shedding"),
         RAMURE_NOOP("How soon branches in the shade fall: 0 they stay, 1 they go at once.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::deadWood>(
        {"growth.deadWood", lightGroup, RAMURE_NOOP("Standing dead wood"),
         RAMURE_NOOP("How long branches stand that died in the shade. 0: they fall at once. 1: twigs stay three years, a limb of 10 cm thirteen, "
                     "and break off from their ends.")},
        ParamUnit::Factor, {0, 5, 0, 2, 0.1, 2}),
    grownRow<&GrowthParams::light>(
        {"growth.light", lightGroup, RAMURE_NOOP("Towards the light"),
         RAMURE_NOOP("How much shoots turn to where the light comes from; how much the stem of a palm bends to it and away from solids.")},
        ParamUnit::Factor, {0, 2, 0, 1, 0.05, 2}, paramNone, growsByYears),
    grownRow<&GrowthParams::sunlight>(
        {"growth.sunlight", lightGroup, RAMURE_NOOP("Sunlight"),
         RAMURE_NOOP("Light, as a share of the open sky's. With too little the tree dies.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}, paramAdvanced, growsByYears),

    grownRow<&GrowthParams::wind>(
        {"growth.wind", siteGroup, RAMURE_NOOP("Wind"),
         RAMURE_NOOP("Mean wind in metres per second while the tree grows: 2 in a sheltered garden, 5 in open country, 8 on a coast, 12 on a ridge. "
                     "Buds on the windward side dry out, shoots turn to leeward, and the tree stays low.")},
        ParamUnit::None, {0, 30, 0, 15, 0.5, 2}),
    grownRow<&GrowthParams::windDirection>(
        {"growth.windDirection", siteGroup, RAMURE_NOOP("Prevailing wind"),
         RAMURE_NOOP("Direction that the wind blows to in most years, as a turn about the vertical axis: 0 along X, a quarter turn against Z.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, -pi, pi, 0.05, 4}),
    grownRow<&GrowthParams::sideLight>(
        {"growth.sideLight", siteGroup, RAMURE_NOOP("Light from one side"),
         RAMURE_NOOP("0: light comes from all around. 1: from one side only, as at the edge of a wood or before a wall.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}, paramNone, growsByYears),
    grownRow<&GrowthParams::lightDirection>(
        {"growth.lightDirection", siteGroup, RAMURE_NOOP("Side of the light"),
         RAMURE_NOOP("The side that the light comes from, as a turn about the vertical axis: 0 along X, a quarter turn against Z.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, -pi, pi, 0.05, 4}, paramNone, growsByYears),
    grownRow<&GrowthParams::slope>(
        {"growth.slope", siteGroup, RAMURE_NOOP("Slope"),
         RAMURE_NOOP("How steep the ground is. Limbs keep above it, roots follow it, and the crown grows to the open side, downhill.")},
        ParamUnit::Radian, {0, 1.4, 0, 1, 0.02, 4}, paramNone, growsByYears),
    grownRow<&GrowthParams::slopeDirection>(
        {"growth.slopeDirection", siteGroup, RAMURE_NOOP("Downhill"),
         RAMURE_NOOP("Direction in which the ground falls, as a turn about the vertical axis: 0 along X, a quarter turn against Z.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, -pi, pi, 0.05, 4}, paramNone, growsByYears),
    grownRow<&GrowthParams::lean>(
        {"growth.lean", siteGroup, RAMURE_NOOP("Lean at the ground"),
         RAMURE_NOOP("How far the seedling leans downhill. Later years' shoots turn up again, which leaves a curved foot.")},
        ParamUnit::Radian, {0, 1.4, 0, 1, 0.02, 4}),
    grownRow<&GrowthParams::neighbours>(
        {"growth.neighbours", siteGroup, RAMURE_NOOP("Neighbours"),
         RAMURE_NOOP("Other growing trees of the scene shade this one. All were planted in the same year, and each keeps the space that is nearer to its own stem.")},
        ParamUnit::None, {}),

    grownRow<&GrowthParams::apicalControl>(
        {"growth.apicalControl", habitGroup, RAMURE_NOOP("Apical control"),
         RAMURE_NOOP("How far limbs keep one axis each: 0 they fork evenly, 1 they are straight with short side shoots.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::sideLength>(
        {"growth.sideLength", habitGroup, RAMURE_NOOP("Length of side shoots"),
         RAMURE_NOOP("The longest shoots of an order of axes, as a share of those of the order before.")},
        ParamUnit::Share, {0.1, 1, 0.3, 1, 0.05, 2}),
    grownRow<&GrowthParams::autonomy>(
        {"growth.autonomy", habitGroup, RAMURE_NOOP("Autonomy of limbs"),
         RAMURE_NOOP("How much shoots grow out of their own leaves: 0 all vigour is shared out from the roots, 1 each limb is a tree of its own.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}, paramAdvanced),
    grownRow<&GrowthParams::vigour>(
        {"growth.vigour", habitGroup, RAMURE_NOOP("Vigour is shared"),
         RAMURE_NOOP("At forks: each fork shares by the light above it (Borchert and Honda). By rank: along each axis, so that few buds get most of it.")},
        ParamUnit::None, {}, paramAdvanced),
    grownRow<&GrowthParams::sympodial>(
        {"growth.sympodial", habitGroup, RAMURE_NOOP("Sympodial"),
         RAMURE_NOOP("How likely an apex dies or flowers in a year, so that side buds go on, as of horse chestnuts and magnolias. A trunk that leads keeps its own.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::reiteration>(
        {"growth.reiteration", habitGroup, RAMURE_NOOP("Reiteration"),
         RAMURE_NOOP("How likely in a year a dormant bud in the light begins a tree anew, as on old oaks.")},
        ParamUnit::Share, {0, 1, 0, 0.1, 0.005, 3}, paramAdvanced),
    grownRow<&GrowthParams::upright>(
        {"growth.upright", habitGroup, RAMURE_NOOP("Upright"),
         RAMURE_NOOP("How much shoots turn upwards; below 0, downwards.")},
        ParamUnit::Factor, {-1, 1, -0.5, 0.8, 0.05, 2}),
    grownRow<&GrowthParams::weeping>(
        {"growth.weeping", habitGroup, RAMURE_NOOP("Weeping"),
         RAMURE_NOOP("How much the shoots of higher orders hang.")},
        ParamUnit::Factor, {0, 2, 0, 1.5, 0.05, 2}),
    grownRow<&GrowthParams::plagiotropy>(
        {"growth.plagiotropy", habitGroup, RAMURE_NOOP("Flat limbs"),
         RAMURE_NOOP("How flat side shoots stay, in tiers as of beeches, firs and cedars.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::wander>(
        {"growth.wander", habitGroup, RAMURE_NOOP("Crookedness"),
         RAMURE_NOOP("How much chance turns each internode; how far the stem of a palm leans.")},
        ParamUnit::Factor, {0, 2, 0, 1, 0.05, 2}, paramNone, growsByYears),

    grownRow<&GrowthParams::pipeExponent>(
        {"growth.pipeExponent", woodGroup, RAMURE_NOOP("Pipe exponent"),
         RAMURE_NOOP("Exponent with which the diameters of a branch's twigs add up to its own: 2 keeps the area of the wood, 3 makes slender trunks.")},
        ParamUnit::None, {1.5, 4, 1.8, 3, 0.05, 2}),
    grownRow<&GrowthParams::tipRadius>(
        {"growth.tipRadius", woodGroup, RAMURE_NOOP("Radius of twigs"),
         RAMURE_NOOP("Thickness of a shoot in its first year. The whole tree gets thicker with it.")},
        ParamUnit::Metre, {0.0001, 0.1, 0.001, 0.01, 0.0005, 4}),
    grownRow<&GrowthParams::girth>(
        {"growth.girth", woodGroup, RAMURE_NOOP("Girth of the lost"),
         RAMURE_NOOP("How much of the wood that carried shed branches the stem keeps: thick trunks below open crowns.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}, paramAdvanced),
    grownRow<&GrowthParams::droop>(
        {"growth.droop", woodGroup, RAMURE_NOOP("Sag of the years"),
         RAMURE_NOOP("Share of the bend under each year's new weight that stays.")},
        ParamUnit::Factor, {0, 2, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::reaction>(
        {"growth.reaction", woodGroup, RAMURE_NOOP("Reaction wood"),
         RAMURE_NOOP("How soon leaning shoots turn up again.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}, paramAdvanced),

    grownRow<&GrowthParams::scars>(
        {"growth.scars", barkMarksGroup, RAMURE_NOOP("Scars"),
         RAMURE_NOOP("How many of the limbs that fell or were cut leave a scar, if they were thicker than 2 cm. Bark rolls over the wound "
                     "as the wood thickens, and the eye that is left flattens out. A triangle budget leaves out the smallest.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}),
    grownRow<&GrowthParams::hollows>(
        {"growth.hollows", barkMarksGroup, RAMURE_NOOP("Hollows"),
         RAMURE_NOOP("How many of the scars over 8 cm have rotted into a hollow, which never closes.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.05, 2}, paramNone, hasScars),
    grownRow<&GrowthParams::burrs>(
        {"growth.burrs", barkMarksGroup, RAMURE_NOOP("Burrs"),
         RAMURE_NOOP("How many burrs swell on ten metres of the trunk and of limbs, as on old oaks, lindens and walnuts.")},
        ParamUnit::None, {0, 20, 0, 5, 0.1, 2}),

    grownRow<&GrowthParams::fronds>(
        {"growth.fronds", palmGroup, RAMURE_NOOP("Fronds a year"),
         RAMURE_NOOP("How many fronds open in a year of the grown palm. The crown carries as many as open within the life of one.")},
        ParamUnit::Count, {1, 60, 2, 24, 1, 0}, paramNone, isPalm),
    grownRow<&GrowthParams::frondLength>(
        {"growth.frondLength", palmGroup, RAMURE_NOOP("Length of fronds"),
         RAMURE_NOOP("Length of a frond from the stem to the tip, on the grown palm. Fronds of a seedling have a fifth of it.")},
        ParamUnit::Metre, {0.05, 25, 1, 8, 0.1, 2}, paramNone, isPalm),
    grownRow<&GrowthParams::frondYears>(
        {"growth.frondYears", palmGroup, RAMURE_NOOP("Life of fronds"),
         RAMURE_NOOP("Years from the day a frond opens until it falls.")},
        ParamUnit::Year, {0.2, 10, 1, 5, 0.1, 2}, paramNone, isPalm),
    grownRow<&GrowthParams::stemRadius>(
        {"growth.stemRadius", palmGroup, RAMURE_NOOP("Radius of the stem"),
         RAMURE_NOOP("Above its swollen foot. The stem of a palm has its width before it rises, and keeps it.")},
        ParamUnit::Metre, {0.005, 2, 0.05, 0.6, 0.01, 3}, paramNone, isPalm),
    grownRow<&GrowthParams::fruit>(
        {"growth.fruit", palmGroup, RAMURE_NOOP("Fruit of a bunch"),
         RAMURE_NOOP("How many a bunch carries, in the axil of every other frond. They swell within a year. 0: none.")},
        ParamUnit::Count, {0, 60, 0, 20, 1, 0}, paramNone, isPalm),
};
// clang-format on

} // namespace ramure::rows
