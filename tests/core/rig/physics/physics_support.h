/// \file
/// Bodies of the presets and of random trees, for the suites of the physics.
#pragma once

#include "core/math/random.h"
#include "core/params/param_def.h"
#include "core/presets/presets.h"
#include "core/rig/physics/tree_physics.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

namespace ramure::test {

struct MovingTree
{
    Skeleton skeleton;
    Foliage foliage;
    double alpha = 0.2;

    [[nodiscard]] std::shared_ptr<const TreeBody> body(bool withApples = true) const
    {
        return makeTreeBody(skeleton, withApples ? &foliage : nullptr, alpha);
    }
};

inline MovingTree presetTree(std::string_view name)
{
    MovingTree tree;
    const auto skeleton = presetSkeleton({name});
    const auto params = presetParams(name);
    if (!skeleton || !params)
        qFatal("no preset");
    tree.skeleton = *skeleton;
    tree.alpha = params->turtle.alpha;
    tree.foliage = *placeFoliage(tree.skeleton, params->foliage, tree.alpha);
    return tree;
}

/// For data functions: one row per preset, column "name".
inline void addPresetRows()
{
    QTest::addColumn<QByteArray>("name");
    for (const Preset& preset : courseworkPresets())
        QTest::newRow(preset.name) << QByteArray(preset.name);
}

/// Any tree: branches of all lengths and radii, some of no length, some of no thickness; a few apples.
inline MovingTree randomTree(Random& random, std::uint32_t branches)
{
    MovingTree tree;
    tree.skeleton.add(noIndex, glm::dvec3(0.0), glm::dvec3(0.0, random.range(0.1, 3.0), 0.0), 0.2, 0.15);
    while (tree.skeleton.size() < branches) {
        const Index parent = random.below(tree.skeleton.size());
        const double length = random.below(20) == 0 ? 0.0 : std::pow(10.0, random.range(-3.0, 0.5));
        const glm::dvec3 way(random.range(-1, 1), random.range(-1, 1), random.range(-1, 1));
        const double a0 = random.below(20) == 0 ? 0.0 : std::pow(10.0, random.range(-4.0, -0.5));
        const glm::dvec3 from = tree.skeleton.p1[parent];
        tree.skeleton.add(parent, from, from + length * way / (glm::length(way) + 1e-12), a0,
                          a0 * random.unit());
    }
    for (int i = 0; i < 5; ++i) {
        const Index branch = random.below(branches);
        tree.foliage.apples.push_back({branch, tree.skeleton.p1[branch], {1.0, 0.0, 0.0, 0.0}});
    }
    return tree;
}

/// Any values in range, often at the ends of it.
inline PhysicsParams randomPhysics(Random& random)
{
    NodeParams node;
    for (const ParamDef& def : paramTable()) {
        if (!std::string_view(def.key).starts_with("physics."))
            continue;
        const std::uint32_t kind = random.below(5);
        const double number = kind == 0   ? def.hardMin
                              : kind == 1 ? def.hardMax
                              : kind == 2 ? random.range(def.hardMin, def.hardMax)
                                          : random.range(def.softMin, def.softMax);
        if (def.type == ParamType::Real)
            def.assign(node, number);
        else if (def.type == ParamType::Int)
            def.assign(node, static_cast<std::int64_t>(number));
        else if (def.type == ParamType::Bool)
            def.assign(node, random.below(2) == 1);
        else
            def.assign(node,
                       EnumValue{def.items[random.below(static_cast<std::uint32_t>(def.items.size()))].name});
    }
    return node.physics;
}

inline PhysicsParams faithful()
{
    PhysicsParams params;
    params.mode = PhysicsMode::Faithful;
    return params;
}

inline bool allFinite(const PhysicsState& state)
{
    return std::ranges::all_of(state.values, [](double value) { return std::isfinite(value); }) &&
           std::ranges::all_of(state.loose, [](const LooseApple& apple) {
               return std::isfinite(glm::length(apple.position)) &&
                      std::isfinite(glm::length(apple.velocity)) && std::isfinite(glm::length(apple.spin));
           });
}

/// Equal bit by bit: -0 is not 0.
inline bool sameBits(const PhysicsState& a, const PhysicsState& b)
{
    return a == b && a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
}

} // namespace ramure::test
