/// \file
/// Scenes with many keys.
#pragma once

#include "core/math/random.h"
#include "core/scene/scene.h"

namespace ramure::test {

/// Groups with ten tracks at most, keys on the frames 0, step, 2 step ... at 24 frames a second.
inline Scene keyScene(int tracks, int keysPerTrack, int step = 1)
{
    Scene scene;
    Random random(7, RandomStream::Test);
    const std::vector<Channel> channels = channelsOf(NodeKind::Primitive);
    for (int made = 0; made < tracks;) {
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Primitive;
        node.name = "Node " + std::to_string(node.id);
        for (std::size_t c = 0; c < 10 && made < tracks; ++c, ++made) {
            const auto fill = [&](auto track, auto&& value) {
                std::vector<typename decltype(track)::KeyKind> keys(static_cast<std::size_t>(keysPerTrack));
                for (std::size_t i = 0; i < keys.size(); ++i) {
                    keys[i].time = ticksOf(double(i) * step / 24.0);
                    keys[i].value = value();
                }
                node.animation.set(channels[c], AnyTrack(*decltype(track)::fromKeys(std::move(keys))));
            };
            if (channels[c].isOrientation())
                fill(OrientationTrack(), [&] {
                    return glm::normalize(
                        glm::dquat(1.0, random.range(-1.0, 1.0), random.range(-1.0, 1.0), 0.0));
                });
            else
                fill(Track(), [&] { return random.range(-1.0, 1.0); });
        }
        [[maybe_unused]] const auto done = scene.insert({node}, noNode, int(scene.nodes().size()));
    }
    return scene;
}

} // namespace ramure::test
