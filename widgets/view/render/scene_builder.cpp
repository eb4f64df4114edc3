#include "widgets/view/render/scene_builder.h"

#include "core/params/source_facts.h"
#include "core/pipeline/stage_hashes.h"
#include "core/scene/object_mesh.h"
#include "core/surface/check/texture_report.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesher/rough_model.h"
#include "core/surface/texture/object_texture.h"
#include "widgets/view/render/arm_items.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/render/crowd_items.h"
#include "widgets/view/render/crown_marks.h"
#include "widgets/view/render/figure.h"
#include "widgets/view/render/ground_height.h"
#include "widgets/view/render/isolated_parts.h"
#include "widgets/view/render/line_art.h"
#include "widgets/view/render/outlined_items.h"
#include "widgets/view/render/scene_part_cache.h"
#include "widgets/view/render/tree_ground.h"
#include <algorithm>
#include <numeric>
#include <stop_token>

namespace ramure {
namespace {

/// Of cones and tubes without ends.
Material openBark(const BarkParams& params = {}, const PictureParams& pictures = {})
{
    Material bark = barkMaterial(params, pictures);
    bark.twoSided = true;
    return bark;
}

/// Pixels a side of a tile of bark: as fine as the view can show, and quickly made.
constexpr int shownBarkSize = 512, shownLeafSize = 256;

/// Of a number that a double does not hold.
double highHalf(std::uint64_t number)
{
    return double(number >> 32U);
}
double lowHalf(std::uint64_t number)
{
    return double(number & 0xFFFFFFFFU);
}

/// What a surface wears, read again where a file has changed.
std::shared_ptr<const SurfaceImages> imagesOf(ScenePartCache& cache, const Material& material)
{
    if (material.pictures.isEmpty())
        return nullptr;
    const std::uint64_t stamp = pictureStamp(material.pictures);
    const std::shared_ptr<const void> anybody; // surfaces that look the same share it
    const std::uint64_t bark = barkHash(material.bark);
    return cache.get<SurfaceImages>(ScenePart::Images, anybody, anybody,
                                    {highHalf(stamp), lowHalf(stamp), highHalf(bark), lowHalf(bark),
                                     double(material.leaf), double(material.name.starts_with("bark")),
                                     double(material.colour.r), double(material.colour.g),
                                     double(material.colour.b)},
                                    [&] { return surfaceImages(material); });
}

/// A branch mesh with texture coordinates.
struct TexturedMesh
{
    TriangleMesh mesh; ///< empty where there are no coordinates
    std::shared_ptr<const TextureCoordinates> coordinates;
    TextureReport report;
};

TexturedMesh texturedMesh(const BranchMesh& branches, const TextureStage& texture, const NodeParams& params)
{
    const auto made = texture.coordinates(params.texture);
    if (!made)
        return {};
    return {splitByTexture(branches, **made), *made, textureReport(branches, **made)};
}

/// Appends the items of one tree.
struct TreeItems
{
    ScenePartCache& cache;
    RenderScene& scene;
    const SceneView& view;
    const Node& node;
    const TreeResult& tree;
    glm::dmat4 world;

    [[nodiscard]] bool isIsolated() const
    {
        return view.isolatedNode == node.id && !view.isolatedBranches.empty();
    }
    /// Empty: all are.
    [[nodiscard]] BranchFlags shownBranches() const
    {
        return isIsolated() && tree.simplified
                   ? branchFlags(tree.simplified->skeleton.size(), view.isolatedBranches)
                   : BranchFlags();
    }
    /// The part of a mesh, of lines or marks that belongs to the branches shown alone, where there are such.
    template <class T> std::shared_ptr<const T> shown(std::shared_ptr<const T> block)
    {
        if (!block || !isIsolated() || !tree.simplified)
            return block;
        return cache.get<T>(
            ScenePart::Isolated, block, tree.simplified, asNumbers(view.isolatedBranches), [&] {
                return onlyBranches(*block,
                                    branchFlags(tree.simplified->skeleton.size(), view.isolatedBranches));
            });
    }

    /// Null where nothing of it is shown.
    MeshItem* addMesh(std::shared_ptr<const TriangleMesh> mesh, Material material)
    {
        mesh = shown(std::move(mesh));
        if (!mesh || mesh->empty())
            return nullptr;
        MeshItem* item = addItem(std::move(mesh), std::move(material));
        item->box = cache.box(item->mesh);
        return item;
    }
    /// Without its box yet.
    MeshItem* addItem(DeferredMesh mesh, Material material)
    {
        MeshItem item;
        item.mesh = std::move(mesh);
        item.material = std::move(material);
        item.world = world;
        item.node = node.id;
        item.pickable = !node.locked;
        return &scene.meshes.emplace_back(std::move(item));
    }
    /// Leaves or apples: drawn as copies, so that nobody has to merge them.
    void addFoliage(ScenePart part, DeferredMesh mesh, Material material, FoliageModel model)
    {
        if (isIsolated())
            mesh = shown(mesh.pointer());
        if (!tree.foliage || mesh.empty())
            return;
        MeshItem* item = addItem(std::move(mesh), std::move(material));
        if (model == FoliageModel::Fine)
            item->images = imagesOf(cache, item->material);
        if (const LeafShape shape = tree.foliage->form.shape;
            part == ScenePart::LeafCopies && shape != LeafShape::Faithful && model == FoliageModel::Fine) {
            const std::shared_ptr<const void> anybody; // trees of the same plant share it
            item->leaf = cache.get<LeafMaps>(ScenePart::LeafPicture, anybody, anybody, {double(shape)},
                                             [&] { return leafMaps(shape, shownLeafSize).value(); });
        }
        const double alpha = trunkRadius(node.params);
        const BranchFlags flags = shownBranches();
        std::vector<double> numbers =
            flags.empty() ? std::vector<double>() : asNumbers(view.isolatedBranches);
        // A picture takes the place of a fruit's colours; those of leaves are tones of theirs.
        const bool isPainted = part == ScenePart::AppleCopies && !item->material.pictures.colour.empty();
        numbers.insert(numbers.begin(), {alpha, double(model), isPainted ? 1.0 : 0.0});
        item->copies = cache.get<MeshCopies>(part, tree.foliage, item->mesh.key(), std::move(numbers), [&] {
            const auto make = part == ScenePart::LeafCopies ? leafCopies : appleCopies;
            MeshCopies made = make(*tree.foliage, alpha, model, flags);
            if (isPainted)
                made.colours.clear();
            return made;
        });
        item->box = item->mesh.isMade() ? cache.box(item->mesh)
                                        : *cache.get<Box>(ScenePart::MeshBox, tree.foliage, item->mesh.key(),
                                                          {alpha}, [&] { return boxOf(part, alpha, model); });
    }
    [[nodiscard]] Box boxOf(ScenePart part, double alpha, FoliageModel model) const
    {
        const Foliage& foliage = *tree.foliage;
        return part == ScenePart::LeafCopies
                   ? boxAround(foliage.leaves, oneLeaf(foliage.form, alpha, model))
                   : boxAround(foliage.apples, oneApple(foliage.fruit, alpha, model));
    }
    void addLines(std::shared_ptr<const LineSet> lines, bool throughSurfaces, bool pickable)
    {
        lines = shown(std::move(lines));
        if (!lines->segments.empty())
            scene.lines.push_back(
                {std::move(lines), world, node.id, throughSurfaces, pickable && !node.locked});
    }
    void addPoints(std::shared_ptr<const PointSet> points)
    {
        points = shown(std::move(points));
        if (!points->points.empty())
            scene.points.push_back({std::move(points), world, node.id, false});
    }

    /// Some branches alone are open where the others were.
    void closed(MeshItem* branches) const
    {
        if (branches)
            branches->closed = !isIsolated();
    }
    [[nodiscard]] Material leaf() const
    {
        return tree.foliage ? leavesMaterial(*tree.foliage, node.params.leafPictures) : leavesMaterial();
    }
    [[nodiscard]] Material fruit() const
    {
        return tree.foliage ? applesMaterial(tree.foliage->fruit.kind, node.params.fruitPictures)
                            : applesMaterial();
    }
    [[nodiscard]] Material bark() const { return barkMaterial(node.params.bark, node.params.barkPictures); }
    void fine()
    {
        const std::size_t first = scene.meshes.size();
        if (!tree.branches)
            addMesh(tree.draftTubes, openBark(node.params.bark, node.params.barkPictures));
        else if (!pictured())
            closed(addMesh({tree.branches, &tree.branches->mesh}, bark()));
        addMesh(tree.cuts, woodMaterial());
        if (view.leaves)
            addFoliage(ScenePart::LeafCopies, tree.leaves, leaf(), FoliageModel::Fine);
        if (view.apples)
            addFoliage(ScenePart::AppleCopies, tree.apples, fruit(), FoliageModel::Fine);
        blow(std::span(scene.meshes).subspan(first));
        if (!tree.foliage || !view.leaves || isIsolated())
            return;
        const double alpha = trunkRadius(node.params);
        const auto crown = cache.get<CrownLight>(ScenePart::Crown, tree.foliage, tree.foliage, {alpha},
                                                 [&] { return crownLight(*tree.foliage, alpha); });
        for (std::size_t i = first; i < scene.meshes.size() && !crown->light.empty(); ++i)
            scene.meshes[i].crown = crown;
    }
    /// Parts that belong to no branch stay where they are.
    void blow(std::span<MeshItem> items)
    {
        constexpr double reach = 0.25; // of the height: a strong wind takes nothing farther
        if (view.wind == WindProfile::None || !tree.branches || !tree.skeleton || !tree.simplified)
            return;
        const double direction = node.params.physics.windDirection;
        const auto wind = cache.get<TreeWind>(
            ScenePart::Wind, tree.simplified, tree.leaves.key(), {double(view.wind), direction}, [&] {
                return treeWind(view.wind, direction, *tree.skeleton, *tree.simplified, tree.leaves.get(),
                                tree.foliage.get());
            });
        for (MeshItem& item : items) {
            const bool hasBranches = item.copies || item.mesh->branch.size() == item.mesh->positions.size();
            if (wind->profile == WindProfile::None || !hasBranches)
                continue;
            item.motion.wind = cache.get<ItemWind>(ScenePart::WindOfItem, wind, item.mesh.key(), {},
                                                   [&] { return windOf(wind, item); });
            item.box = item.box.grown(reach * wind->tree.height);
        }
    }
    [[nodiscard]] ItemWind windOf(const std::shared_ptr<const TreeWind>& wind, const MeshItem& item) const
    {
        if (!item.copies)
            return windOfMesh(wind, *item.mesh);
        if (item.material.name != leaf().name)
            return windOfFruit(wind, *item.copies);
        return windOfLeaves(wind, *item.copies, tree.foliage->leaves, shownBranches());
    }
    /// The branches with their texture coordinates, which may be none.
    std::shared_ptr<const TexturedMesh> mapped()
    {
        return cache.get<TexturedMesh>(
            ScenePart::Textured, tree.branches, tree.texture, {node.params.texture.tileSize},
            [&] { return texturedMesh(*tree.branches, *tree.texture, node.params); });
    }
    /// Null where nothing of it is shown.
    MeshItem* addMapped(const std::shared_ptr<const TexturedMesh>& made)
    {
        MeshItem* item = addMesh({made, &made->mesh}, bark());
        if (!item)
            return nullptr;
        closed(item);
        if (item->mesh.get() == &made->mesh)
            item->split = {{tree.branches, &tree.branches->mesh}, {made, &made->coordinates->vertex}};
        return item;
    }
    /// The branches with a picture of bark; false where there is none.
    bool pictured()
    {
        if (!isPictured(node.params) || !tree.texture ||
            (!view.waitsForBark && !isBarkReady(*tree.texture, node.params)))
            return false;
        const auto made = mapped();
        if (made->mesh.empty())
            return false;
        MeshItem* item = addMapped(made);
        if (!item)
            return true;
        item->images = imagesOf(cache, item->material);
        const BarkParams& bark = node.params.bark;
        const std::uint64_t hash = barkHash(bark);
        const std::shared_ptr<const void> anybody; // trees of the same bark share it
        if (!item->images)
            item->bark =
                cache.get<BarkMaps>(ScenePart::Bark, anybody, anybody, {highHalf(hash), lowHalf(hash)},
                                    [&] { return barkMaps(bark, shownBarkSize).value(); });
        return true;
    }
    /// Without leaves in front; as a plain mesh where there are no coordinates.
    void textured(Paint paint)
    {
        if (!tree.branches) {
            addMesh(tree.draftTubes, openBark());
            return;
        }
        const auto made = mapped();
        if (made->mesh.empty()) {
            fine();
            return;
        }
        MeshItem* item = addMapped(made);
        if (!item)
            return;
        item->paint = paint;
        const double tileSize = made->coordinates->tileSize;
        TextureSummary& all = scene.texture;
        all.tileSize = all.triangles == 0 ? tileSize : std::min(all.tileSize, tileSize);
        all.triangles += made->report.triangles;
        all.stretched += made->report.stretched;
        all.mirrored += made->report.mirrored;
    }
    void rough()
    {
        if (!tree.simplified)
            return;
        const Skeleton& skeleton = tree.simplified->skeleton;
        const auto sides = static_cast<int>(node.params.sections.radialDivisions);
        MeshArrays& arrays = cache.roughArrays();
        addMesh(cache.get<TriangleMesh>(
                    ScenePart::RoughBranches, tree.simplified, tree.simplified, {double(sides)},
                    [&] { return arrays.share(buildRoughBranches(skeleton, sides, arrays.take())); }),
                openBark());
        if (!tree.foliage)
            return;
        const double alpha = trunkRadius(node.params);
        if (view.leaves)
            addFoliage(ScenePart::LeafCopies,
                       cache.get<TriangleMesh>(
                           ScenePart::RoughLeaves, tree.simplified, tree.foliage, {alpha},
                           [&] { return buildLeaves(skeleton, *tree.foliage, alpha, FoliageModel::Rough); }),
                       leaf(), FoliageModel::Rough);
        if (view.apples)
            addFoliage(ScenePart::AppleCopies,
                       cache.get<TriangleMesh>(
                           ScenePart::RoughApples, tree.simplified, tree.foliage, {alpha},
                           [&] { return buildApples(skeleton, *tree.foliage, alpha, FoliageModel::Rough); }),
                       fruit(), FoliageModel::Rough);
    }
    void skeleton()
    {
        if (!tree.skeleton)
            return;
        const std::vector<Index> none;
        const bool known = tree.simplified && tree.simplified->mergedInto.size() == tree.skeleton->size();
        const std::vector<Index>& ids = known ? tree.simplified->mergedInto : none;
        addLines(cache.get<LineSet>(ScenePart::SkeletonLines, tree.skeleton, tree.simplified, {},
                                    [&] { return skeletonLines(*tree.skeleton, ids); }),
                 false, true);
        addPoints(cache.get<PointSet>(ScenePart::SkeletonMarks, tree.skeleton, tree.simplified, {},
                                      [&] { return nodeMarks(*tree.skeleton, ids); }));
    }
    void simplified()
    {
        if (!tree.simplified)
            return;
        addLines(cache.get<LineSet>(ScenePart::SimplifiedLines, tree.simplified, tree.simplified, {},
                                    [&] { return skeletonLines(tree.simplified->skeleton); }),
                 false, true);
        addPoints(cache.get<PointSet>(ScenePart::SimplifiedMarks, tree.simplified, tree.simplified, {},
                                      [&] { return nodeMarks(tree.simplified->skeleton); }));
        if (tree.skeleton)
            addPoints(cache.get<PointSet>(ScenePart::RemovedMarks, tree.skeleton, tree.simplified, {},
                                          [&] { return removedMarks(*tree.skeleton, *tree.simplified); }));
    }
    void sections()
    {
        if (!tree.simplified || !tree.sections)
            return;
        const auto sides = static_cast<int>(node.params.sections.radialDivisions);
        addLines(cache.get<LineSet>(
                     ScenePart::SectionLines, tree.simplified, tree.sections, {double(sides)},
                     [&] { return sectionLines(tree.simplified->skeleton, *tree.sections, sides); }),
                 false, true);
    }
    /// Where the selected branches are behind the leaves.
    void selectedCurves()
    {
        const bool lines = rowOf(view.mode).shown == Shown::Lines;
        if (lines || !tree.simplified || view.branchNode != node.id || view.branches.empty() ||
            view.branches.size() > mostCurves)
            return;
        addLines(cache.get<LineSet>(ScenePart::SelectedCurves, tree.simplified, tree.simplified,
                                    asNumbers(view.branches),
                                    [&] { return branchCurves(tree.simplified->skeleton, view.branches); }),
                 true, false);
        if (!scene.lines.empty())
            scene.lines.back().outlined = OutlinedLines::All; // the thinnest twig has its line
    }
    void frames()
    {
        if (!tree.simplified || !tree.sections)
            return;
        const Skeleton& of = tree.simplified->skeleton;
        const bool all = view.frames == FrameDisplay::All;
        if (all || (view.frames == FrameDisplay::Selection && view.branchNode == node.id &&
                    !view.branches.empty())) {
            std::vector<Index> wanted = view.branches;
            if (all && isIsolated()) {
                wanted = view.isolatedBranches;
            } else if (all) {
                wanted.resize(of.size());
                std::iota(wanted.begin(), wanted.end(), Index(0));
            }
            addLines(cache.get<LineSet>(ScenePart::FrameArrows, tree.simplified, tree.sections,
                                        all && !isIsolated() ? std::vector<double>{-1.0} : asNumbers(wanted),
                                        [&] { return frameArrows(of, *tree.sections, wanted); }),
                     !all, false);
        }
        const InspectedSection& at = view.inspected;
        if (at.node == node.id) {
            const auto sides = static_cast<int>(node.params.sections.radialDivisions);
            addLines(cache.get<LineSet>(
                         ScenePart::Inspected, tree.simplified, tree.sections,
                         {double(at.branch), double(at.section), double(sides)},
                         [&] { return inspectedLines(of, *tree.sections, at.branch, at.section, sides); }),
                     true, false);
        }
    }
    void all()
    {
        switch (view.mode) {
        case DisplayMode::Skeleton:
            skeleton();
            break;
        case DisplayMode::Simplified:
            simplified();
            break;
        case DisplayMode::Rough:
            rough();
            break;
        case DisplayMode::Sections:
            sections();
            break;
        case DisplayMode::Mesh:
            fine();
            break;
        case DisplayMode::Checker:
            textured(Paint::Checker);
            break;
        case DisplayMode::Stretch:
            textured(Paint::Stretch);
            break;
        }
        selectedCurves();
        frames();
    }
};

/// Appends nodes that are one mesh each. Those that are equal share it.
struct ObjectItems
{
    ScenePartCache& cache;
    RenderScene& scene;

    std::shared_ptr<const TriangleMesh> meshOf(const Node& node, const NodeParams& params)
    {
        return cache.get<TriangleMesh>(ScenePart::Object, node.mesh.pointer(), node.mesh.pointer(),
                                       ownNumbers(node.kind, params), [&] {
                                           const SharedMesh mesh = objectMesh(node, params);
                                           return mesh ? mesh : std::make_shared<const TriangleMesh>();
                                       });
    }
    void add(const Node& node, const NodeParams& params, const glm::dmat4& world)
    {
        MeshItem item;
        item.mesh = meshOf(node, params);
        if (item.mesh->empty())
            return;
        item.box = cache.box(item.mesh);
        item.material = nodeMaterial(node, params);
        item.images = imagesOf(cache, item.material);
        if (item.images && (item.mesh->uv.empty() || !item.mesh->uvTriangles.empty()))
            item.mesh = cache.get<TriangleMesh>(ScenePart::ObjectTexture, item.mesh.key(), item.mesh.key(),
                                                {}, [&] { return splitByTexture(*item.mesh); });
        item.world = world;
        item.node = node.id;
        item.pickable = !node.locked;
        scene.meshes.push_back(std::move(item));
    }
};

} // namespace

bool isBarkReady(const TextureStage& texture, const NodeParams& params)
{
    std::stop_source stopped;
    stopped.request_stop();
    return texture.coordinates(params.texture, {stopped.get_token(), {}}).has_value();
}

SceneView SceneView::ofPrototypes() const
{
    SceneView out;
    out.leaves = leaves;
    out.apples = apples;
    out.waitsForBark = waitsForBark;
    out.wind = wind;
    out.timeSeconds = timeSeconds;
    return out;
}

SceneBuilder::SceneBuilder()
    : m_cache(std::make_unique<ScenePartCache>())
    , m_ground(std::make_unique<GroundHeight>())
    , m_scatters(std::make_unique<ScatterMemory>())
{
}

SceneBuilder::~SceneBuilder() = default;

RenderScene SceneBuilder::build(const Scene& scene, const ResultOf& resultOf, const SceneView& view)
{
    EvaluatedScene now(scene, view.timeSeconds);
    return build(now, resultOf, view);
}

RenderScene SceneBuilder::build(EvaluatedScene& now, const ResultOf& resultOf, const SceneView& view)
{
    const Scene& scene = now.scene();
    m_cache->beginBuild();
    RenderScene built;
    std::optional<FigureTree> first;
    ObjectItems objects{*m_cache, built};
    const SceneView plainly = view.ofPrototypes();
    const auto alone = [&](const Node& prototype, const glm::dmat4& at) {
        RenderScene aside;
        if (isObject(prototype.kind))
            ObjectItems{*m_cache, aside}.add(prototype, now.params(prototype), at);
        else if (const TreeResult* tree = resultOf(prototype.id))
            TreeItems{*m_cache, aside, plainly, prototype, *tree, at}.all();
        return std::move(aside.meshes);
    };
    TreeGrounds grounds(*m_cache, built, view.meadow && view.mode == DisplayMode::Mesh);
    for (std::size_t i = 0; i < scene.nodes().size(); ++i) {
        const Node& node = scene.nodes()[i];
        if (node.kind == NodeKind::Group || !scene.isShown(node.id) || isPrototype(scene, node.id))
            continue;
        const glm::dmat4& world = now.transforms()[i].geometry;
        if (node.kind == NodeKind::Camera) {
            const bool isSelected =
                std::ranges::find(view.selectedNodes, node.id) != view.selectedNodes.end();
            if (view.cameras && node.id != view.seenThrough)
                addCamera(built, *m_cache, node, now.params(node).camera, world, isSelected);
        } else if (node.kind == NodeKind::Scatter) {
            Node aged = node;
            aged.params = now.params(node);
            addCrowd(built, *m_cache, *m_scatters, {scene, aged, world, resultOf, view, alone});
        } else if (node.kind == NodeKind::Arm)
            addArm(built, *m_cache, node, now.params(node), world, view.mode);
        else if (isObject(node.kind))
            objects.add(node, now.params(node), world);
        else if (const TreeResult* tree = resultOf(node.id)) {
            TreeItems{*m_cache, built, view, node, *tree, world}.all();
            grounds.add(node, now.params(node), *tree, world);
            if (!first && tree->skeleton && tree->skeleton->size() > 0)
                first = FigureTree{tree->skeleton->p0[0], tree->skeleton->a0[0], world,
                                   groundOf(now.params(node))};
        }
    }
    grounds.finish(m_ground->of(scene, built));
    outlineSelected(built, *m_cache, scene, resultOf, view);
    updateHighlights(built, resultOf, view);
    built.updateBoxes();
    if (view.figure) {
        addFigure(built, first);
        built.updateBoxes();
    }
    if (view.crowns)
        addCrowns(built, now, view.selectedNodes);
    m_cache->dropUnused();
    return built;
}

RenderScene sceneOfMesh(TriangleMesh mesh)
{
    if (mesh.normals.size() != mesh.positions.size())
        computeNormals(mesh);
    RenderScene scene;
    MeshItem item;
    item.box = meshBox(mesh);
    item.material = barkMaterial();
    if (!mesh.colours.empty())
        item.material.colour = glm::u8vec3(255);
    item.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    scene.meshes.push_back(std::move(item));
    scene.updateBoxes();
    return scene;
}

} // namespace ramure
