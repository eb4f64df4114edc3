/// \file
/// Moving, turning and scaling nodes about a common pivot, said in the world and carried out in each node's
/// own values: its placement, or keys of its global track. Pure: scene in, values out.
///
/// A move is exact whatever stands above the node. A turn is exact below rotations, uniform scales and mirror
/// images; below uneven scales, where no rotation and scale can give it, the nearest rotation is taken. A
/// scale along axes that are not the node's own gives each own axis the length it would get, and no shear.
#pragma once

#include "core/scene/scene.h"
#include <array>
#include <optional>

namespace ramure {

enum class TransformSpace : std::uint8_t {
    Local,  ///< the axes of the active node
    Parent, ///< the parent's axes
    World,
};

/// A change in the world about a pivot: first the scale, then the turn, then the move. Usually only one of
/// them is set.
struct WorldTransform
{
    glm::dvec3 pivot{0.0};
    glm::dvec3 move{0.0};                                       ///< m
    glm::dvec3 axis{0.0, 1.0, 0.0};                             ///< unit
    double angleRad = 0.0;                                      ///< right hand
    glm::dmat3 frame{1.0};                                      ///< right angled axes of the scale
    glm::dvec3 factors{1.0};                                    ///< along them
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& world) const; ///< moves a point
};

/// The seven tracks of a node's global transform: translation x y z, orientation, scale x y z.
using GlobalTracks = std::array<NodeAnimation::TrackPtr, 7>;
Channel globalChannel(std::size_t index);
GlobalTracks globalTracks(const NodeAnimation& animation);

/// New values for a node. Both are always set; the one that does not change keeps its value.
struct NodeTransform
{
    PlacementParams placement;
    GlobalTracks tracks;
};

/// A node as it was when a gesture began.
struct TransformStart
{
    NodeId node = noNode;
    glm::dmat4 parentWorld{1.0}; ///< place of the parent at the time
    glm::dmat4 world{1.0};       ///< place of the node at the time
    glm::dmat4 track{1.0};       ///< the node's global track at the time
    NodeTransform values;
    double seconds = 0.0;
    bool keys = false; ///< the change becomes keys at the time, else the placement changes
    [[nodiscard]] glm::dvec3 origin() const { return glm::dvec3(world[3]); }
};

/// Returns the starting values of all nodes that can be changed: shown, not locked, and not below another one
/// of them (those follow). They keep the order of \p nodes, so that the last is the active one. Nodes inside
/// something flat (a scale of 0) are left out, because no movement in the world can be expressed there.
/// \param keys nodes whose global transform has a track get keys at the time instead of another placement
std::vector<TransformStart> transformStarts(const Scene& scene, const std::vector<NodeId>& nodes,
                                            double seconds, bool keys);
/// The median: the middle of the nodes' origins, world. \pre not empty
glm::dvec3 pivotOf(const std::vector<TransformStart>& starts);
/// Unit axes of the last one in this space; the world's where there is none.
glm::dmat3 transformAxes(const std::vector<TransformStart>& starts, TransformSpace space);

/// Returns the values of a node after the transform. Unchanged values stay equal to the last bit. Scales stay
/// within their range (1e-4 .. 1e4), places too. Keys are made at the time, for channels that change or are
/// keyed already; each continues like the key before it. Error Invalid: a number that is not finite.
Expected<NodeTransform> transformed(const TransformStart& start, const WorldTransform& transform);

} // namespace ramure
