#include "core/scene/motion_path.h"

#include "core/scene/world_transforms.h"
#include <algorithm>
#include <set>

namespace ramure {

MotionChain motionChain(const Scene& scene, NodeId node)
{
    MotionChain chain;
    for (const Node* link = scene.find(node); link; link = scene.find(link->parent)) {
        MotionChain::Link made{link->params.tree, {}};
        if (link->animation.movesNode()) // tracks of parameters move nothing
            for (const auto& [channel, track] : link->animation.tracks())
                if (channel.part <= ChannelPart::GlobalScale)
                    made.animation.set(channel, track);
        chain.links.push_back(std::move(made));
    }
    std::reverse(chain.links.begin(), chain.links.end());
    // What the node itself shows may stand and move apart from it: that is what is followed with the eye.
    const Node* shown = scene.find(node);
    if (!shown || shown->kind == NodeKind::Group)
        return chain;
    MotionChain::Link own{shown->params.local, {}};
    for (const auto& [channel, track] : shown->animation.tracks())
        if (channel.part >= ChannelPart::LocalTranslation && channel.part <= ChannelPart::LocalScale) {
            Channel same = channel;
            same.part = static_cast<ChannelPart>(int(channel.part) - int(ChannelPart::LocalTranslation));
            own.animation.set(same, track);
        }
    if (own != MotionChain::Link{})
        chain.links.push_back(std::move(own));
    return chain;
}

glm::dmat4 MotionChain::worldAt(double seconds) const
{
    glm::dmat4 world(1.0);
    for (const Link& link : links) {
        if (link.animation.movesNode())
            world = world * transformAt(link.animation, ChannelPart::GlobalTranslation, seconds);
        world = world * placementMatrix(link.placement);
    }
    return world;
}

bool MotionChain::moves() const
{
    return std::any_of(links.begin(), links.end(),
                       [](const Link& link) { return link.animation.movesNode(); });
}

Expected<MotionPath> motionPath(const MotionChain& chain, const TimelineSettings& timeline,
                                const Progress& progress)
{
    constexpr std::size_t between = 256; ///< frames, to looking whether to stop
    MotionPath path;
    path.firstFrame = timeline.firstFrame;
    const std::int64_t frames = std::min(timeline.lastFrame - timeline.firstFrame + 1, mostPathFrames);
    path.points.reserve(static_cast<std::size_t>(std::max<std::int64_t>(frames, 0)));
    for (std::int64_t i = 0; i < frames; ++i) {
        if (path.points.size() % between == 0 && progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        path.points.emplace_back(chain.worldAt(timeline.timeOf(timeline.firstFrame + i))[3]);
    }
    std::set<Ticks> times;
    const Ticks first = ticksOf(timeline.timeOf(timeline.firstFrame));
    const Ticks last = ticksOf(timeline.timeOf(timeline.firstFrame + frames - 1));
    for (const MotionChain::Link& link : chain.links)
        for (const auto& [channel, track] : link.animation.tracks())
            for (std::size_t k = 0; k < keyCount(*track); ++k)
                if (const Ticks time = keyShape(*track, k).time; time >= first && time <= last)
                    times.insert(time);
    for (const Ticks time : times) {
        if (path.keys.size() % between == 0 && progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        path.keys.emplace_back(chain.worldAt(secondsOf(time))[3]);
    }
    return path;
}

} // namespace ramure
