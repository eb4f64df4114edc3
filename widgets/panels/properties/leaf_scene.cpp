#include "widgets/panels/properties/leaf_scene.h"

#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesher/rough_model.h"
#include "core/surface/season/foliage_on_day.h"
#include <algorithm>

namespace ramure {
namespace {

constexpr double nodes = 7.0;                  ///< with leaves, on the twig
constexpr double thickness = 0.012;            ///< of the twig, of its length
constexpr int sides = 12, picturePixels = 512; ///< of the twig; of the pictures of a leaf
constexpr double leafGap = 0.25;               ///< between leaf and twig, of the twig's length

double twigLength(const LeafParams& leaf)
{
    if (leaf.shape == LeafShape::Faithful)
        return 2.0;
    const LeafRow& row = leafRow(leaf.shape);
    return std::clamp(nodes * row.internode * leaf.internode, 0.8 * row.length, 4.0 * row.length);
}

Foliage placed(const Skeleton& twig, const NodeParams& params)
{
    FoliageParams all = params.foliage;
    all.leavesCutoff = 10.0;
    all.applesProbability = 0.0;
    auto made = placeFoliage(twig, all, params.leaf, params.fruit, 1.0);
    if (made)
        return hasDay(params.season) ? foliageOnDay(*made, twig, params.season, 1.0) : std::move(*made);
    Foliage none;
    none.form = leafForm(params.leaf);
    return none;
}

/// Upright beside the twig, its upper side to the front, about as tall.
FoliageItem singleLeaf(const Foliage& foliage, const TriangleMesh& leaf, double length)
{
    const Box box = meshBox(leaf);
    FoliageItem item;
    item.branch = 0;
    if (!foliage.leaves.empty())
        item.tint = foliage.leaves.front().tint;
    const double side = box.empty() ? 0.0 : std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    if (side <= 0.0)
        return item;
    const double size = length / side;
    item.size = static_cast<float>(size);
    item.position = {-size * box.max.x - leafGap * length, -size * box.min.y, 0.0};
    return item;
}

void add(RenderScene& scene, MeshItem item, Material material)
{
    item.box = meshBox(*item.mesh);
    item.material = std::move(material);
    if (!item.material.pictures.isEmpty() && item.copies)
        item.images = std::make_shared<const SurfaceImages>(surfaceImages(item.material));
    if (!item.mesh->empty())
        scene.meshes.push_back(std::move(item));
}

} // namespace

RenderScene leafScene(const NodeParams& shown)
{
    NodeParams params = shown;
    params.leaf.length = 0.0; // the picture has no scale: its trunk has a radius of 1
    const double length = twigLength(params.leaf);
    Skeleton twig;
    twig.add(noIndex, {0.0, 0.0, 0.0}, {0.0, length, 0.0}, thickness * length, 0.6 * thickness * length);
    Foliage foliage = placed(twig, params);
    if (const TriangleMesh one = oneLeaf(foliage.form, 1.0, FoliageModel::Fine); !one.empty()) {
        const Box leaves = meshBox(buildLeaves(twig, foliage, 1.0, FoliageModel::Fine));
        FoliageItem single = singleLeaf(foliage, one, length);
        single.position.x += leaves.empty() ? 0.0 : std::min(0.0, leaves.min.x);
        foliage.leaves.push_back(single);
    }

    RenderScene scene;
    Material bark = barkMaterial(params.bark);
    bark.twoSided = true; // its ends are open
    MeshItem branch;
    branch.mesh = std::make_shared<const TriangleMesh>(buildRoughBranches(twig, sides));
    add(scene, std::move(branch), bark);
    if (foliage.leaves.empty()) {
        scene.updateBoxes();
        return scene;
    }
    MeshItem item;
    item.mesh = std::make_shared<const TriangleMesh>(buildLeaves(twig, foliage, 1.0, FoliageModel::Fine));
    item.copies = std::make_shared<const MeshCopies>(leafCopies(foliage, 1.0, FoliageModel::Fine));
    if (foliage.form.shape != LeafShape::Faithful)
        if (auto maps = leafMaps(foliage.form.shape, picturePixels))
            item.leaf = std::make_shared<const LeafMaps>(std::move(*maps));
    add(scene, std::move(item), leavesMaterial(foliage, params.leafPictures));
    scene.updateBoxes();
    return scene;
}

} // namespace ramure
