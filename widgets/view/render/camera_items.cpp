#include "widgets/view/render/camera_items.h"

#include "core/surface/mesh/transformed.h"
#include "core/surface/primitives/primitive_mesh.h"
#include "widgets/view/render/scene_part_cache.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ramure {
namespace {

constexpr double leastFocus = 1e-3; ///< m
constexpr double filmAspect = 16.0 / 9.0;
constexpr glm::u8vec4 cameraColour{70, 92, 118, 255}, selectedColour{255, 128, 16, 255};

/// Along \p axis, or \p otherwise where a scale of 0 leaves no way.
glm::dvec3 wayOf(const glm::dvec4& axis, const glm::dvec3& otherwise)
{
    const glm::dvec3 way(axis);
    const double length = glm::length(way);
    return length > 1e-12 ? way / length : otherwise;
}

/// Behind the eye, which is in the origin; 1 is what the lines reach to.
TriangleMesh body()
{
    PrimitiveParams box;
    box.shape = PrimitiveShape::Box;
    box.size = {0.22, 0.18, 0.3};
    return transformed(primitiveMesh(box),
                       glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, 0.5 * box.size.z)));
}

class SightLines
{
public:
    SightLines(const CameraParams& params, const glm::u8vec4& colour)
        : m_half(std::tan(0.5 * params.angleRad))
        , m_colour(colour)
    {
    }
    [[nodiscard]] glm::vec3 at(double x, double y, double depth) const
    {
        return glm::vec3(glm::dvec3(x * filmAspect * m_half, y * m_half, -1.0) * depth);
    }
    void add(const glm::vec3& from, const glm::vec3& to)
    {
        lines.segments.push_back({from, to, 1.5f, 1.5f, m_colour, noIndex});
        lines.box.add(from);
        lines.box.add(to);
    }
    void addRectangle(double depth)
    {
        constexpr double corners[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
        for (int i = 0; i < 4; ++i) {
            const auto& from = corners[i];
            const auto& to = corners[(i + 1) % 4];
            add(at(from[0], from[1], depth), at(to[0], to[1], depth));
        }
    }
    LineSet lines;

private:
    double m_half;
    glm::u8vec4 m_colour;
};

} // namespace

Camera cameraAt(const glm::dmat4& world, const CameraParams& params)
{
    Camera camera;
    const glm::dvec3 back = wayOf(world[2], {0.0, 0.0, 1.0});
    const glm::dvec3 top = wayOf(world[1], {0.0, 1.0, 0.0});
    camera.fovRad = params.angleRad;
    camera.distance = std::max(params.focus, leastFocus);
    camera.pitchRad = std::asin(std::clamp(back.y, -1.0, 1.0));
    // Straight up or down, what is above in the picture says where it is turned to.
    const bool isLevel = std::hypot(back.x, back.z) > 1e-9;
    camera.yawRad = isLevel        ? std::atan2(back.x, back.z)
                    : back.y > 0.0 ? std::atan2(-top.x, -top.z)
                                   : std::atan2(top.x, top.z);
    const glm::dvec3 level = camera.right(), upright = camera.up();
    const glm::dvec3 right = glm::cross(top, back);
    const double roll = std::atan2(glm::dot(right, upright), glm::dot(right, level));
    camera.rollRad = std::abs(roll) > 1e-12 ? roll : 0.0;
    camera.target = glm::dvec3(world[3]) - camera.distance * camera.backward();
    return camera;
}

glm::dmat4 standingOf(const Camera& camera)
{
    return {glm::dvec4(camera.right(), 0.0), glm::dvec4(camera.up(), 0.0), glm::dvec4(camera.backward(), 0.0),
            glm::dvec4(camera.eye(), 1.0)};
}

Lens lensOf(const CameraParams& params)
{
    if (params.fStop <= 0.0)
        return {};
    return {Lens::diameterOf(params.fStop, params.angleRad), std::max(params.focus, leastFocus)};
}

std::optional<NodeView> viewThrough(EvaluatedScene& now, NodeId id)
{
    const Node* node = now.scene().find(id);
    if (!node || node->kind != NodeKind::Camera)
        return std::nullopt;
    const CameraParams params = now.params(*node).camera;
    return NodeView{cameraAt(now.transforms(id).geometry, params), lensOf(params)};
}

void addCamera(RenderScene& scene, ScenePartCache& cache, const Node& node, const CameraParams& params,
               const glm::dmat4& world, bool isSelected)
{
    const double reach = std::clamp(0.2 * params.focus, 0.2, 2.0); // m
    const std::shared_ptr<const TriangleMesh> none;
    MeshItem item;
    item.mesh = cache.get<TriangleMesh>(ScenePart::CameraBody, none, none, {}, [] { return body(); });
    item.box = cache.box(item.mesh);
    const glm::u8vec4 colour = isSelected ? selectedColour : cameraColour;
    item.material = {"camera", glm::u8vec3(colour), false, false};
    item.inNode = glm::scale(glm::dmat4(1.0), glm::dvec3(reach));
    item.world = world * item.inNode;
    item.node = node.id;
    item.isMark = true;
    item.castsShadow = false;
    item.pickable = !node.locked;
    item.framed = false;
    scene.meshes.push_back(std::move(item));

    SightLines sight(params, colour);
    sight.addRectangle(reach);
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            sight.add(glm::vec3(0.0f), sight.at(x, y, reach));
    for (const double x : {-0.5, 0.5}) // what is above
        sight.add(sight.at(x, 1.08, reach), sight.at(0.0, 1.5, reach));
    sight.add(sight.at(-0.5, 1.08, reach), sight.at(0.5, 1.08, reach));
    if (params.fStop > 0.0)
        sight.addRectangle(params.focus);
    LineItem lines;
    lines.lines = std::make_shared<const LineSet>(std::move(sight.lines));
    lines.world = world;
    lines.node = node.id;
    lines.throughSurfaces = true;
    lines.framed = false;
    scene.lines.push_back(std::move(lines));
}

} // namespace ramure
