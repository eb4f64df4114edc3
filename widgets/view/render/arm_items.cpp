#include "widgets/view/render/arm_items.h"

#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/surface/primitives/primitive_mesh.h"
#include "widgets/view/render/scene_part_cache.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ramure {
namespace {

TriangleMesh sphere(double radius)
{
    PrimitiveParams params;
    params.shape = PrimitiveShape::Sphere;
    params.radius = radius;
    params.sides = 24;
    return primitiveMesh(params);
}

/// The weights of a skin as a number along the arm that shaders make colours of: j on segment j, between two
/// of them what is shared.
TriangleMesh withWeights(TriangleMesh mesh, const Skin& skin)
{
    mesh.uv.resize(mesh.positions.size());
    mesh.uvTriangles.clear();
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const SkinInfluence& own = skin.of(v);
        mesh.uv[v] = {own.weight[0] * float(own.bone[0]) + own.weight[1] * float(own.bone[1]), 0.0F};
    }
    return mesh;
}

std::vector<double> numbersOf(const NodeParams& params)
{
    std::vector<double> numbers{params.armSkin.radius,
                                double(params.armSkin.lengthDivisions),
                                double(params.armSkin.radialDivisions),
                                params.armSkin.window,
                                params.arm.jointRadius,
                                params.skin.method == SkinMethod::Rigid ? 0.0 : 1.0,
                                params.armSkin.weights ? 1.0 : 0.0};
    for (const ArmJoint& joint : params.joints)
        numbers.push_back(joint.length);
    return numbers;
}

ArmShape shapeOf(const Node& node, const NodeParams& params, ArmPart part)
{
    ArmShape made = armShape(params, node.mesh.pointer().get(), part).value_or(ArmShape{});
    if (part == ArmPart::Skin && params.armSkin.weights && !made.mesh.empty())
        made.mesh = withWeights(std::move(made.mesh), made.skin);
    return made;
}

/// How far a mesh stands away from the segments of the straight arm.
double marginOf(const TriangleMesh& mesh, double reach)
{
    double most = 0.0;
    for (const glm::vec3& p : mesh.positions) {
        const double beyond = std::max({0.0, -double(p.z), double(p.z) - reach});
        most = std::max(most, double(p.x) * p.x + double(p.y) * p.y + beyond * beyond);
    }
    return std::sqrt(most);
}

/// A shape with what pictures need to know of it.
struct SeenArm
{
    ArmShape shape;
    double margin = 0.0;
};

/// Where the tip is to go.
void addTarget(RenderScene& scene, ScenePartCache& cache, const Node& node, const NodeParams& params,
               double reach, const glm::dmat4& world)
{
    const std::shared_ptr<const TriangleMesh> none;
    const double radius = 0.5 * std::max(params.arm.jointRadius, 0.02 * reach);
    MeshItem item;
    item.mesh =
        cache.get<TriangleMesh>(ScenePart::ArmTarget, none, none, {radius}, [&] { return sphere(radius); });
    item.box = cache.box(item.mesh);
    item.material = {"target", glm::u8vec3(40, 200, 70), true, false};
    item.inNode = armTargetPlace(params.arm.target);
    item.world = world * item.inNode;
    item.node = node.id;
    item.isMark = true;
    item.pickable = false;
    scene.meshes.push_back(std::move(item));
}

/// In the pose of the joints.
void addShape(RenderScene& scene, const std::shared_ptr<const SeenArm>& seen, const Node& node,
              const NodeParams& params, const ArmChain& chain)
{
    auto bones = std::make_shared<std::vector<RigidTransform>>();
    chain.pose(*bones);
    MeshItem item;
    item.mesh = DeferredMesh::Pointer(seen, &seen->shape.mesh);
    item.motion = {{seen, &seen->shape.skin}, std::move(bones), params.skin.method};
    for (const glm::dvec3& point : chain.points())
        item.box.add(point);
    item.box = item.box.grown(seen->margin);
    item.margin = seen->margin;
    item.inNode = armUpright();
    item.node = node.id;
    item.pickable = !node.locked;
    item.material = nodeMaterial(node, params);
    scene.meshes.push_back(std::move(item));
}

} // namespace

void addArm(RenderScene& scene, ScenePartCache& cache, const Node& node, const NodeParams& params,
            const glm::dmat4& world, DisplayMode mode)
{
    const bool surfaces = rowOf(mode).shown >= Shown::Surface;
    const ArmPart part = surfaces ? shownArmPart(params) : ArmPart::Rods;
    const bool skinned = part == ArmPart::Skin;
    const ArmChain chain(params.joints);
    const std::shared_ptr<const TriangleMesh>& bound = node.mesh.pointer();
    const auto seen = cache.get<SeenArm>(skinned ? ScenePart::ArmSkin : ScenePart::ArmRods, bound, bound,
                                         numbersOf(params), [&] {
                                             SeenArm made{shapeOf(node, params, part), 0.0};
                                             made.margin = marginOf(made.shape.mesh, chain.reach());
                                             return made;
                                         });
    if (!seen->shape.mesh.empty()) {
        addShape(scene, seen, node, params, chain);
        MeshItem& item = scene.meshes.back();
        item.world = world * item.inNode;
        if (skinned && params.armSkin.weights)
            item.paint = Paint::Weights;
    }
    if (params.arm.follows)
        addTarget(scene, cache, node, params, chain.reach(), world);
}

glm::dmat4 armTargetPlace(const glm::dvec3& target)
{
    return armUpright() * glm::translate(glm::dmat4(1.0), target);
}

} // namespace ramure
