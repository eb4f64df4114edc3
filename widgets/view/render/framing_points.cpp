#include "widgets/view/render/framing_points.h"

#include "core/evaluate/evaluator.h"
#include <algorithm>
#include <map>
#include <utility>

namespace ramure {
namespace {

constexpr std::size_t mostPlaces = 16384; ///< of nodes at moments
constexpr std::size_t mostMoments = 49;
constexpr std::size_t mostPoints = 120'000; ///< a camera looks at them within a few milliseconds

/// The mesh's own points where they are few, else the corners of its box.
void addPoints(const MeshItem& item, const glm::dmat4& world, std::size_t most,
               std::vector<glm::dvec3>& points)
{
    if (item.mesh.vertexCount() <= most && !item.motion.moves()) {
        for (const glm::vec3& p : item.mesh->positions)
            points.emplace_back(world * glm::dvec4(glm::dvec3(p), 1.0));
        return;
    }
    for (int i = 0; i < 8 && !item.box.empty(); ++i)
        points.emplace_back(world * glm::dvec4(item.box.corner(i), 1.0));
}

} // namespace

std::vector<double> momentsOf(const Scene& scene)
{
    const TimelineSettings& timeline = scene.timeline();
    const std::size_t count =
        std::clamp<std::size_t>(mostPlaces / std::max<std::size_t>(1, scene.nodes().size()), 5, mostMoments);
    std::vector<double> moments;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = double(i) / double(count - 1);
        const double frame =
            double(timeline.firstFrame) + share * double(timeline.lastFrame - timeline.firstFrame);
        moments.push_back(frame / timeline.framesPerSecond);
    }
    return moments;
}

std::vector<glm::dvec3> framingPoints(const Scene& scene, const RenderScene& built)
{
    std::vector<glm::dvec3> points = built.framePoints();
    std::map<NodeId, std::size_t> moving; // to the index of the node
    for (std::size_t i = 0; i < scene.nodes().size(); ++i)
        if (movesByKeys(scene, scene.nodes()[i].id))
            moving.emplace(scene.nodes()[i].id, i);
    std::vector<std::pair<std::size_t, const MeshItem*>> items;
    for (const MeshItem& item : built.meshes)
        if (const auto found = moving.find(item.node); found != moving.end() && item.framed)
            items.emplace_back(found->second, &item);
    if (items.empty())
        return points;
    const std::vector<double> moments = momentsOf(scene);
    const std::size_t most = mostPoints / (items.size() * moments.size());
    for (const double seconds : moments) {
        EvaluatedScene now(scene, seconds);
        for (const auto& [node, item] : items)
            addPoints(*item, now.transforms()[node].geometry * item->inNode, most, points);
    }
    return points;
}

} // namespace ramure
