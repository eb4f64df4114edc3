/// \file
/// The transforms of all nodes of a scene at a time (SPEC B2).
#pragma once

#include "core/scene/scene.h"

namespace ramure {

struct NodeTransforms
{
    glm::dmat4 world{1.0};    ///< transform of the node, from which its children are measured
    glm::dmat4 geometry{1.0}; ///< transform of its own geometry: world * local track * local static
};

/// parent world * global track * static.
glm::dmat4 worldUnder(const glm::dmat4& parentWorld, const Node& node, double seconds);
/// world * local track * local static; of a group its world.
glm::dmat4 geometryUnder(const glm::dmat4& world, const Node& node, double seconds);
/// One per node, in the order of Scene::nodes().
std::vector<NodeTransforms> worldTransformsAt(const Scene& scene, double seconds);
/// One node alone. Unknown ids: identity.
NodeTransforms worldTransformAt(const Scene& scene, NodeId id, double seconds);
/// A node or one above it has a track of its transform.
bool movesByKeys(const Scene& scene, NodeId id);
/// Any node has a track.
bool hasTracks(const Scene& scene);

} // namespace ramure
