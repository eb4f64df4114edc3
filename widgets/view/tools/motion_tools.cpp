#include "widgets/view/tools/motion_tools.h"

#include "core/params/param_def.h"
#include "core/params/source_facts.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

glm::dvec3 placed(const glm::dmat4& world, const glm::dvec3& point)
{
    return glm::dvec3(world * glm::dvec4(point, 1.0));
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
                                         std::span<const StandingTree> trees, double tolerance)
{
    std::optional<GrabbedBranch> found;
    Nearest nearest{tolerance};
    for (const StandingTree& tree : trees) {
        const Skeleton& skeleton = *tree.skeleton;
        const std::size_t count = tree.branches ? tree.branches->size() : skeleton.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Index b = tree.branches ? (*tree.branches)[i] : Index(i);
            if (b >= skeleton.size())
                continue;
            const RigidTransform bone = tree.bones ? (*tree.bones)[b] : RigidTransform();
            const glm::dvec3 from = placed(tree.world, bone.point(skeleton.p0[b]));
            const glm::dvec3 to = placed(tree.world, bone.point(skeleton.p1[b]));
            const auto a = view.pixel(from), c = view.pixel(to);
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
                found = GrabbedBranch{tree.node, b, along, point};
        }
    }
    return found;
}

std::optional<GrabbedBranch> branchUnder(const PickView& view, const glm::dvec2& pixel,
                                         const Document& document, const MotionFrame& frame, double tolerance)
{
    std::vector<StandingTree> trees;
    forEachTree(document, frame, [&](NodeId id, const NodeMotion& motion, const TreeResult& tree) {
        trees.push_back(
            {id, frame.geometryOf(document.scene(), id), &tree.simplified->skeleton, motion.bones.get()});
    });
    return branchUnder(view, pixel, trees, tolerance);
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
            0.5 * trunkRadius(document.scene().find(id)->params) * glm::length(glm::dvec3(world[1]));
        for (std::size_t apple = 0; apple < tree.foliage->apples.size(); ++apple) {
            const RigidTransform& bone = (*motion.bones)[tree.simplified->skeleton.size() + apple];
            const glm::dvec3 centre = placed(world, bone.point(tree.foliage->apples[apple].position));
            const auto at = view.pixel(centre);
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

namespace {

constexpr double halfReachAt = 3.0; ///< the strength whose arrow is half as long as any can be
constexpr double reachShare = 0.42; ///< of the picture's smaller side
constexpr double edgeMargin = 26.0; ///< logical pixels between an arrow and the picture's edge
constexpr double edgeOn = 0.12;     ///< sine of the angle under which a plane is too flat to point into
constexpr double leastStrength = 0.02;
constexpr double tooNear = 0.3; ///< of the camera's distance: an arrow there has no room before the eye

/// A direction of the tree's own horizontal plane, in the world, unit.
glm::dvec3 windWay(const glm::dmat4& world, double directionRad)
{
    return glm::normalize(glm::dmat3(world) *
                          glm::dvec3(std::cos(directionRad), 0.0, -std::sin(directionRad)));
}

/// How far a span of the picture must move to lie between two edges; in the middle where it cannot.
double shiftInto(double low, double high, double least, double most)
{
    if (high - low > most - least)
        return 0.5 * (least + most - low - high);
    return std::max(least - low, 0.0) - std::max(high - most, 0.0);
}

} // namespace

std::optional<WindArrow> windArrow(const EvaluatedScene& now, NodeId node, const glm::dvec3& foot,
                                   double reach)
{
    const Node* tree = now.scene().find(node);
    if (!tree || tree->kind != NodeKind::Tree)
        return std::nullopt;
    const PhysicsParams& physics = tree->params.physics;
    const double share = physics.windStrength / (physics.windStrength + halfReachAt);
    const glm::dvec3 way = windWay(now.transforms(node).geometry, physics.windDirection);
    return WindArrow{node, foot, foot + share * reach * way, reach};
}

std::optional<WindArrow> windArrowOver(const EvaluatedScene& now, NodeId node, const Box& box,
                                       const PickView& view, bool stay)
{
    if (box.empty())
        return std::nullopt;
    const glm::dvec3 top(box.centre().x, box.max.y + 0.03 * box.size().y, box.centre().z);
    glm::dvec3 foot = placed(now.transforms(node).geometry, top);
    if (depthOf(view, foot) <= tooNear * view.camera.distance && !view.camera.orthographic) {
        if (!stay)
            return std::nullopt;
        foot = view.camera.target;
    }
    const double pixel = view.camera.metresPerPixel(foot, view.size.y);
    auto arrow = windArrow(now, node, foot, reachShare * std::min(view.size.x, view.size.y) * pixel);
    if (!arrow || !stay)
        return arrow;
    for (int round = 0; round < 3; ++round) { // what moves across the picture also changes its size a little
        const auto a = view.pixel(arrow->foot), b = view.pixel(arrow->head);
        if (!a || !b)
            break;
        const glm::dvec2 low = glm::min(*a, *b), high = glm::max(*a, *b);
        const glm::dvec2 shift(shiftInto(low.x, high.x, edgeMargin, view.size.x - edgeMargin),
                               shiftInto(low.y, high.y, edgeMargin, view.size.y - edgeMargin));
        const glm::dvec3 way = pixel * (shift.x * view.camera.right() - shift.y * view.camera.up());
        arrow->foot += way;
        arrow->head += way;
    }
    return arrow;
}

std::optional<WindValues> windAt(const PickView& view, const glm::dvec2& pixel, const WindArrow& arrow,
                                 const EvaluatedScene& now)
{
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    const glm::dmat4 world = now.transforms(arrow.node).geometry;
    const glm::dvec3 up =
        glm::normalize(glm::cross(windWay(world, 0.5 * std::numbers::pi), windWay(world, 0.0)));
    const bool flat = std::abs(glm::dot(ray.direction, up)) < edgeOn;
    const glm::dvec3 normal = flat ? view.camera.backward() : up;
    const double slope = glm::dot(ray.direction, normal);
    if (std::abs(slope) < 1e-9)
        return std::nullopt;
    const double t = glm::dot(arrow.foot - ray.origin, normal) / slope;
    if (t <= 0.0 && !view.camera.orthographic)
        return std::nullopt;
    glm::dvec3 way = ray.origin + t * ray.direction - arrow.foot;
    way -= glm::dot(way, up) * up;
    const double share = std::min(glm::length(way) / arrow.reach, 0.999);
    const double strength = halfReachAt * share / (1.0 - share);
    const glm::dvec3 own = glm::inverse(glm::dmat3(world)) * way;
    WindValues values;
    values.strength =
        strength < leastStrength ? 0.0 : std::min(strength, findParam("physics.windStrength")->hardMax);
    values.directionRad = std::hypot(own.x, own.z) > 0.0 ? std::atan2(-own.z, own.x) : 0.0;
    return values;
}

std::variant<std::vector<NodeId>, NoWind> windyTrees(const Scene& scene, NodeId active, std::size_t most)
{
    std::vector<NodeId> trees;
    bool any = false;
    for (const Node& node : scene.nodes()) {
        if (node.kind != NodeKind::Tree || !scene.isShown(node.id))
            continue;
        any = true;
        if ((node.id == active || node.params.physics.windStrength > 0.0) && trees.size() < most)
            trees.push_back(node.id);
    }
    if (trees.empty())
        return any ? NoWind::NoneChosen : NoWind::NoTree;
    return trees;
}

} // namespace ramure
