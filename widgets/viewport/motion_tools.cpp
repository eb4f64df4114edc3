#include "widgets/viewport/motion_tools.h"

#include "core/params/param_def.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

glm::dvec3 placed(const glm::dmat4& world, const glm::dvec3& point)
{
    return glm::dvec3(world * glm::dvec4(point, 1.0));
}

std::optional<glm::dvec2> onScreen(const PickView& view, const glm::dvec3& point)
{
    const auto ndc = view.camera.project(point, view.aspect());
    if (!ndc)
        return std::nullopt;
    return 0.5 * glm::dvec2(ndc->x + 1.0, 1.0 - ndc->y) * view.size;
}

double depthOf(const PickView& view, const glm::dvec3& point)
{
    return glm::dot(view.camera.eye() - point, view.camera.backward());
}

/// Trees of the frame that the hand may touch.
template <class Visit> void forEachTree(const Document& document, const MotionFrame& frame, Visit&& visit)
{
    for (const auto& [id, motion] : frame.nodes) {
        const NodeResult* result = document.result(id);
        const bool fits = result && result->tree.simplified && motion.bones &&
                          motion.bones->size() >= result->tree.simplified->skeleton.size();
        if (fits && document.scene().isShown(id) && !document.scene().isLocked(id))
            visit(id, motion, result->tree);
    }
}

/// Nearest first, of equally near ones the one in front.
struct Nearest
{
    double pixels = 0.0, depth = std::numeric_limits<double>::max();

    bool take(double otherPixels, double otherDepth)
    {
        // Within two pixels the depth decides.
        if (otherPixels > pixels + 2.0 || (otherPixels > pixels - 2.0 && otherDepth >= depth))
            return false;
        pixels = std::min(pixels, otherPixels);
        depth = otherDepth;
        return true;
    }
};

} // namespace

std::optional<GrabbedBranch> branchUnder(const PickView& view, const glm::dvec2& pixel,
                                         const Document& document, const MotionFrame& frame, double tolerance)
{
    std::optional<GrabbedBranch> found;
    Nearest nearest{tolerance};
    forEachTree(document, frame, [&](NodeId id, const NodeMotion& motion, const TreeResult& tree) {
        const glm::dmat4 world = frame.geometryOf(document.scene(), id);
        const Skeleton& skeleton = tree.simplified->skeleton;
        for (Index b = 0; b < skeleton.size(); ++b) {
            const RigidTransform& bone = (*motion.bones)[b];
            const glm::dvec3 from = placed(world, bone.point(skeleton.p0[b]));
            const glm::dvec3 to = placed(world, bone.point(skeleton.p1[b]));
            const auto a = onScreen(view, from), c = onScreen(view, to);
            if (!a || !c)
                continue;
            const glm::dvec2 way = *c - *a;
            const double square = glm::dot(way, way);
            const double along =
                square > 0.0 ? std::clamp(glm::dot(pixel - *a, way) / square, 0.0, 1.0) : 1.0;
            const glm::dvec3 point = glm::mix(from, to, along);
            // What is drawn thick is easy to hit.
            const double radius = glm::mix(skeleton.a0[b], skeleton.a1[b], along) /
                                  std::max(view.camera.metresPerPixel(point, view.size.y), 1e-12);
            const double pixels = std::max(0.0, glm::length(*a + along * way - pixel) - radius);
            if (pixels <= tolerance && nearest.take(pixels, depthOf(view, point)))
                found = GrabbedBranch{id, b, along, point};
        }
    });
    return found;
}

glm::dvec3 pulledTo(const PickView& view, const glm::dvec2& pixel, const glm::dvec3& held)
{
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    const glm::dvec3 normal = view.camera.backward();
    const double slope = glm::dot(ray.direction, normal);
    return std::abs(slope) < 1e-12
               ? held
               : ray.origin + ray.direction * (glm::dot(held - ray.origin, normal) / slope);
}

std::optional<AppleUnder> appleUnder(const PickView& view, const glm::dvec2& pixel, const Document& document,
                                     const MotionFrame& frame)
{
    std::optional<AppleUnder> found;
    double front = std::numeric_limits<double>::max();
    forEachTree(document, frame, [&](NodeId id, const NodeMotion& motion, const TreeResult& tree) {
        if (!tree.foliage ||
            motion.bones->size() < tree.simplified->skeleton.size() + tree.foliage->apples.size())
            return;
        const glm::dmat4 world = frame.geometryOf(document.scene(), id);
        const double radius =
            0.5 * document.scene().find(id)->params.turtle.alpha * glm::length(glm::dvec3(world[1]));
        for (std::size_t apple = 0; apple < tree.foliage->apples.size(); ++apple) {
            const RigidTransform& bone = (*motion.bones)[tree.simplified->skeleton.size() + apple];
            const glm::dvec3 centre = placed(world, bone.point(tree.foliage->apples[apple].position));
            const auto at = onScreen(view, centre);
            const double depth = depthOf(view, centre);
            const double reach = radius / std::max(view.camera.metresPerPixel(centre, view.size.y), 1e-12);
            if (at && depth < front && glm::length(*at - pixel) <= std::max(reach, 4.0)) {
                front = depth;
                found = AppleUnder{id, static_cast<Index>(apple)};
            }
        }
    });
    return found;
}

std::optional<WindArrow> windArrow(const Scene& scene, NodeId node, const Box& box)
{
    const Node* tree = scene.find(node);
    if (!tree || tree->kind != NodeKind::Tree || box.empty())
        return std::nullopt;
    const PhysicsParams& physics = tree->params.physics;
    const glm::dmat4 world = placeAt(scene, node, 0.0).geometry;
    const double size = std::max(box.radius(), 1e-3);
    const glm::dvec3 along(std::cos(physics.windDirection), 0.0, -std::sin(physics.windDirection));
    const glm::dvec3 foot(box.min.x, box.min.y + 0.85 * box.size().y, box.centre().z);
    const double perStrength = 0.35 * size;
    WindArrow arrow;
    arrow.foot = placed(world, foot);
    arrow.head = placed(world, foot + along * perStrength * physics.windStrength);
    arrow.metresPerStrength = perStrength;
    return arrow;
}

std::optional<WindValues> windAt(const PickView& view, const glm::dvec2& pixel, const WindArrow& arrow,
                                 const Scene& scene, NodeId node)
{
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    const glm::dmat4 inverse = glm::inverse(placeAt(scene, node, 0.0).geometry);
    const glm::dvec3 origin = placed(inverse, ray.origin);
    const glm::dvec3 direction = glm::dmat3(inverse) * ray.direction;
    const glm::dvec3 foot = placed(inverse, arrow.foot);
    if (std::abs(direction.y) < 1e-9)
        return std::nullopt;
    const double t = (foot.y - origin.y) / direction.y;
    if (t <= 0.0 && !view.camera.orthographic)
        return std::nullopt;
    const glm::dvec3 way = origin + t * direction - foot;
    const double most = findParam("physics.windStrength")->hardMax;
    const double strength = std::hypot(way.x, way.z) / arrow.metresPerStrength;
    WindValues values;
    values.strength = strength < 0.02 ? 0.0 : std::min(strength, most);
    values.directionRad = std::hypot(way.x, way.z) > 0.0 ? std::atan2(-way.z, way.x) : 0.0;
    return values;
}

} // namespace ramure
