#include "core/scene/world_transforms.h"

#include <algorithm>
#include <unordered_map>

namespace ramure {

glm::dmat4 worldUnder(const glm::dmat4& parentWorld, const Node& node, double seconds)
{
    const glm::dmat4 own = placementMatrix(node.params.tree);
    if (!node.animation.movesNode())
        return parentWorld * own;
    return parentWorld * transformAt(node.animation, ChannelPart::GlobalTranslation, seconds) * own;
}

glm::dmat4 geometryUnder(const glm::dmat4& world, const Node& node, double seconds)
{
    glm::dmat4 place = world;
    if (node.kind == NodeKind::Group)
        return place;
    if (node.animation.movesNode())
        place = place * transformAt(node.animation, ChannelPart::LocalTranslation, seconds);
    if (node.params.local != PlacementParams{})
        place = place * placementMatrix(node.params.local);
    return place;
}

std::vector<NodeTransforms> worldTransformsAt(const Scene& scene, double seconds)
{
    std::vector<NodeTransforms> transforms;
    transforms.reserve(scene.nodes().size());
    std::unordered_map<NodeId, std::size_t> indices;
    for (const Node& node : scene.nodes()) {
        const auto parent = indices.find(node.parent); // parents stand before their children
        const glm::dmat4 above = parent == indices.end() ? glm::dmat4(1.0) : transforms[parent->second].world;
        indices.emplace(node.id, transforms.size());
        NodeTransforms place;
        place.world = worldUnder(above, node, seconds);
        place.geometry = geometryUnder(place.world, node, seconds);
        transforms.push_back(place);
    }
    return transforms;
}

NodeTransforms worldTransformAt(const Scene& scene, NodeId id, double seconds)
{
    const Node* node = scene.find(id);
    if (!node)
        return {};
    NodeTransforms place;
    place.world = worldUnder(worldTransformAt(scene, node->parent, seconds).world, *node, seconds);
    place.geometry = geometryUnder(place.world, *node, seconds);
    return place;
}

bool movesByKeys(const Scene& scene, NodeId id)
{
    for (const Node* node = scene.find(id); node; node = scene.find(node->parent))
        if (node->animation.movesNode())
            return true;
    return false;
}

bool hasTracks(const Scene& scene)
{
    return std::any_of(scene.nodes().begin(), scene.nodes().end(),
                       [](const Node& node) { return !node.animation.empty(); });
}

} // namespace ramure
