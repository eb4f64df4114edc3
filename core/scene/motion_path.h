/// \file
/// The way of a node through the world: where its origin is at every frame of a range, and at its keys.
#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace ramure {

/// The inputs of a node's path: the node itself and its ancestors, from the top down. Cheap to copy and to
/// compare; tracks are shared.
struct MotionChain
{
    struct Link
    {
        PlacementParams placement;
        NodeAnimation animation;
        bool operator==(const Link&) const = default;
    };
    std::vector<Link> links;
    bool operator==(const MotionChain&) const = default;

    /// The node's matrix at a time, world.
    [[nodiscard]] glm::dmat4 worldAt(double seconds) const;
    /// A link has a track of its transform.
    [[nodiscard]] bool moves() const;
};
/// Empty where there is no such node.
MotionChain motionChain(const Scene& scene, NodeId node);

struct MotionPath
{
    std::int64_t firstFrame = 0;
    std::vector<glm::dvec3> points; ///< one per frame, world
    std::vector<glm::dvec3> keys;   ///< at the keys' own times within the range, in order of time
};

/// More frames than this are left out, at the end.
inline constexpr std::int64_t mostPathFrames = 200'000;

/// The frames of the timeline's range. Error: Cancelled.
Expected<MotionPath> motionPath(const MotionChain& chain, const TimelineSettings& timeline,
                                const Progress& progress = {});

} // namespace ramure
