/// \file
/// The items of each enumeration among the parameters, in the order of its values. Of the rows and
/// param_relevance.cpp.
#pragma once

#include "core/params/param_def.h"
#include <algorithm>
#include <array>

namespace ramure {

template <class T> inline constexpr std::array<EnumItem, 0> itemsOf{};
template <>
inline constexpr std::array itemsOf<GrammarDialect>{
    EnumItem{"classic", RAMURE_NOOP("Letters")}, EnumItem{"parametric", RAMURE_NOOP("Modules with numbers")}};

/// Kinds of steps that a recipe can begin with: sources, and last the drawn axes.
inline constexpr auto firstSources = [] {
    constexpr auto isFirst = [](const EditOperationInfo& kind) { return *kind.first.name != '\0'; };
    std::array<EditOperation, std::ranges::count_if(stepKinds, isFirst)> sources{};
    std::size_t count = 0;
    for (const bool grows : {true, false})
        for (const EditOperationInfo& kind : stepKinds)
            if (isFirst(kind) && grows == (kind.group == StepGroup::Source))
                sources[count++] = kind.operation;
    return sources;
}();
template <>
inline constexpr auto itemsOf<EditOperation> = [] {
    std::array<EnumItem, firstSources.size()> items{};
    for (std::size_t i = 0; i < items.size(); ++i)
        items[i] = stepKinds[static_cast<std::size_t>(firstSources[i])].first;
    return items;
}();
template <>
inline constexpr std::array itemsOf<GrowthHabit>{EnumItem{"branching", RAMURE_NOOP("Branching")},
                                                 EnumItem{"palm", RAMURE_NOOP("Palm")}};
template <>
inline constexpr std::array itemsOf<Phyllotaxis>{EnumItem{"spiral", RAMURE_NOOP("Spiral")},
                                                 EnumItem{"opposite", RAMURE_NOOP("Opposite")},
                                                 EnumItem{"alternate", RAMURE_NOOP("Alternate")}};
template <>
inline constexpr std::array itemsOf<GrowthLight>{EnumItem{"light", RAMURE_NOOP("Light")},
                                                 EnumItem{"space", RAMURE_NOOP("Room")}};
template <>
inline constexpr std::array itemsOf<VigourModel>{EnumItem{"borchert_honda", RAMURE_NOOP("At forks")},
                                                 EnumItem{"priority", RAMURE_NOOP("By rank")}};
template <>
inline constexpr std::array itemsOf<StandWay>{
    EnumItem{"ground", RAMURE_NOOP("On the ground")}, EnumItem{"limbs", RAMURE_NOOP("Limbs along axes")},
    EnumItem{"along", RAMURE_NOOP("Whole, along axes")}, EnumItem{"tips", RAMURE_NOOP("Whole, at tips")}};
template <>
inline constexpr std::array itemsOf<CrownEnvelope>{
    EnumItem{"sphere", RAMURE_NOOP("Sphere")},   EnumItem{"hemisphere", RAMURE_NOOP("Hemisphere")},
    EnumItem{"cone", RAMURE_NOOP("Cone")},       EnumItem{"cylinder", RAMURE_NOOP("Cylinder")},
    EnumItem{"profile", RAMURE_NOOP("Profile")}, EnumItem{"solid", RAMURE_NOOP("Solid of the scene")}};
template <>
inline constexpr std::array itemsOf<GrowthRole>{EnumItem{"none", RAMURE_NOOP("Are not concerned")},
                                                EnumItem{"envelope", RAMURE_NOOP("Fill it")},
                                                EnumItem{"obstacle", RAMURE_NOOP("Grow around it")}};
template <>
inline constexpr std::array itemsOf<CrownShape>{
    EnumItem{"conical", RAMURE_NOOP("Conical")},
    EnumItem{"spherical", RAMURE_NOOP("Spherical")},
    EnumItem{"hemispherical", RAMURE_NOOP("Hemispherical")},
    EnumItem{"cylindrical", RAMURE_NOOP("Cylindrical")},
    EnumItem{"taperedCylindrical", RAMURE_NOOP("Tapered cylinder")},
    EnumItem{"flame", RAMURE_NOOP("Flame")},
    EnumItem{"inverseConical", RAMURE_NOOP("Inverse cone")},
    EnumItem{"tendFlame", RAMURE_NOOP("Nearly a flame")},
    EnumItem{"envelope", RAMURE_NOOP("Pruning envelope")}};
template <>
inline constexpr std::array itemsOf<PhysicsMode>{EnumItem{"faithful", RAMURE_NOOP("Faithful")},
                                                 EnumItem{"robust", RAMURE_NOOP("Robust")}};
template <>
inline constexpr std::array itemsOf<RestFrame>{EnumItem{"world", RAMURE_NOOP("World")},
                                               EnumItem{"parent", RAMURE_NOOP("Parent")}};
template <>
inline constexpr std::array itemsOf<SkinMethod>{EnumItem{"rigid", RAMURE_NOOP("Rigid")},
                                                EnumItem{"linear", RAMURE_NOOP("Linear blend")},
                                                EnumItem{"dualQuaternion", RAMURE_NOOP("Dual quaternion")}};

template <>
inline constexpr std::array itemsOf<BarkFamily>{
    EnumItem{"plain", RAMURE_NOOP("Plain")},       EnumItem{"smooth", RAMURE_NOOP("Beech")},
    EnumItem{"plated", RAMURE_NOOP("Pine")},       EnumItem{"furrowed", RAMURE_NOOP("Oak")},
    EnumItem{"scaly", RAMURE_NOOP("Spruce")},      EnumItem{"peeling", RAMURE_NOOP("Eucalyptus")},
    EnumItem{"ringed", RAMURE_NOOP("Birch")},      EnumItem{"fibrous", RAMURE_NOOP("Cedar")},
    EnumItem{"mosaic", RAMURE_NOOP("Plane tree")}, EnumItem{"palmScars", RAMURE_NOOP("Palm")},
    EnumItem{"thorny", RAMURE_NOOP("Kapok")},      EnumItem{"corky", RAMURE_NOOP("Cork oak")},
    EnumItem{"bamboo", RAMURE_NOOP("Bamboo")},     EnumItem{"ribbed", RAMURE_NOOP("Cactus")},
    EnumItem{"banded", RAMURE_NOOP("Cherry")},     EnumItem{"palmBoots", RAMURE_NOOP("Date palm")}};

template <>
inline constexpr std::array itemsOf<PrimitiveShape>{
    EnumItem{"cylinder", RAMURE_NOOP("Cylinder")}, EnumItem{"sphere", RAMURE_NOOP("Sphere")},
    EnumItem{"box", RAMURE_NOOP("Box")},           EnumItem{"cone", RAMURE_NOOP("Cone")},
    EnumItem{"plane", RAMURE_NOOP("Plane")},       EnumItem{"frameCross", RAMURE_NOOP("Frame cross")}};
template <>
inline constexpr std::array itemsOf<PrimitiveAxis>{
    EnumItem{"x", RAMURE_NOOP("X")}, EnumItem{"y", RAMURE_NOOP("Y")}, EnumItem{"z", RAMURE_NOOP("Z")}};

template <>
inline constexpr std::array itemsOf<MeshAxis>{
    EnumItem{"longest", RAMURE_NOOP("The longest")}, EnumItem{"x", RAMURE_NOOP("X")},
    EnumItem{"y", RAMURE_NOOP("Y")}, EnumItem{"z", RAMURE_NOOP("Z")}};

template <>
inline constexpr std::array itemsOf<ArmSolverKind>{
    EnumItem{"leastSquares", RAMURE_NOOP("Damped least squares")},
    EnumItem{"transpose", RAMURE_NOOP("Jacobian transpose")}};

template <>
inline constexpr std::array itemsOf<LeafShape>{EnumItem{"faithful", RAMURE_NOOP("Faithful")},
                                               EnumItem{"beech", RAMURE_NOOP("Beech")},
                                               EnumItem{"elm", RAMURE_NOOP("Elm")},
                                               EnumItem{"cherry", RAMURE_NOOP("Cherry")},
                                               EnumItem{"magnolia", RAMURE_NOOP("Magnolia")},
                                               EnumItem{"box", RAMURE_NOOP("Boxwood")},
                                               EnumItem{"birch", RAMURE_NOOP("Birch")},
                                               EnumItem{"apple", RAMURE_NOOP("Apple")},
                                               EnumItem{"aspen", RAMURE_NOOP("Aspen")},
                                               EnumItem{"hazel", RAMURE_NOOP("Hazel")},
                                               EnumItem{"linden", RAMURE_NOOP("Linden")},
                                               EnumItem{"redbud", RAMURE_NOOP("Redbud")},
                                               EnumItem{"willow", RAMURE_NOOP("Willow")},
                                               EnumItem{"olive", RAMURE_NOOP("Olive")},
                                               EnumItem{"eucalyptus", RAMURE_NOOP("Eucalyptus")},
                                               EnumItem{"bamboo", RAMURE_NOOP("Bamboo")},
                                               EnumItem{"grass", RAMURE_NOOP("Grass")},
                                               EnumItem{"maple", RAMURE_NOOP("Maple")},
                                               EnumItem{"japaneseMaple", RAMURE_NOOP("Japanese maple")},
                                               EnumItem{"plane", RAMURE_NOOP("Plane tree")},
                                               EnumItem{"sweetgum", RAMURE_NOOP("Sweetgum")},
                                               EnumItem{"oak", RAMURE_NOOP("Oak")},
                                               EnumItem{"redOak", RAMURE_NOOP("Red oak")},
                                               EnumItem{"hawthorn", RAMURE_NOOP("Hawthorn")},
                                               EnumItem{"ginkgo", RAMURE_NOOP("Ginkgo")},
                                               EnumItem{"fanPalm", RAMURE_NOOP("Fan palm")},
                                               EnumItem{"ash", RAMURE_NOOP("Ash")},
                                               EnumItem{"rowan", RAMURE_NOOP("Rowan")},
                                               EnumItem{"walnut", RAMURE_NOOP("Walnut")},
                                               EnumItem{"robinia", RAMURE_NOOP("Robinia")},
                                               EnumItem{"mimosa", RAMURE_NOOP("Mimosa")},
                                               EnumItem{"horseChestnut", RAMURE_NOOP("Horse chestnut")},
                                               EnumItem{"laburnum", RAMURE_NOOP("Laburnum")},
                                               EnumItem{"fern", RAMURE_NOOP("Fern")},
                                               EnumItem{"palm", RAMURE_NOOP("Palm")},
                                               EnumItem{"yew", RAMURE_NOOP("Yew")},
                                               EnumItem{"fir", RAMURE_NOOP("Fir")},
                                               EnumItem{"spruce", RAMURE_NOOP("Spruce")},
                                               EnumItem{"blueSpruce", RAMURE_NOOP("Blue spruce")},
                                               EnumItem{"cedar", RAMURE_NOOP("Cedar")},
                                               EnumItem{"scotsPine", RAMURE_NOOP("Scots pine")},
                                               EnumItem{"whitePine", RAMURE_NOOP("White pine")},
                                               EnumItem{"larch", RAMURE_NOOP("Larch")},
                                               EnumItem{"cypress", RAMURE_NOOP("Cypress")}};
static_assert(itemsOf<LeafShape>.size() == leafShapeCount);
template <>
inline constexpr std::array itemsOf<FruitKind>{
    EnumItem{"faithful", RAMURE_NOOP("Faithful")}, EnumItem{"apple", RAMURE_NOOP("Apple")},
    EnumItem{"pear", RAMURE_NOOP("Pear")},         EnumItem{"cherry", RAMURE_NOOP("Cherries")},
    EnumItem{"plum", RAMURE_NOOP("Plum")},         EnumItem{"orange", RAMURE_NOOP("Orange")},
    EnumItem{"lemon", RAMURE_NOOP("Lemon")},       EnumItem{"olive", RAMURE_NOOP("Olives")},
    EnumItem{"acorn", RAMURE_NOOP("Acorns")},      EnumItem{"cone", RAMURE_NOOP("Cone")},
    EnumItem{"coconut", RAMURE_NOOP("Coconuts")},  EnumItem{"dates", RAMURE_NOOP("Dates")},
    EnumItem{"berries", RAMURE_NOOP("Berries")},   EnumItem{"blossom", RAMURE_NOOP("Blossom")}};
static_assert(itemsOf<FruitKind>.size() == fruitKindCount);

template <>
inline constexpr std::array itemsOf<SeasonClimate>{EnumItem{"oceanic", RAMURE_NOOP("Oceanic")},
                                                   EnumItem{"continental", RAMURE_NOOP("Continental")},
                                                   EnumItem{"boreal", RAMURE_NOOP("Boreal")}};

template <>
inline constexpr std::array itemsOf<LeafArrangement>{
    EnumItem{"natural", RAMURE_NOOP("As the plant")},   EnumItem{"alternate", RAMURE_NOOP("Alternate")},
    EnumItem{"distichous", RAMURE_NOOP("In two rows")}, EnumItem{"spiral", RAMURE_NOOP("Spiral")},
    EnumItem{"opposite", RAMURE_NOOP("Opposite")},      EnumItem{"decussate", RAMURE_NOOP("Crossed pairs")},
    EnumItem{"whorled", RAMURE_NOOP("Whorled")}};

} // namespace ramure
