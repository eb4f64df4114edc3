#include "widgets/panels/levels/level_scene.h"

#include "core/lod/level_leaves.h"
#include "core/params/source_facts.h"
#include "core/qt/session/export/level_export.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double widestTan = 2.0; ///< of half the angle of view, where the eye stands in the crown

double screenTan()
{
    return std::tan(0.5 * levelFovRad);
}

/// The level in place of the tree.
TreeResult resultOf(const TreeLevels& of, const TreeLevel& level)
{
    TreeResult tree = of.whole;
    tree.branches = level.branches;
    tree.foliage = level.foliage;
    tree.leaves = level.leaves;
    tree.apples = level.apples;
    tree.cuts = level.cuts;
    const bool isWhole = level.branches == of.whole.branches;
    const bool hasPicture = level.branches && of.whole.texture && isBarkReady(*of.whole.texture, of.params);
    if (!isWhole)
        tree.texture = hasPicture ? std::make_shared<const TextureStage>(level.branches) : nullptr;
    return tree;
}

/// Cards in place of leaves: the builder knows leaves alone.
void drawSprays(RenderScene& scene, const TreeLevel& level)
{
    for (MeshItem& item : scene.meshes)
        if (item.copies && item.mesh == level.leaves) {
            item.copies = nullptr;
            item.leaf = nullptr;
            item.material = spraysMaterial(std::move(item.material), level.sprays);
            item.images = std::make_shared<const SurfaceImages>(surfaceImages(item.material));
        }
}

/// The simplest in place of leaves: the builder knows leaves alone.
void drawSimplest(RenderScene& scene, const TreeResult& tree, double alpha, FoliageModel simplest)
{
    if (!tree.leaves || !tree.foliage || tree.foliage->leaves.empty())
        return;
    const std::size_t each = tree.leaves.faceCount() / tree.foliage->leaves.size();
    if (each == oneLeaf(tree.foliage->form, alpha, FoliageModel::Fine).faceCount())
        return;
    for (MeshItem& item : scene.meshes)
        if (item.copies && item.mesh == tree.leaves) {
            item.copies = std::make_shared<const MeshCopies>(leafCopies(*tree.foliage, alpha, simplest));
            item.leaf = nullptr;
            item.images = nullptr;
        }
}

/// The cards of a billboard stand for all of the tree.
RenderScene billboardScene(const TreeLevel& level)
{
    RenderScene scene;
    MeshItem item;
    for (const glm::vec3& place : level.billboard->positions)
        item.box.add(glm::dvec3(place));
    item.mesh = level.billboard;
    item.material = billboardMaterial(level.billboardAtlas);
    item.images = std::make_shared<const SurfaceImages>(surfaceImages(item.material));
    scene.box = item.box;
    scene.meshes.push_back(std::move(item));
    return scene;
}

} // namespace

RenderScene levelScene(SceneBuilder& builder, const TreeLevels& of, std::optional<std::size_t> level)
{
    if (level && of.levels[*level].billboard)
        return billboardScene(of.levels[*level]);
    const TreeResult tree = level ? resultOf(of, of.levels[*level]) : of.whole;
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = "tree";
    node.params = of.params;
    node.params.tree = node.params.local = {};
    const auto scene = Scene::fromNodes({std::move(node)});
    if (!scene)
        return {};
    SceneView view;
    view.waitsForBark = level && of.levels[*level].branches != of.whole.branches;
    RenderScene built = builder.build(
        *scene, [&](NodeId) { return &tree; }, view);
    if (level && of.levels[*level].sprays)
        drawSprays(built, of.levels[*level]);
    else
        drawSimplest(built, tree, trunkRadius(of.params), simplestLeaf(of.params.leafPictures));
    return built;
}

Camera levelCamera(const TreeLevels& of, const LevelShot& shot, const glm::ivec2& size)
{
    Camera camera;
    camera.target = of.box.centre();
    camera.distance = shot.distance / of.scale;
    camera.yawRad = shot.yawRad;
    camera.pitchRad = shot.pitchRad;
    double tangent = screenTan() * double(size.y) / levelScreenHeight;
    if (shot.enlarged) {
        const glm::dvec3 half = 0.5 * of.box.size();
        const double around = std::max(half.x, half.z); // crowns are round
        const double aspect = double(size.x) / double(size.y);
        const double away =
            camera.distance * std::sqrt(std::max(1.0 - std::pow(around / camera.distance, 2), 0.01));
        tangent = Camera::usualMargin *
                  std::max(half.y + around * std::abs(std::sin(shot.pitchRad)), around / aspect) / away;
    }
    camera.fovRad = 2.0 * std::atan(std::min(tangent, widestTan));
    return camera;
}

double levelPixels(const TreeLevels& of, double distance)
{
    return of.box.size().y * of.scale * levelScreenHeight / (2.0 * screenTan() * distance);
}

} // namespace ramure
