#include "widgets/view/render/ground_height.h"

#include "core/evaluate/evaluator.h"
#include "core/scene/kinds/node_kinds.h"
#include "widgets/view/render/framing_points.h"
#include <algorithm>
#include <limits>
#include <map>

namespace ramure {
namespace {

/// Looks at the points only where the corners of the box are low enough to matter.
double lowestOf(const MeshItem& item, const glm::dmat4& world, double below)
{
    if (item.box.empty() || item.box.transformed(world).min.y >= below)
        return below;
    const glm::dvec3 row(world[0].y, world[1].y, world[2].y);
    double lowest = std::numeric_limits<double>::max();
    for (const glm::vec3& point : item.mesh->positions)
        lowest = std::min(lowest, glm::dot(row, glm::dvec3(point)));
    return std::min(below, lowest + world[3].y);
}

} // namespace

GroundHeight::Stamp GroundHeight::stampOf(const Scene& scene, const RenderScene& built)
{
    Stamp stamp;
    const TimelineSettings& timeline = scene.timeline();
    stamp.numbers = {double(timeline.firstFrame), double(timeline.lastFrame), timeline.framesPerSecond};
    for (const Node& node : scene.nodes()) {
        for (const PlacementParams* placement : {&node.params.tree, &node.params.local})
            for (const glm::dvec3& v : {placement->translation, placement->rotation, placement->scale})
                stamp.numbers.insert(stamp.numbers.end(), {v.x, v.y, v.z});
        stamp.numbers.insert(stamp.numbers.end(), {double(node.id), double(node.parent), double(node.kind)});
        for (const auto& [channel, track] : node.animation.tracks())
            if (channel.part != ChannelPart::Parameter)
                stamp.held.push_back(track);
    }
    for (const MeshItem& item : built.meshes) {
        stamp.numbers.push_back(double(item.node));
        stamp.held.push_back(item.mesh.key());
    }
    return stamp;
}

double GroundHeight::of(const Scene& scene, const RenderScene& built)
{
    Stamp stamp = stampOf(scene, built);
    if (stamp == m_stamp)
        return m_height;
    m_stamp = std::move(stamp);
    std::map<NodeId, const MeshItem*> items;
    for (const MeshItem& item : built.meshes)
        items.emplace(item.node, &item);
    std::vector<std::pair<std::size_t, const MeshItem*>> objects; // index of the node
    bool moves = false;
    for (std::size_t i = 0; i < scene.nodes().size(); ++i) {
        const Node& node = scene.nodes()[i];
        moves = moves || node.animation.movesNode();
        if (const auto item = items.find(node.id); item != items.end() && isObject(node.kind))
            objects.emplace_back(i, item->second);
    }
    m_height = 0.0;
    if (objects.empty())
        return m_height;
    std::vector<double> moments = momentsOf(scene);
    if (!moves)
        moments.resize(1);
    for (const double seconds : moments) {
        EvaluatedScene now(scene, seconds);
        for (const auto& [index, item] : objects)
            m_height = lowestOf(*item, now.transforms()[index].geometry, m_height);
    }
    return m_height;
}

} // namespace ramure
