#include "widgets/render/arm_items.h"

#include "core/arm/arm_chain.h"
#include "core/arm/arm_skin.h"
#include "core/mesh/relief.h"
#include "widgets/render/scene_part_cache.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace ramure {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sides = 24, rings = 12;
constexpr double rodPart = 0.45; ///< radius of a rod, of that of a joint

/// A surface of revolution about Z that is added to a mesh.
class Turned
{
public:
    Turned(TriangleMesh& mesh, Index segment)
        : m_mesh(mesh)
        , m_segment(segment)
    {
    }
    /// A ring at height \p z; from the second on it is joined to the one before.
    void ring(double z, double radius, const glm::dvec2& normal)
    {
        const Index first = m_mesh.vertexCount();
        for (int i = 0; i <= sides; ++i) {
            const double turn = 2.0 * pi * i / sides;
            m_mesh.positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
            m_mesh.normals.emplace_back(normal.x * std::cos(turn), normal.x * std::sin(turn), normal.y);
            m_mesh.branch.push_back(m_segment);
        }
        for (Index i = 0; m_rings > 0 && i < Index(sides); ++i) {
            const Index a = first - Index(sides) - 1 + i, b = first + i;
            m_mesh.triangles.emplace_back(a, a + 1, b + 1);
            m_mesh.triangles.emplace_back(a, b + 1, b);
        }
        ++m_rings;
    }

private:
    TriangleMesh& m_mesh;
    Index m_segment;
    int m_rings = 0;
};

void addSphere(TriangleMesh& mesh, Index segment, double z, double radius)
{
    Turned turned(mesh, segment);
    for (int i = 0; i <= rings; ++i) {
        const double up = pi * (double(i) / rings - 0.5);
        turned.ring(z + radius * std::sin(up), radius * std::cos(up), {std::cos(up), std::sin(up)});
    }
}

TriangleMesh sphere(double radius)
{
    TriangleMesh mesh;
    addSphere(mesh, 0, 0.0, radius);
    mesh.branch.clear();
    return mesh;
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

struct BoundMesh
{
    TriangleMesh mesh;
    Skin skin;
};

BoundMesh boundSkin(const NodeParams& params)
{
    BoundMesh made;
    made.mesh = armCylinder(params.joints, params.armSkin).value_or(TriangleMesh{});
    made.skin =
        bindArm(made.mesh, params.joints, params.skin.method != SkinMethod::Rigid, params.armSkin.window);
    made.mesh.branch.clear(); // segments are nothing that can be selected
    if (params.armSkin.weights)
        made.mesh = withWeights(std::move(made.mesh), made.skin);
    return made;
}

BoundMesh boundRods(const NodeParams& params)
{
    BoundMesh made;
    made.mesh = armRods(params.joints, params.arm.jointRadius);
    made.skin.vertices = made.mesh.vertexCount();
    made.skin.bones = static_cast<Index>(params.joints.size());
    for (Index v = 0; v < made.skin.vertices; ++v) {
        const Index bone = made.mesh.branch[v];
        if (v == 0 || bone != made.mesh.branch[v - 1])
            made.skin.runs.push_back({v, {{bone, bone, bone}, {1.0F, 0.0F, 0.0F}}});
    }
    made.mesh.branch.clear();
    return made;
}

} // namespace

TriangleMesh armRods(std::span<const ArmJoint> joints, double jointRadius)
{
    TriangleMesh mesh;
    const double rod = rodPart * jointRadius;
    double height = 0.0;
    for (Index j = 0; j < joints.size(); ++j) {
        addSphere(mesh, j, height, jointRadius);
        Turned turned(mesh, j);
        turned.ring(height, rod, {1.0, 0.0});
        height += joints[j].length;
        turned.ring(height, rod, {1.0, 0.0});
    }
    // The tip, a little smaller: it is no joint.
    addSphere(mesh, static_cast<Index>(joints.size() - 1), height, 0.6 * jointRadius);
    return mesh;
}

namespace {

void addRelief(RenderScene& scene, ScenePartCache& cache, const Node& node, const NodeParams& params,
               const glm::dmat4& world)
{
    const ReliefParams& r = params.relief;
    const std::shared_ptr<const TriangleMesh> none;
    MeshItem item;
    item.mesh = cache.get<TriangleMesh>(ScenePart::Relief, none, none,
                                        {double(r.seed), r.size, r.height, r.roughness, double(r.divisions)},
                                        [&] { return buildRelief(r).value_or(TriangleMesh{}); });
    if (item.mesh->empty())
        return;
    item.box = cache.box(item.mesh);
    item.material = {"terrain", glm::u8vec3(params.surface.color * 255.0 + 0.5), false, true};
    item.world = world;
    item.node = node.id;
    item.pickable = !node.locked;
    scene.meshes.push_back(std::move(item));
}

/// Where the tip is to go.
void addTarget(RenderScene& scene, ScenePartCache& cache, const NodeParams& params, double reach,
               const glm::dmat4& world)
{
    const std::shared_ptr<const TriangleMesh> none;
    const double radius = 0.5 * std::max(params.arm.jointRadius, 0.02 * reach);
    MeshItem item;
    item.mesh =
        cache.get<TriangleMesh>(ScenePart::ArmTarget, none, none, {radius}, [&] { return sphere(radius); });
    item.box = cache.box(item.mesh);
    item.material = {"target", glm::u8vec3(40, 200, 70), true, false};
    item.world = world * armUpright() * glm::translate(glm::dmat4(1.0), params.arm.target);
    item.pickable = false;
    scene.meshes.push_back(std::move(item));
}

void addArm(RenderScene& scene, ScenePartCache& cache, const Node& node, const NodeParams& params,
            const glm::dmat4& world, DisplayMode mode)
{
    const std::shared_ptr<const TriangleMesh> none;
    const bool skinned =
        mode == DisplayMode::Mesh || mode == DisplayMode::Checker || mode == DisplayMode::Stretch;
    auto bones = std::make_shared<std::vector<RigidTransform>>();
    const ArmChain chain(params.joints);
    chain.pose(*bones);
    const double around = std::max(params.armSkin.radius, params.arm.jointRadius);
    const glm::u8vec3 colour(params.surface.color * 255.0 + 0.5);
    const auto add = [&](const std::shared_ptr<const BoundMesh>& made, const Material& material) {
        if (made->mesh.empty())
            return;
        MeshItem item;
        item.mesh = {made, &made->mesh};
        item.motion = {{made, &made->skin}, bones, params.skin.method};
        for (const glm::dvec3& point : chain.points())
            item.box.add(point);
        item.box = item.box.grown(around);
        item.material = material;
        item.world = world * armUpright();
        item.node = node.id;
        item.pickable = !node.locked;
        scene.meshes.push_back(std::move(item));
    };
    if (skinned && params.armSkin.shown) {
        add(cache.get<BoundMesh>(ScenePart::ArmSkin, none, none, numbersOf(params),
                                 [&] { return boundSkin(params); }),
            {"skin", colour, true, false});
        if (params.armSkin.weights && !scene.meshes.empty())
            scene.meshes.back().paint = Paint::Weights;
    } else if (params.arm.jointRadius > 0.0)
        add(cache.get<BoundMesh>(ScenePart::ArmRods, none, none, numbersOf(params),
                                 [&] { return boundRods(params); }),
            {"joints", colour, true, false});
    if (params.arm.follows)
        addTarget(scene, cache, params, chain.reach(), world);
}

} // namespace

bool addArmOrRelief(RenderScene& scene, ScenePartCache& cache, const Node& node, const glm::dmat4& world,
                    const SceneView& view)
{
    if (node.kind == NodeKind::Relief)
        addRelief(scene, cache, node, node.params, world);
    else if (node.kind == NodeKind::Arm)
        addArm(scene, cache, node, node.params, world, view.mode);
    else
        return false;
    return true;
}

} // namespace ramure
