#include "core/scatter/scatter_ground.h"

#include "core/evaluate/evaluator.h"
#include "core/scene/kinds/node_kinds.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace ramure {
namespace {

glm::dvec2 onMap(const glm::dvec3& p)
{
    return {p.x, p.z};
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

/// 0 inside.
double distanceOnMap(const glm::dvec2& p, const std::array<glm::dvec3, 3>& triangle)
{
    const glm::dvec2 a = onMap(triangle[0]), b = onMap(triangle[1]), c = onMap(triangle[2]);
    const double u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
    if ((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0))
        return 0.0;
    return std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

} // namespace

Expected<SurfaceFromAbove> SurfaceFromAbove::of(const Scene& scene, const Node& scatter,
                                                const std::vector<const Node*>& solids)
{
    SurfaceFromAbove out;
    EvaluatedScene now(scene);
    const glm::dmat4 into = glm::inverse(worldMatrix(scene, scatter.id));
    std::vector<PrimitiveBounds> bounds;
    out.m_top = -std::numeric_limits<double>::infinity();
    for (const Node* node : solids) {
        const auto mesh = now.solid(*node);
        RAMURE_TRY(mesh);
        if (!*mesh)
            continue;
        const glm::dmat4 place = into * geometryMatrix(scene, *node);
        for (const glm::uvec3& corners : (*mesh)->triangles) {
            Triangle triangle;
            for (int i = 0; i < 3; ++i)
                triangle[std::size_t(i)] =
                    glm::dvec3(place * glm::dvec4((*mesh)->positions[corners[i]], 1.0));
            const auto& [a, b, c] = triangle;
            const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
            // Floats are rounded outwards, so that no triangle lies outside its box.
            constexpr float beyond = std::numeric_limits<float>::infinity();
            PrimitiveBounds box{glm::vec3(low), glm::vec3(high), static_cast<Index>(out.m_triangles.size())};
            for (int i = 0; i < 3; ++i) {
                box.min[i] = std::nextafter(box.min[i], -beyond);
                box.max[i] = std::nextafter(box.max[i], beyond);
            }
            bounds.push_back(box);
            out.m_triangles.push_back(triangle);
            out.m_top = std::max(out.m_top, high.y);
        }
    }
    out.m_tree = Bvh(std::move(bounds));
    return out;
}

std::optional<SurfaceFromAbove::Place> SurfaceFromAbove::at(double x, double z) const
{
    if (empty())
        return std::nullopt;
    const Ray down{{x, m_top + 1.0, z}, {0.0, -1.0, 0.0}};
    std::optional<Place> found;
    m_tree.alongRay(down, std::numeric_limits<double>::max(), [&](Index number, double& most) {
        const auto& [a, b, c] = m_triangles[number];
        const auto hit = intersect(down, a, b, c);
        if (!hit || !(hit->t < most))
            return;
        most = hit->t;
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double length = glm::length(across);
        found = Place{down.origin.y - hit->t,
                      length > 0.0 ? (across.y < 0.0 ? -1.0 : 1.0) / length * across : glm::dvec3(0, 1, 0)};
    });
    return found;
}

bool SurfaceFromAbove::isNear(double x, double z, double distance) const
{
    const Ray down{{x, m_top + distance + 1.0, z}, {0.0, -1.0, 0.0}};
    bool isNear = false;
    m_tree.nearRay(
        down, [&](const glm::dvec3&, const glm::dvec3&) { return isNear ? -1e300 : distance; },
        [&](Index number) {
            isNear = isNear || distanceOnMap({x, z}, m_triangles[number]) <= distance;
        });
    return isNear;
}

Expected<std::vector<const Node*>> groundsOf(const Scene& scene, const Node& scatter)
{
    std::vector<const Node*> found;
    const std::string& name = scatter.params.scatter.ground;
    const auto wrong = [&name](ErrorCode code, const char* text) {
        auto error = fail(code, text, {name});
        error.value().path = "scatter.ground";
        return error;
    };
    for (const Node& node : scene.nodes()) {
        if (name.empty() ? node.kind == NodeKind::Terrain && !isPrototype(scene, node.id) : node.name == name)
            found.push_back(&node);
    }
    if (name.empty())
        return found;
    if (found.empty())
        return wrong(ErrorCode::Unknown, RAMURE_NOOP("there is no node “%1” to stand on"));
    std::erase_if(found, [](const Node* node) { return !isObject(node->kind); });
    if (found.empty())
        return wrong(ErrorCode::Invalid, RAMURE_NOOP("“%1” has no surface to stand on"));
    std::erase_if(found, [&](const Node* node) { return isPrototype(scene, node->id); });
    if (found.empty())
        return wrong(ErrorCode::Invalid,
                     RAMURE_NOOP("“%1” is itself copied by a scatter: nothing can stand on it"));
    return found;
}

std::vector<const Node*> obstaclesOf(const Scene& scene, const std::vector<const Node*>& grounds)
{
    std::vector<const Node*> found;
    for (const Node& node : scene.nodes())
        if ((node.kind == NodeKind::Primitive || node.kind == NodeKind::Mesh) &&
            node.params.growthRole == GrowthRole::Obstacle && !isPrototype(scene, node.id) &&
            std::ranges::find(grounds, &node) == grounds.end())
            found.push_back(&node);
    return found;
}

} // namespace ramure
