/// \file
/// The moving state of a scene at one frame: immutable, shared, made on the player's thread. Views hold it as
/// long as they draw it.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/evaluate/node_motion.h"
#include "core/pipeline/tree_pipeline.h"
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace ramure {

/// An object, a terrain or an arm whose parameters have tracks, as it is now.
struct ObjectNow
{
    std::shared_ptr<const TriangleMesh> mesh; ///< null if the node has its usual mesh
    SurfaceParams surface;
    std::optional<glm::dvec3> target; ///< for arms: m, their own space
};

struct MotionFrame
{
    std::int64_t frame = 0;
    double timeSeconds = 0.0;
    int document = 0; ///< number of the document, counted by the player
    std::map<NodeId, NodeMotion> nodes;
    /// The place of every node at this frame; empty if nothing in the scene has a track.
    std::unordered_map<NodeId, NodeTransforms> transforms;
    std::map<NodeId, ObjectNow> objects;
    /// Trees whose shape has tracks, as they are now: in the place of the document's results.
    std::map<NodeId, TreeResult> trees;

    [[nodiscard]] const NodeMotion* of(NodeId node) const
    {
        const auto found = nodes.find(node);
        return found == nodes.end() ? nullptr : &found->second;
    }
    /// Returns the transform of a node's own geometry.
    [[nodiscard]] glm::dmat4 geometryOf(const Scene& scene, NodeId node) const
    {
        const auto found = transforms.find(node);
        return found == transforms.end() ? EvaluatedScene(scene, timeSeconds).transforms(node).geometry
                                         : found->second.geometry;
    }
};

enum class FrameState : std::uint8_t {
    Missing, ///< must be computed
    Stale,   ///< was computed for other parameters
    Cached,  ///< comes at once
};

/// The state of baked motion beside the project.
enum class BakeState : std::uint8_t {
    None,  ///< no baked motion
    Good,  ///< made from the present trees and parameters: its frames come at once
    Stale, ///< at least one file is of another tree or other parameters, or cannot be used: it is not
};

/// Frames first .. last of one state, for the band under the timeline's ruler.
struct FrameRange
{
    std::int64_t first = 0, last = 0;
    FrameState state = FrameState::Missing;
    bool operator==(const FrameRange&) const = default;
};

} // namespace ramure
