/// \file
/// Scenes in which everything moves that can, for tests of what is seen of them at a time.
#pragma once

#include "core/presets/presets.h"
#include "core/rig/tracks/track.h"
#include "core/scene/scene.h"
#include <random>

namespace ramure::test {

/// A random scene: a keyed group with two trees, one in a wind that changes; an arm that follows; a box that
/// turns and grows.
struct RandomScene
{
    static constexpr NodeId group = 1, still = 2, windy = 3, arm = 4, box = 5;

    explicit RandomScene(unsigned seed)
        : random(seed)
    {
    }
    double number(double from, double to) { return std::uniform_real_distribution(from, to)(random); }
    NodeAnimation::TrackPtr track(double from, double to)
    {
        Key first, last;
        first.value = number(from, to);
        last.time = ticksOf(2.0);
        last.value = number(from, to);
        return std::make_shared<const AnyTrack>(*Track::fromKeys({first, last}));
    }
    Node node(NodeId id, NodeKind kind, NodeId parent = noNode)
    {
        Node made;
        made.id = id;
        made.parent = parent;
        made.kind = kind;
        made.name = std::to_string(id);
        if (kind == NodeKind::Tree)
            made.params = *presetParams("TinyTree");
        made.params.bark = {}; // drawn as the mesh that files have, no vertex more
        made.params.tree.translation = {number(-3.0, 3.0), 0.0, number(-3.0, 3.0)};
        made.params.tree.rotation.y = number(-2.0, 2.0);
        made.params.physics.windStrength = number(0.5, 3.0);
        return made;
    }
    Scene make()
    {
        const auto param = [](const char* key, std::uint8_t component = 0) {
            return Channel{ChannelPart::Parameter, component, paramId(*findParam(key))};
        };
        std::vector<Node> nodes{node(group, NodeKind::Group), node(still, NodeKind::Tree, group),
                                node(windy, NodeKind::Tree, group), node(arm, NodeKind::Arm, group),
                                node(box, NodeKind::Primitive)};
        nodes[0].animation.set({ChannelPart::GlobalTranslation, 0, 0}, track(-2.0, 2.0));
        nodes[1].animation.set({ChannelPart::LocalTranslation, 1, 0}, track(-1.0, 1.0));
        nodes[2].animation.set(param("physics.windStrength"), track(0.0, 4.0));
        nodes[3].params.arm.follows = true;
        nodes[3].params.arm.target = {number(0.2, 1.5), number(-1.0, 1.0), number(0.5, 2.0)};
        nodes[3].animation.set(param("arm.target", 1), track(-1.0, 1.0));
        nodes[4].animation.set(param("primitive.radius"), track(0.2, 1.0));
        nodes[4].animation.set({ChannelPart::GlobalTranslation, 2, 0}, track(-2.0, 2.0));
        Scene scene = *Scene::fromNodes(nodes);
        scene.setTimeline({24.0, 0, 47, PlayLoop::Loop, number(0.0, 1.0) < 0.7});
        return scene;
    }

    std::mt19937 random;
};

} // namespace ramure::test
