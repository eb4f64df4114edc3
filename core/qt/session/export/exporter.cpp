#include "core/qt/session/export/exporter.h"

#include "core/io/copy_list.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/text/material_file.h"
#include "core/io/pivot_files.h"
#include "core/params/source_facts.h"
#include "core/qt/session/export/export_bones.h"
#include "core/qt/session/export/foliage_copies.h"
#include "core/qt/session/export/growth_export.h"
#include "core/qt/session/export/level_export.h"
#include "core/qt/session/export/scatter_export.h"
#include "core/qt/session/export/scene_counts.h"
#include "core/qt/session/export/season_export.h"
#include "core/qt/session/export/wind_export.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/scene/object_mesh.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesh/transformed.h"
#include "core/surface/mesher/rough_model.h"
#include "core/surface/season/foliage_on_day.h"
#include "core/surface/texture/object_texture.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

namespace ramure {

namespace {

/// A node to export.
struct Candidate
{
    const Node* node;
    Index number;       ///< of the node in the scene
    std::string suffix; ///< of a tree: of its parts' names; of another node its own name in the file
    glm::dmat4 world{1.0};
};

/// Each by the name of its node; the second "Box", or one that is named as a part of a tree, is "Box_2".
void nameShapes(std::vector<Candidate>& shapes, const std::vector<Candidate>& trees)
{
    std::set<std::string> taken;
    for (const Candidate& tree : trees)
        for (const char* part : {"branches", "leaves", "fruit"})
            taken.insert(part + tree.suffix);
    std::map<std::string, int> numbers;
    for (Candidate& shape : shapes) {
        const std::string& name = shape.node->name;
        int& number = numbers.try_emplace(name, 1).first->second;
        shape.suffix = name;
        while (!taken.insert(shape.suffix).second)
            shape.suffix = std::string(name).append("_").append(std::to_string(++number));
    }
}

Expected<std::vector<Candidate>> candidates(EvaluatedScene& now, const ExportOptions& options)
{
    const Scene& scene = now.scene();
    for (const NodeId id : options.nodes)
        if (!scene.find(id))
            return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(id)});
    const std::vector<NodeTransforms>& transforms = now.transforms();
    const glm::dmat4 intoFile = options.space.matrix();
    std::vector<Candidate> trees, objects;
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        const Node& node = scene.nodes()[i];
        if (isExported(scene, options, node))
            (isShape(node.kind) ? objects : trees)
                .push_back(
                    {&node,
                     static_cast<Index>(i),
                     {},
                     options.space.isOwn() ? transforms[i].geometry : intoFile * transforms[i].geometry});
    }
    if (trees.empty() && objects.empty() && scattersOf(scene, options).empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is nothing visible to export"));
    if (trees.size() > 1)
        for (std::size_t i = 0; i < trees.size(); ++i)
            trees[i].suffix.append("_").append(std::to_string(i + 1));
    nameShapes(objects, trees);
    trees.insert(trees.end(), objects.begin(), objects.end());
    return trees;
}

/// The three meshes of one tree in tree space, those that were asked for.
struct TreeMeshes
{
    std::shared_ptr<const TriangleMesh> branches, leaves, apples;
    std::shared_ptr<const Foliage> foliage{};   ///< that leaves and apples were made of
    std::shared_ptr<const TriangleMesh> cuts{}; ///< go with the branches
};

/// Branches, leaves, apples that the results hold: shared, not copied.
TreeMeshes fineMeshes(const TreeResult& tree, std::uint8_t parts)
{
    TreeMeshes meshes;
    if ((parts & exportBranches) && tree.branches) {
        meshes.branches = {tree.branches, &tree.branches->mesh};
        meshes.cuts = tree.cuts;
    }
    if (parts & exportLeaves)
        meshes.leaves = tree.leaves;
    if (parts & exportApples)
        meshes.apples = tree.apples;
    meshes.foliage = tree.foliage;
    return meshes;
}

Expected<TreeMeshes> roughMeshes(const TreeResult& tree, const NodeParams& params, std::uint8_t parts,
                                 const Progress& progress)
{
    const Skeleton& skeleton = tree.simplified->skeleton;
    const double alpha = trunkRadius(params);
    TreeMeshes meshes;
    if (parts & exportBranches)
        meshes.branches = std::make_shared<TriangleMesh>(
            buildRoughBranches(skeleton, static_cast<int>(params.sections.radialDivisions)));
    if (!(parts & (exportLeaves | exportApples)))
        return meshes;
    auto placed = foliageOf(skeleton, params, progress);
    RAMURE_TRY(placed);
    meshes.foliage = std::make_shared<const Foliage>(std::move(*placed));
    const Foliage& foliage = *meshes.foliage;
    if (parts & exportLeaves)
        meshes.leaves =
            std::make_shared<TriangleMesh>(buildLeaves(skeleton, foliage, alpha, FoliageModel::Rough));
    if (parts & exportApples)
        meshes.apples =
            std::make_shared<TriangleMesh>(buildApples(skeleton, foliage, alpha, FoliageModel::Rough));
    return meshes;
}

/// Makes copies with texture coordinates.
Expected<void> addTexture(TreeMeshes& meshes, const TextureStage& texture, const NodeParams& params,
                          const Progress& progress)
{
    if (meshes.branches) {
        const auto made = texture.coordinates(params.texture, progress);
        RAMURE_TRY(made);
        const auto branches = std::make_shared<TriangleMesh>(*meshes.branches);
        wear(*branches, **made);
        meshes.branches = branches;
    }
    if (meshes.leaves) {
        const auto leaves = std::make_shared<TriangleMesh>(*meshes.leaves);
        addLeafTexture(*leaves, leafForm(params.leaf));
        meshes.leaves = leaves;
    }
    if (meshes.apples) {
        const auto apples = std::make_shared<TriangleMesh>(*meshes.apples);
        addAppleTexture(*apples, meshes.foliage ? meshes.foliage->fruit : fruitForm(params.fruit));
        if (!params.fruitPictures.colour.empty())
            apples->colours.clear(); // the picture takes their place
        meshes.apples = apples;
    }
    return {};
}

/// \param motion whose skins the meshes have; none: they are as they stand. \param sprays that stand for the
/// leaves; null: none
void addMeshes(ExportScene& out, const Candidate& tree, const TreeMeshes& meshes, const NodeParams& params,
               const NodeMotion& motion, const std::shared_ptr<const CardAtlas>& sprays = {})
{
    const auto add = [&](const char* name, const std::shared_ptr<const TriangleMesh>& mesh,
                         const std::shared_ptr<const Skin>& skin, const Material& material,
                         std::size_t pieces) {
        if (!mesh || mesh->empty())
            return;
        out.meshes.push_back({name + tree.suffix, tree.number, mesh, materialIn(out, material), skin});
        out.meshes.back().pieces = static_cast<Index>(pieces);
    };
    const Foliage none, &foliage = meshes.foliage ? *meshes.foliage : none;
    add("branches", meshes.branches, motion.branches,
        barkMaterial(tree.node->params.bark, tree.node->params.barkPictures), 0);
    if (meshes.cuts)
        add("cuts", meshes.cuts,
            motion.bones ? std::make_shared<const Skin>(bindRigidly(*meshes.cuts)) : nullptr, woodMaterial(),
            0);
    const Material leaves = leavesMaterial(foliage, params.leafPictures);
    add("leaves", meshes.leaves, motion.leaves, sprays ? spraysMaterial(leaves, sprays) : leaves,
        foliage.leaves.size());
    add("fruit", meshes.apples, motion.apples, applesMaterial(foliage.fruit.kind, params.fruitPictures),
        foliage.apples.size());
    out.frames.front().bones[tree.number] = motion.bones;
}

/// Leaves and apples as instances in the place of meshes.
void takeInstances(ExportScene& out, const Candidate& tree, TreeMeshes& meshes,
                   const FoliageInstances& instances)
{
    const auto add = [&](const char* name, std::shared_ptr<const TriangleMesh>& mesh,
                         ExportCopies (*listed)(const FoliageInstances&), const Material& material) {
        if (mesh && !mesh->empty()) {
            ExportCopies& added = out.copies.emplace_back(listed(instances));
            added.name = name + tree.suffix;
            added.node = tree.number;
            added.material = materialIn(out, material);
        }
        mesh.reset();
    };
    add("leaves", meshes.leaves, &leafInstances,
        leavesMaterial(instances.foliage, instances.params.leafPictures));
    add("fruit", meshes.apples, &appleInstances,
        applesMaterial(instances.foliage.fruit.kind, instances.params.fruitPictures));
}

/// Children share their parent's end point, so that the lines hang together.
void addLines(LinePart& lines, const Skeleton& skeleton, const glm::dmat4& world)
{
    const auto place = [&](const glm::dvec3& p) {
        lines.positions.emplace_back(glm::dvec3(world * glm::dvec4(p, 1.0)));
        return static_cast<Index>(lines.positions.size() - 1);
    };
    std::vector<Index> endOf(skeleton.size());
    for (Index i = 0; i < skeleton.size(); ++i) {
        const Index parent = skeleton.parent[i];
        const Index from = parent == noIndex ? place(skeleton.p0[i]) : endOf[parent];
        endOf[i] = place(skeleton.p1[i]);
        lines.lines.emplace_back(from, endOf[i]);
    }
}

/// Which of several nodes an error is about.
Error named(Error error, const Candidate& node)
{
    const bool isOnlyTree = node.suffix.empty() && node.node->kind == NodeKind::Tree;
    return isOnlyTree ? error : named(*node.node, std::move(error));
}

Stage lastStage(const ExportOptions& options)
{
    if (options.model != ExportModel::Mesh)
        return Stage::Simplified;
    return (options.parts & (exportLeaves | exportApples)) ? Stage::Foliage : Stage::Mesh;
}

/// The chain of an arm, as it stands in the world.
void addChain(LinePart& lines, const NodeParams& params, const glm::dmat4& world)
{
    const ArmChain chain(params.joints);
    const glm::dmat4 place = world * armUpright();
    for (const glm::dvec3& point : chain.points()) {
        const auto at = static_cast<Index>(lines.positions.size());
        lines.positions.emplace_back(glm::dvec3(place * glm::dvec4(point, 1.0)));
        if (&point != &chain.points().front())
            lines.lines.emplace_back(at - 1, at);
    }
}

/// The colours of a mesh in the light of its node's own: white leaves them as they are.
void tint(std::vector<glm::u8vec3>& colours, const glm::dvec3& colour)
{
    for (glm::u8vec3& c : colours)
        c = glm::u8vec3(glm::dvec3(c) * colour + 0.5);
}

/// The mesh of anything but trees; of an arm as it rests, with its skin.
Expected<ExportMesh> shapeMesh(const Node& node, EvaluatedScene& scene, const Progress& progress)
{
    ExportMesh out;
    if (node.kind != NodeKind::Arm)
        return scene.solid(node, progress).map([&](std::shared_ptr<const TriangleMesh> mesh) {
            out.mesh = std::move(mesh);
            return out;
        });
    const NodeParams& params = scene.params(node);
    auto made = armSolid(params, node.mesh.pointer().get(), shownArmPart(params));
    if (!made)
        return fail(named(node, std::move(made.error())));
    const auto shape = std::make_shared<const ArmShape>(std::move(*made));
    out.mesh = {shape, &shape->mesh};
    out.skin = {shape, &shape->skin};
    return out;
}

/// Anything but a tree, under the name of its node.
Expected<void> addShape(ExportScene& out, const Candidate& shape, EvaluatedScene& scene,
                        const ExportOptions& options, const Progress& progress)
{
    const Node& node = *shape.node;
    if (auto posed = scene.pose(node, progress); !posed)
        return posed;
    const NodeParams& params = scene.params(node);
    if (options.model == ExportModel::Skeleton) {
        if (node.kind == NodeKind::Arm)
            addChain(*out.lines, params, shape.world);
        return {};
    }
    auto made = shapeMesh(node, scene, progress);
    RAMURE_TRY(made);
    if (!made->mesh || made->mesh->empty())
        return {};
    made->name = shape.suffix;
    made->node = shape.number;
    Material material = surfaceMaterial(glm::u8vec3(params.surface.color * 255.0 + 0.5));
    const bool isPictured =
        !params.surfacePictures.isEmpty() && hasParam(node.kind, *findParam("surface.colourPicture"));
    if (isPictured) {
        material = nodeMaterial(node, params);
        if (options.texture && made->mesh->uv.empty()) {
            TriangleMesh own = *made->mesh;
            addBoxTexture(own);
            made->mesh = std::make_shared<const TriangleMesh>(std::move(own));
        }
    }
    made->material = materialIn(out, material);
    // Files have normals of length 1, also where a mesh is not moved.
    const bool isInPlace = shape.world == glm::dmat4(1.0) && !made->skin;
    if (isInPlace || !made->mesh->colours.empty()) {
        TriangleMesh own = isInPlace ? transformed(*made->mesh, shape.world) : *made->mesh;
        tint(own.colours, params.surface.color);
        made->mesh = std::make_shared<const TriangleMesh>(std::move(own));
    }
    if (made->skin) {
        out.frames.front().bones[shape.number] = armMotion(params, params.joints).bones;
        out.nodes[shape.number].bones = bonesOf(params);
    }
    out.meshes.push_back(std::move(*made));
    return {};
}

/// As leaves and fruit stand in no season.
Expected<void> withoutDay(TreeMeshes& meshes, const PosedTree& posed, const NodeParams& params)
{
    const TreeResult& tree = posed.rest;
    if (!tree.placed || tree.placed == tree.foliage)
        return {};
    if (posed.motion.bones) {
        auto error =
            fail(ErrorCode::Invalid,
                 RAMURE_NOOP("variants of the seasons are those of a tree at rest, or without a day"));
        error.value().path = "season.day";
        return error;
    }
    const double alpha = trunkRadius(params);
    const Skeleton& skeleton = tree.simplified->skeleton;
    meshes.foliage = tree.placed;
    if (meshes.leaves)
        meshes.leaves = std::make_shared<const TriangleMesh>(
            buildLeaves(skeleton, *tree.placed, alpha, FoliageModel::Fine));
    if (meshes.apples)
        meshes.apples = std::make_shared<const TriangleMesh>(
            buildApples(skeleton, *tree.placed, alpha, FoliageModel::Fine));
    return {};
}

/// The continuous mesh, with its skin where it moves.
Expected<void> addFineTree(ExportScene& out, const Candidate& tree, EvaluatedScene& scene,
                           const ExportOptions& options, const Progress& progress)
{
    const auto posed = scene.posedTree(*tree.node, lastStage(options), !options.clip.empty(), progress);
    RAMURE_TRY(posed);
    const NodeParams& params = scene.params(*tree.node);
    TreeMeshes meshes = fineMeshes(posed->rest, options.parts);
    TreeSeasons seasons;
    if (options.variants && meshes.foliage && meshes.foliage->form.shape != LeafShape::Faithful) {
        RAMURE_TRY(withoutDay(meshes, *posed, params));
        seasons = seasonsOf(out, *meshes.foliage, posed->rest.simplified->skeleton, params);
    }
    if (options.instances && meshes.foliage)
        takeInstances(out, tree, meshes,
                      {*meshes.foliage, posed->rest.simplified->skeleton, params, posed->motion,
                       FoliageModel::Fine, options.texture, !options.clip.empty()});
    if (options.texture)
        if (auto done = addTexture(meshes, *posed->rest.texture, params, progress); !done)
            return done;
    out.nodes[tree.number].bones =
        bonesOf(posed->rest.simplified->skeleton, posed->rest.foliage.get(), posed->motion);
    const std::size_t from = out.meshes.size();
    addMeshes(out, tree, meshes, params, posed->motion);
    tellSeasons(out, tree.suffix, seasons);
    const WindFoliage foliage{meshes.foliage.get()};
    RAMURE_TRY(addWind(out, from, tree.suffix, options.wind, *posed, {&foliage, 1}));
    addCollision(out, tree.number, from, posed->rest.simplified->skeleton, options);
    return {};
}

/// One after the other, all with one skeleton; each mesh after the first stands for that one's.
Expected<void> addLevels(ExportScene& out, const Candidate& tree, EvaluatedScene& scene,
                         const ExportOptions& options, const Progress& progress)
{
    const auto made = levelsOf(*tree.node, scene, options, progress);
    RAMURE_TRY(made);
    out.nodes[tree.number].bones =
        bonesOf(made->tree.rest.simplified->skeleton, made->tree.rest.foliage.get(), made->tree.motion);
    std::map<std::string, Index> finest;
    std::vector<WindFoliage> foliage;
    const std::size_t begun = out.meshes.size();
    for (std::size_t k = 0; k < made->levels.size(); ++k) {
        const std::size_t from = out.meshes.size();
        NodeMotion motion = made->tree.motion;
        motion.branches = made->skins[k].bark;
        motion.leaves = made->skins[k].leaves;
        motion.apples = made->skins[k].apples;
        const TreeLevel& level = made->levels[k];
        foliage.push_back({level.foliage.get(), level.leafOf});
        const NodeParams& params = scene.params(*tree.node);
        addMeshes(out, tree, {level.bark, level.leaves, level.apples, level.foliage, level.cuts}, params,
                  motion, level.sprays);
        if (level.billboard)
            out.meshes.push_back({"billboard" + tree.suffix, tree.number, level.billboard,
                                  materialIn(out, billboardMaterial(level.billboardAtlas))});
        for (std::size_t i = from; i < out.meshes.size(); ++i) {
            ExportMesh& mesh = out.meshes[i];
            const auto first = finest.try_emplace(mesh.name, static_cast<Index>(i));
            tellLevel(mesh, *made, k);
            mesh.finest = level.billboard ? static_cast<Index>(begun) // in the place of all
                          : first.second  ? noIndex
                                          : first.first->second;
        }
    }
    RAMURE_TRY(addWind(out, begun, tree.suffix, options.wind, made->tree, foliage));
    addCollision(out, tree.number, begun, made->tree.rest.simplified->skeleton, options);
    return {};
}

Expected<void> addTree(ExportScene& out, const Candidate& tree, EvaluatedScene& scene,
                       const ExportOptions& options, const Progress& progress)
{
    if (options.growthFrom > 0.0)
        return addGrowth(out, tree.number, tree.suffix, scene.params(*tree.node), options, progress);
    if (options.levels.isWanted())
        return addLevels(out, tree, scene, options, progress);
    if (options.model == ExportModel::Mesh)
        return addFineTree(out, tree, scene, options, progress);
    const auto result = scene.tree(*tree.node, lastStage(options), progress);
    RAMURE_TRY(result);
    if (options.model == ExportModel::Skeleton) {
        addLines(*out.lines, result->simplified->skeleton, tree.world);
        return {};
    }
    const NodeParams& params = scene.params(*tree.node);
    auto meshes = roughMeshes(*result, params, options.parts, progress);
    RAMURE_TRY(meshes);
    if (options.instances && meshes->foliage)
        takeInstances(
            out, tree, *meshes,
            {*meshes->foliage, result->simplified->skeleton, params, {}, FoliageModel::Rough, false});
    addMeshes(out, tree, *meshes, params, {});
    return {};
}

Expected<void> addNode(ExportScene& out, const Candidate& node, EvaluatedScene& scene,
                       const ExportOptions& options, const Progress& progress)
{
    if (!(std::abs(glm::determinant(glm::dmat3(node.world))) > 0.0))
        return fail(named({ErrorCode::Invalid,
                           RAMURE_NOOP("a scale of zero leaves nothing to export"),
                           {},
                           {},
                           "tree.scale"},
                          node));
    if (isShape(node.node->kind))
        return addShape(out, node, scene, options, progress);
    return addTree(out, node, scene, options, progress).map_error([&](Error error) {
        return named(std::move(error), node);
    });
}

/// Where everything is, and with which bones what has some.
Expected<void> addFrame(ExportScene& out, EvaluatedScene now, const std::vector<Candidate>& nodes,
                        const Progress& progress)
{
    ExportFrame frame{now.seconds(), now.transforms(), {}};
    frame.bones.resize(out.nodes.size());
    for (const Candidate& each : nodes) {
        const Node& node = *each.node;
        if (!out.frames.front().bones[each.number])
            continue;
        if (isShape(node.kind)) {
            if (auto posed = now.pose(node, progress); !posed)
                return posed;
            frame.bones[each.number] = armMotion(now.params(node), now.params(node).joints).bones;
            continue;
        }
        auto posed = now.posedTree(node, Stage::Foliage, true, progress);
        if (!posed)
            return fail(named(std::move(posed.error()), each));
        frame.bones[each.number] = std::move(posed->motion.bones);
    }
    out.frames.push_back(std::move(frame));
    return {};
}

/// All nodes, without meshes, at the scene's time.
ExportScene bareScene(EvaluatedScene& now, const ExportOptions& options)
{
    ExportScene out;
    std::map<NodeId, Index> numbers;
    for (const Node& node : now.scene().nodes()) {
        const auto parent = numbers.find(node.parent);
        numbers.emplace(node.id, static_cast<Index>(out.nodes.size()));
        out.nodes.push_back({node.name, parent == numbers.end() ? noIndex : parent->second,
                             now.params(node).skin.method, node.kind == NodeKind::Arm});
        if (node.kind == NodeKind::Camera && isChosen(now.scene(), options, node))
            out.cameras.push_back({static_cast<Index>(out.nodes.size() - 1), now.params(node).camera});
    }
    out.frames.push_back({now.seconds(), now.transforms(), {}});
    out.frames.back().bones.resize(out.nodes.size());
    out.space = options.space;
    if (options.model == ExportModel::Skeleton)
        out.lines = LinePart{"skeleton", {}, {}};
    return out;
}

} // namespace

Expected<ExportScene> collectExport(EvaluatedScene scene, const ExportOptions& options,
                                    const Progress& progress)
{
    RAMURE_TRY(checkScatterExport(scene.scene(), options));
    const auto nodes = candidates(scene, options);
    RAMURE_TRY(nodes);
    ExportScene out = bareScene(scene, options);
    const std::vector<Index> scatters = scattersOf(scene.scene(), options);
    const auto count = static_cast<double>(nodes->size() + scatters.size() + options.clip.size());
    double done = 0.0;
    const auto next = [&] {
        const double from = std::exchange(done, done + 1.0) / count;
        return progress.part(from, done / count);
    };
    for (const Candidate& node : *nodes) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        RAMURE_TRY(addNode(out, node, scene, options, next()));
    }
    for (const Index number : scatters)
        RAMURE_TRY(addScatter(out, number, scene, options, &collectExport, next()));
    if (out.meshes.empty() && out.copies.empty() && !(out.lines && !out.lines->lines.empty()))
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("the chosen parts are empty: there is nothing to export"));
    for (const double seconds : options.clip)
        RAMURE_TRY(addFrame(out, scene.at(seconds), *nodes, next()));
    return out;
}

std::uint8_t usualParts(const FileFormat& format, bool instances)
{
    return instances || (format.holds & holdsObjects) ? exportAll : exportBranches;
}

Expected<void> exportScene(EvaluatedScene scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress)
{
    const auto format = findFormat(path, FormatUse::Write, options.write.ascii);
    RAMURE_TRY(format);
    if (!options.clip.empty() && options.instances && ((*format)->holds & holdsRiders) == 0)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("instances of leaves do not move: merge them, or write one moment"));
    if (auto fine = checkLevelExport(options, **format); !fine)
        return fine;
    RAMURE_TRY(checkWindExport(options, **format));
    RAMURE_TRY(checkGrowthExport(options, **format));
    ExportOptions wanted = options;
    wanted.levels = levelsIn(**format, options);
    wanted.copies = options.instances || ((*format)->holds & holdsCopies) != 0;
    const auto collected = collectExport(std::move(scene), wanted, progress.part(0.0, 0.5));
    RAMURE_TRY(collected);
    return writeExport(*collected, options, path, progress.part(0.5, 1.0));
}

Expected<void> writeExport(const ExportScene& scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress)
{
    const auto format = findFormat(path, FormatUse::Write, options.write.ascii);
    RAMURE_TRY(format);
    WriteOptions head = options.write;
    head.comment = options.space.comment();
    if (!scene.copies.empty() && ((*format)->holds & holdsCopies) == 0)
        if (auto listed = writeCopyList(path, scene, head, progress.part(0.0, 0.2)); !listed)
            return listed;
    if (auto written = writePivots(path, scene); !written)
        return written;
    if (!options.levels.isWanted() || isOneFile(**format, options))
        return (*format)->write(path, scene, head, progress.part(0.2, 1.0));
    return writeLevels(**format, path, scene, head, progress.part(0.2, 1.0));
}

} // namespace ramure
