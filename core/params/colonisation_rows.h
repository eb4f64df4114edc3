/// \file
/// Rows of the generator that colonises space. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"
#include "core/params/source_facts.h"

namespace ramure::rows {

inline constexpr Condition* colonises = [](const NodeParams& p) {
    return p.generator.kind == EditOperation::Colonisation;
};

inline constexpr SourceFacts colonisationFacts{
    EditOperation::Colonisation, "colonisation.points",
    [](const NodeParams& p) { return 0.015 * crownTop(p.colonisation); },
    [](const NodeParams& p) { return p.colonisation.crownRadius; },
    [](const NodeParams& p) {
        return p.colonisation.envelope == CrownEnvelope::Solid ? SolidUse::Needs : SolidUse::Around;
    }};

inline constexpr const char* crownGroup = RAMURE_NOOP("Crown");
inline constexpr const char* colonisationGroup = RAMURE_NOOP("Space colonisation");

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
template <auto Member>
constexpr ParamDef crownRow(const Words& words, ParamUnit unit, const Range& range, std::uint16_t flags = paramNone)
{
    return row<&NodeParams::colonisation, Member>(words, unit, range, Stage::Skeleton, flags, treeOnly, colonises);
}

inline constexpr std::array colonisationRows{
    crownRow<&ColonisationParams::envelope>(
        {"colonisation.envelope", crownGroup, RAMURE_NOOP("Envelope"),
         RAMURE_NOOP("The solid that the crown fills, round about the trunk; or solids of the scene, which stand below the tree and "
                     "say that trees fill them.")},
        ParamUnit::None, {}),
    crownRow<&ColonisationParams::profile>(
        {"colonisation.profile", crownGroup, RAMURE_NOOP("Profile"),
         RAMURE_NOOP("The outline of the crown: pairs of height and radius, as shares of the crown's, \"0 0.3, 0.5 1, 1 0\". A "
                     "smooth curve goes through them.")},
        ParamUnit::None, {}, paramProfile),
    crownRow<&ColonisationParams::crownBase>(
        {"colonisation.crownBase", crownGroup, RAMURE_NOOP("Begins at"),
         RAMURE_NOOP("How high above the ground the crown begins: the bare trunk.")},
        ParamUnit::Metre, {0, 1000, 0, 15, 0.1, 3}),
    crownRow<&ColonisationParams::crownHeight>(
        {"colonisation.crownHeight", crownGroup, RAMURE_NOOP("Height of the crown"),
         RAMURE_NOOP("From where the crown begins to its top.")},
        ParamUnit::Metre, {1e-3, 1000, 0.5, 30, 0.1, 3}),
    crownRow<&ColonisationParams::crownRadius>(
        {"colonisation.crownRadius", crownGroup, RAMURE_NOOP("Radius of the crown"),
         RAMURE_NOOP("Half the greatest width of the crown.")},
        ParamUnit::Metre, {1e-3, 1000, 0.2, 15, 0.1, 3}),
    crownRow<&ColonisationParams::points>(
        {"colonisation.points", colonisationGroup, RAMURE_NOOP("Points"),
         RAMURE_NOOP("Places in the crown that branches grow to reach. More of them give finer and more crowded twigs.")},
        ParamUnit::Count, {1, 1'000'000, 100, 10'000, 50, 0}),
    crownRow<&ColonisationParams::surface>(
        {"colonisation.surface", colonisationGroup, RAMURE_NOOP("To the surface"),
         RAMURE_NOOP("0 spreads the points through the whole crown, 1 lays them all on its surface, where the light is.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}),
    crownRow<&ColonisationParams::influence>(
        {"colonisation.influence", colonisationGroup, RAMURE_NOOP("Sight"),
         RAMURE_NOOP("How far a branch sees points. Far sight gives long calm limbs, short sight restless ones.")},
        ParamUnit::Metre, {1e-3, 1000, 0.2, 5, 0.05, 3}),
    crownRow<&ColonisationParams::kill>(
        {"colonisation.kill", colonisationGroup, RAMURE_NOOP("Reached within"),
         RAMURE_NOOP("A point so near to a branch is reached and draws nothing any more. Small values give dense twigs, large "
                     "ones a sparse crown.")},
        ParamUnit::Metre, {1e-3, 1000, 0.05, 2, 0.01, 3}),
    crownRow<&ColonisationParams::step>(
        {"colonisation.step", colonisationGroup, RAMURE_NOOP("Growth at once"),
         RAMURE_NOOP("Length of the piece that a branch grows before it looks for points again.")},
        ParamUnit::Metre, {1e-3, 100, 0.05, 1, 0.01, 3}),
    crownRow<&ColonisationParams::tropism>(
        {"colonisation.tropism", colonisationGroup, RAMURE_NOOP("Tropism"),
         RAMURE_NOOP("Direction that attracts branches in addition to the points: up to the light, or down. A longer arrow attracts more.")},
        ParamUnit::None, {-100, 100, -1, 1, 0.05, 3}),
    crownRow<&ColonisationParams::exponent>(
        {"colonisation.exponent", colonisationGroup, RAMURE_NOOP("Radii add as"),
         RAMURE_NOOP("At a fork, the branches' radii to this power add up: 2 gives stout trunks, 3 slender ones.")},
        ParamUnit::None, {1, 6, 2, 3, 0.05, 3}),
    crownRow<&ColonisationParams::tipRadius>(
        {"colonisation.tipRadius", colonisationGroup, RAMURE_NOOP("Radius of tips"),
         RAMURE_NOOP("Radius of every twig at its end. All others follow from it.")},
        ParamUnit::Metre, {1e-5, 10, 0.001, 0.05, 0.001, 4}),
    crownRow<&ColonisationParams::thinning>(
        {"colonisation.thinning", colonisationGroup, RAMURE_NOOP("Shortest twig"),
         RAMURE_NOOP("Side twigs that end before this length are left out.")},
        ParamUnit::Metre, {0, 100, 0, 1, 0.01, 3}),
    crownRow<&ColonisationParams::smoothing>(
        {"colonisation.smoothing", colonisationGroup, RAMURE_NOOP("Smoothness"),
         RAMURE_NOOP("0 leaves every kink that growth made, 1 straightens them into curves.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}),
};
// clang-format on

} // namespace ramure::rows
