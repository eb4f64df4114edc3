/// \file
/// Random values, nodes and scenes, made from the parameter table.
#pragma once

#include "core/math/random.h"
#include "core/params/param_def.h"
#include "core/scene/growth_spaces.h"
#include "core/scene/scene.h"

#include <algorithm>

namespace ramure::test {

inline std::string randomText(Random& random, bool multiline)
{
    static const std::array<std::string, 12> pieces{"A", "->", "[",  "]", "\\",   "\"",
                                                    "é", "树", "{}", " ", "0.5:", "\t"};
    std::string text;
    for (std::uint32_t i = random.below(20); i-- > 0;)
        text += multiline && random.below(6) == 0 ? "\n" : pieces[random.below(pieces.size())];
    return text;
}

inline double randomReal(const ParamDef& def, Random& random)
{
    const double low = std::max(def.hardMin, -1e6), high = std::min(def.hardMax, 1e6);
    switch (random.below(4)) {
    case 0:
        return def.hardMin;
    case 1:
        return std::clamp(std::round(random.range(low, high)), low, high);
    default:
        return random.range(low, high);
    }
}

/// Any value that the row allows.
inline ParamValue randomValue(const ParamDef& def, Random& random)
{
    switch (def.type) {
    case ParamType::Bool:
        return random.below(2) == 1;
    case ParamType::Int:
        return static_cast<std::int64_t>(randomReal(def, random));
    case ParamType::Real:
        return randomReal(def, random);
    case ParamType::Text:
        if ((def.flags & paramPicture) != 0) // as a project that was loaded has them
            return "/pictures/" + std::to_string(random.below(99)) + ".png";
        return randomText(random, (def.flags & paramMultiline) != 0);
    case ParamType::Vec3:
        return glm::dvec3{randomReal(def, random), randomReal(def, random), randomReal(def, random)};
    case ParamType::Enum:
        return EnumValue{def.items[random.below(static_cast<std::uint32_t>(def.items.size()))].name};
    }
    return false;
}

inline AnyTrack randomTrack(const Channel& channel, Random& random)
{
    const auto fill = [&random](auto track, auto&& value) {
        for (std::uint32_t i = 1 + random.below(5); i-- > 0;) {
            typename decltype(track)::KeyKind key;
            key.time = ticksOf(random.range(-100.0, 100.0));
            key.value = value();
            key.mode = static_cast<KeyMode>(random.below(keyModeCount));
            key.easing = static_cast<Easing>(random.below(easingCount));
            key.before = static_cast<HandleType>(random.below(handleTypeCount));
            key.behind = static_cast<HandleType>(random.below(handleTypeCount));
            key.period = random.range(0.0, 2.0);
            [[maybe_unused]] const auto done = track.insert(key);
        }
        track.before = static_cast<Extrapolation>(random.below(extrapolationCount));
        track.behind = static_cast<Extrapolation>(random.below(extrapolationCount));
        track.loop = random.below(2) == 0 ? 0 : 5 * ticksPerSecond;
        track.settleEnds();
        return AnyTrack(track);
    };
    const auto number = [&random] { return random.range(-1.0, 1.0); };
    if (channel.isOrientation())
        return fill(OrientationTrack(), [&] { return glm::dquat(number(), number(), number(), 1.0); });
    return fill(Track(), number);
}

inline Node randomNode(NodeId id, NodeId parent, Random& random)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = static_cast<NodeKind>(random.below(nodeKindCount));
    node.name = randomText(random, true);
    if (random.below(3) == 0)
        node.preset = random.below(2) == 0 ? "FanTree" : randomText(random, false);
    node.visible = random.below(4) != 0;
    node.locked = random.below(8) == 0;
    for (const ParamDef& def : paramTable())
        if (hasParam(node.kind, def) && random.below(3) == 0)
            def.assign(node.params, randomValue(def, random));
    for (std::uint32_t i = node.kind == NodeKind::Tree ? random.below(4) : 0; i-- > 0;) {
        TreeEdit step{.id = random.next() | 1,
                      .operation = random.below(2) == 0 ? EditOperation::Roll : EditOperation::Bend,
                      .target = {.address = random.next() | 1},
                      .from = random.range(0.0, 1.0)};
        (step.operation == EditOperation::Roll ? step.angleRad : step.rotation.y) = random.range(-7.0, 7.0);
        node.params.edits.push_back(step);
    }
    for (const Channel& channel : channelsOf(node.kind))
        if (random.below(10) == 0)
            node.animation.set(channel, randomTrack(channel, random));
    if (node.kind == NodeKind::Arm && random.below(2) == 0) {
        node.params.joints.resize(1 + random.below(5));
        for (ArmJoint& joint : node.params.joints) {
            joint.length = random.range(0.1, 3.0);
            joint.phi = {random.range(-3.0, 3.0), random.below(2) == 0, -1.0, random.range(-1.0, 2.0), 0.5};
            joint.theta.angleRad = random.range(-3.0, 3.0);
        }
    }
    if (node.kind == NodeKind::Mesh) {
        TriangleMesh mesh;
        for (int i = 0; i < 3; ++i)
            mesh.positions.emplace_back(float(random.range(-1.0, 1.0)), float(i), 0.5f);
        mesh.triangles.emplace_back(0u, 1u, 2u);
        node.mesh = SharedValue<TriangleMesh>(std::move(mesh));
    }
    if (random.below(4) == 0)
        node.extras = R"({"future":[1,{"deep":0.1}],"params":{"snow.depth":0.25}})";
    return node;
}

inline Scene randomScene(Random& random, std::uint32_t most = 12)
{
    Scene scene;
    for (std::uint32_t i = random.below(most + 1); i-- > 0;) {
        const auto count = static_cast<std::uint32_t>(scene.nodes().size());
        const std::uint32_t under = random.below(count + 1);
        const NodeId parent = under == count ? noNode : scene.nodes()[under].id;
        const NodeId id = scene.newId() + random.below(3);
        [[maybe_unused]] const auto done =
            scene.insert({randomNode(id, parent, random)}, parent, static_cast<int>(random.below(5)));
    }
    linkGrowthSpaces(scene);
    return scene;
}

} // namespace ramure::test
