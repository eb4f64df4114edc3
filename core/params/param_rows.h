/// \file
/// How a row of the parameter table is written: where its value is, its words, unit and range. Internal to
/// param_table.cpp and the tables of rows that it joins.
#pragma once

#include "core/math/angle.h"
#include "core/params/param_items.h"

#include <array>
#include <type_traits>
#include <utility>

namespace ramure::rows {

/// Whole numbers up to here survive a round trip through a double, hence through any JSON reader.
inline constexpr double maxSeed = 9007199254740991.0;

struct Words
{
    const char* key;
    const char* group;
    const char* label;
    const char* tooltip;
};

struct Range
{
    double hardMin = 0.0, hardMax = 0.0;
    double softMin = 0.0, softMax = 0.0;
    double step = 0.0;
    int decimals = 0;
};

template <class T> constexpr ParamType typeOf()
{
    static_assert(std::is_enum_v<T> == !itemsOf<T>.empty(), "an enumeration has items");
    if constexpr (std::is_same_v<T, bool>)
        return ParamType::Bool;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return ParamType::Int;
    else if constexpr (std::is_same_v<T, double>)
        return ParamType::Real;
    else if constexpr (std::is_same_v<T, std::string>)
        return ParamType::Text;
    else if constexpr (std::is_enum_v<T>)
        return ParamType::Enum;
    else {
        static_assert(std::is_same_v<T, glm::dvec3>,
                      "a parameter must be one of the alternatives of ParamValue");
        return ParamType::Vec3;
    }
}

/// What a path of members, and of numbers into arrays, leads to.
template <auto First, auto... Rest> constexpr auto& reach(auto& from)
{
    if constexpr (std::is_member_object_pointer_v<decltype(First)>) {
        if constexpr (sizeof...(Rest) == 0)
            return from.*First;
        else
            return reach<Rest...>(from.*First);
    } else {
        return reach<Rest...>(from[First]);
    }
}

/// The way to one value: members, from NodeParams on.
template <auto... Path> struct Field
{
    using Value = std::remove_cvref_t<decltype(reach<Path...>(std::declval<NodeParams&>()))>;
    static ParamValue get(const NodeParams& params)
    {
        if constexpr (std::is_enum_v<Value>)
            return EnumValue{itemsOf<Value>[static_cast<std::size_t>(reach<Path...>(params))].name};
        else
            return ParamValue(reach<Path...>(params));
    }
    static void assign(NodeParams& params, const ParamValue& value)
    {
        if constexpr (std::is_enum_v<Value>) {
            const auto* name = std::get_if<EnumValue>(&value);
            for (std::size_t i = 0; name && i < itemsOf<Value>.size(); ++i)
                if (name->name == itemsOf<Value>[i].name)
                    reach<Path...>(params) = static_cast<Value>(i);
        } else if (const auto* held = std::get_if<Value>(&value))
            reach<Path...>(params) = *held;
    }
};

/// The source of a recipe: not every operation can be one.
template <> struct Field<&NodeParams::generator, &GeneratorParams::kind>
{
    using Value = EditOperation;
    static ParamValue get(const NodeParams& params)
    {
        return EnumValue{stepKinds[static_cast<std::size_t>(params.generator.kind)].first.name};
    }
    static void assign(NodeParams& params, const ParamValue& value)
    {
        const auto* name = std::get_if<EnumValue>(&value);
        for (const EditOperation source : firstSources)
            if (name && name->name == stepKinds[static_cast<std::size_t>(source)].first.name)
                params.generator.kind = source;
    }
};

inline constexpr KindBits treeOnly = kindBit(NodeKind::Tree);
inline constexpr KindBits primitiveOnly = kindBit(NodeKind::Primitive);
inline constexpr KindBits objectKinds = kindBit(NodeKind::Primitive) | kindBit(NodeKind::Mesh);
inline constexpr KindBits armOnly = kindBit(NodeKind::Arm);
inline constexpr KindBits terrainOnly = kindBit(NodeKind::Terrain);
inline constexpr KindBits cameraOnly = kindBit(NodeKind::Camera);
inline constexpr KindBits scatterOnly = kindBit(NodeKind::Scatter);
inline constexpr KindBits everyKind = 0xFFFF;
/// All that have a geometry.
inline constexpr KindBits shapedKinds =
    everyKind & ~kindBit(NodeKind::Group) & ~cameraOnly & ~scatterOnly & ~kindBit(NodeKind::Unknown);

using Condition = bool(const NodeParams&);
inline constexpr Condition* growsByChance = [](const NodeParams& p) { return p.grammar.stochastic; };
inline constexpr Condition* isParametric = [](const NodeParams& p) {
    return p.grammar.dialect == GrammarDialect::Parametric;
};
inline constexpr Condition* usesSeed = [](const NodeParams& p) {
    return p.grammar.stochastic || p.generator.kind != EditOperation::Grammar;
};
inline constexpr Condition* mergesRuns = [](const NodeParams& p) { return p.simplify.enabled; };
inline constexpr Condition* hasNoBudget = [](const NodeParams& p) { return p.mesh.targetTriangles == 0; };
inline constexpr Condition* isFaithful = [](const NodeParams& p) {
    return p.leaf.shape == LeafShape::Faithful;
};
inline constexpr Condition* isOfPlant = [](const NodeParams& p) {
    return p.leaf.shape != LeafShape::Faithful;
};
inline constexpr Condition* isHung = [](const NodeParams& p) { return p.fruit.kind != FruitKind::Faithful; };
inline constexpr Condition* hasRoots = [](const NodeParams& p) { return p.mesh.roots > 0; };
inline constexpr Condition* softensForks = [](const NodeParams& p) { return p.mesh.forkSoftness > 0.0; };

template <auto... Path>
constexpr ParamDef row(const Words& words, ParamUnit unit, const Range& range, Stage stage,
                       std::uint16_t flags = paramNone, KindBits kinds = treeOnly,
                       Condition* matters = nullptr)
{
    using Access = Field<Path...>;
    return {words.key,
            words.group,
            words.label,
            words.tooltip,
            typeOf<typename Access::Value>(),
            unit,
            range.hardMin,
            range.hardMax,
            range.softMin,
            range.softMax,
            range.step,
            range.decimals,
            stage,
            flags,
            kinds,
            &Access::get,
            &Access::assign,
            itemsOf<typename Access::Value>,
            matters};
}

/// One of the image files of a surface: the words are the same for all of them.
template <auto Group, auto Member>
constexpr ParamDef pictureRow(const char* key, const char* group, KindBits kinds = treeOnly)
{
    constexpr auto words = [](auto member) -> std::pair<const char*, const char*> {
        using P = PictureParams;
        if (member == &P::colour)
            return {RAMURE_NOOP("Colour picture"),
                    RAMURE_NOOP("An image file (PNG or JPEG) that is the colour of the surface.")};
        if (member == &P::normal)
            return {RAMURE_NOOP("Normal picture"),
                    RAMURE_NOOP("An image file of the directions in which the surface looks (OpenGL's way: "
                                "green points up).")};
        if (member == &P::roughness)
            return {RAMURE_NOOP("Roughness picture"),
                    RAMURE_NOOP("An image file that says how dull the surface is: white has no highlights.")};
        if (member == &P::height)
            return {RAMURE_NOOP("Height picture"),
                    RAMURE_NOOP("An image file with the height of the surface: white is highest. If there is "
                                "no picture of normals, they are computed from it.")};
        if (member == &P::occlusion)
            return {
                RAMURE_NOOP("Occlusion picture"),
                RAMURE_NOOP(
                    "An image file that says where little light gets to: black is the depth of a crack.")};
        return {RAMURE_NOOP("Opacity picture"),
                RAMURE_NOOP("An image file that cuts the surface out: black parts are invisible.")};
    };
    return row<Group, Member>({key, group, words(Member).first, words(Member).second}, ParamUnit::None, {},
                              Stage::Placement, paramPicture, kinds);
}

inline constexpr const char* generatorGroup = RAMURE_NOOP("Generator");
inline constexpr const char* grammarGroup = RAMURE_NOOP("Grammar");
inline constexpr const char* turtleGroup = RAMURE_NOOP("Turtle");
inline constexpr const char* variationGroup = RAMURE_NOOP("Variation");
inline constexpr const char* simplifyGroup = RAMURE_NOOP("Simplification");
inline constexpr const char* sectionsGroup = RAMURE_NOOP("Cross-sections");
inline constexpr const char* forksGroup = RAMURE_NOOP("Forks");
inline constexpr const char* footGroup = RAMURE_NOOP("Foot");
inline constexpr const char* foliageGroup = RAMURE_NOOP("Foliage");
inline constexpr const char* barkGroup = RAMURE_NOOP("Bark");
inline constexpr const char* barkPicturesGroup = RAMURE_NOOP("Pictures of the bark");
inline constexpr const char* leafPicturesGroup = RAMURE_NOOP("Pictures of the leaves");
inline constexpr const char* fruitPicturesGroup = RAMURE_NOOP("Pictures of the fruit");
inline constexpr const char* surfacePicturesGroup = RAMURE_NOOP("Pictures of the surface");
inline constexpr const char* placementGroup = RAMURE_NOOP("Placement");
inline constexpr const char* localGroup = RAMURE_NOOP("Own shape");
inline constexpr const char* primitiveGroup = RAMURE_NOOP("Primitive");
inline constexpr const char* surfaceGroup = RAMURE_NOOP("Surface");
inline constexpr const char* physicsGroup = RAMURE_NOOP("Physics");
inline constexpr const char* skinGroup = RAMURE_NOOP("Skin");
inline constexpr const char* armGroup = RAMURE_NOOP("Arm");
inline constexpr const char* ikGroup = RAMURE_NOOP("Inverse kinematics");
inline constexpr const char* armSkinGroup = RAMURE_NOOP("Skin of the arm");
inline constexpr const char* terrainGroup = RAMURE_NOOP("Terrain");
inline constexpr const char* cameraGroup = RAMURE_NOOP("Camera");
inline constexpr const char* scatterGroup = RAMURE_NOOP("Scatter");

} // namespace ramure::rows
