#include "core/session/exporter.h"

#include "core/document/document.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/material_file.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/session/scene_counts.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/mesher/rough_model.h"

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
    std::string suffix; ///< of a tree: of its parts' names; of another node its own name in the file
    glm::dmat4 world{1.0};
};

/// Each by the name of its node; the second "Box", or one that is named as a part of a tree, is "Box_2".
void nameShapes(std::vector<Candidate>& shapes, const std::vector<Candidate>& trees)
{
    std::set<std::string> taken;
    for (const Candidate& tree : trees)
        for (const char* part : {"branches", "leaves", "apples"})
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
                     {},
                     options.space.isOwn() ? transforms[i].geometry : intoFile * transforms[i].geometry});
    }
    if (trees.empty() && objects.empty())
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
};

/// Branches, leaves, apples that the results hold: shared, not copied.
TreeMeshes fineMeshes(const TreeResult& tree, std::uint8_t parts)
{
    TreeMeshes meshes;
    if ((parts & exportBranches) && tree.branches)
        meshes.branches = {tree.branches, &tree.branches->mesh};
    if (parts & exportLeaves)
        meshes.leaves = tree.leaves;
    if (parts & exportApples)
        meshes.apples = tree.apples;
    return meshes;
}

Expected<TreeMeshes> roughMeshes(const TreeResult& tree, const NodeParams& params, std::uint8_t parts,
                                 const Progress& progress)
{
    const Skeleton& skeleton = tree.simplified->skeleton;
    const double alpha = params.turtle.alpha;
    TreeMeshes meshes;
    if (parts & exportBranches)
        meshes.branches = std::make_shared<TriangleMesh>(
            buildRoughBranches(skeleton, static_cast<int>(params.sections.radialDivisions)));
    if (!(parts & (exportLeaves | exportApples)))
        return meshes;
    const auto foliage = placeFoliage(skeleton, params.foliage, alpha, progress);
    if (!foliage)
        return fail(foliage.error());
    if (parts & exportLeaves)
        meshes.leaves =
            std::make_shared<TriangleMesh>(buildLeaves(skeleton, *foliage, alpha, FoliageModel::Rough));
    if (parts & exportApples)
        meshes.apples =
            std::make_shared<TriangleMesh>(buildApples(skeleton, *foliage, alpha, FoliageModel::Rough));
    return meshes;
}

/// Copies with texture coordinates: those of the tree at rest, which it keeps while it moves.
Expected<TreeMeshes> texturedMeshes(const TreeResult& tree, const NodeParams& params, std::uint8_t parts,
                                    const Progress& progress)
{
    const TreeMeshes plain = fineMeshes(tree, parts);
    TreeMeshes meshes;
    if (plain.branches) {
        const auto made = tree.texture->coordinates(params.texture, progress);
        if (!made)
            return fail(made.error());
        const auto branches = std::make_shared<TriangleMesh>(*plain.branches);
        branches->uv = (*made)->uv;
        branches->uvTriangles = (*made)->corners;
        meshes.branches = branches;
    }
    if (plain.leaves) {
        const auto leaves = std::make_shared<TriangleMesh>(*plain.leaves);
        addLeafTexture(*leaves);
        meshes.leaves = leaves;
    }
    if (plain.apples) {
        const auto apples = std::make_shared<TriangleMesh>(*plain.apples);
        addAppleTexture(*apples);
        meshes.apples = apples;
    }
    return meshes;
}

void addMeshes(ExportSet& set, const TreeMeshes& meshes, const glm::dmat4& world, const std::string& suffix)
{
    const auto add = [&](const char* name, const std::shared_ptr<const TriangleMesh>& mesh,
                         Material material) {
        if (!mesh || mesh->empty())
            return;
        const bool inPlace = world == glm::dmat4(1.0);
        set.meshes.push_back({name + suffix,
                              inPlace ? mesh : std::make_shared<TriangleMesh>(transformed(*mesh, world)),
                              std::move(material)});
    };
    add("branches", meshes.branches, barkMaterial());
    add("leaves", meshes.leaves, leavesMaterial());
    add("apples", meshes.apples, applesMaterial());
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

/// Anything but a tree, under the name of its node.
Expected<void> addShape(ExportSet& set, const Candidate& shape, EvaluatedScene& scene,
                        const ExportOptions& options, const Progress& progress)
{
    const Node& node = *shape.node;
    if (options.model == ExportModel::Skeleton) {
        if (auto posed = scene.pose(node, progress); !posed)
            return posed;
        if (node.kind == NodeKind::Arm)
            addChain(*set.lines, scene.params(node), shape.world);
        return {};
    }
    const auto mesh = scene.solid(node, progress);
    if (!mesh)
        return fail(mesh.error());
    if (!*mesh || (*mesh)->empty())
        return {};
    const auto placed = std::make_shared<TriangleMesh>(transformed(**mesh, shape.world));
    tint(placed->colours, scene.params(node).surface.color);
    set.meshes.push_back(
        {shape.suffix, placed, surfaceMaterial(glm::u8vec3(scene.params(node).surface.color * 255.0 + 0.5))});
    return {};
}

Expected<void> addTree(ExportSet& set, const Candidate& tree, EvaluatedScene& scene,
                       const ExportOptions& options, const Progress& progress)
{
    const glm::dmat4& world = tree.world;
    if (!(std::abs(glm::determinant(glm::dmat3(world))) > 0.0))
        return fail(named({ErrorCode::Invalid,
                           RAMURE_NOOP("a scale of zero leaves nothing to export"),
                           {},
                           {},
                           "tree.scale"},
                          tree));
    if (isShape(tree.node->kind))
        return addShape(set, tree, scene, options, progress);
    const auto result = scene.tree(*tree.node, lastStage(options), progress);
    if (!result)
        return fail(named(result.error(), tree));
    if (options.model == ExportModel::Skeleton)
        addLines(*set.lines, result->simplified->skeleton, world);
    if (options.model == ExportModel::Mesh && options.texture) {
        const auto meshes = texturedMeshes(*result, scene.params(*tree.node), options.parts, progress);
        if (!meshes)
            return fail(named(meshes.error(), tree));
        addMeshes(set, *meshes, world, tree.suffix);
    } else if (options.model == ExportModel::Mesh) {
        addMeshes(set, fineMeshes(*result, options.parts), world, tree.suffix);
    }
    if (options.model != ExportModel::Rough)
        return {};
    const auto meshes = roughMeshes(*result, scene.params(*tree.node), options.parts, progress);
    if (!meshes)
        return fail(named(meshes.error(), tree));
    addMeshes(set, *meshes, world, tree.suffix);
    return {};
}

} // namespace

std::vector<MeshPart> ExportSet::parts() const
{
    std::vector<MeshPart> out;
    out.reserve(meshes.size());
    for (const Entry& entry : meshes)
        out.push_back({entry.name, entry.mesh.get(), entry.material});
    return out;
}

static Expected<TreeResult> currentResult(const Document& document, NodeId id)
{
    const NodeResult* result = document.result(id);
    if (!result || !document.isCurrent(id))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the tree is still being computed"));
    if (result->error)
        return fail(*result->error);
    return result->tree;
}

TreeSource documentSource(const Document& document)
{
    std::map<NodeId, Expected<TreeResult>> results;
    for (const Node& node : document.scene().nodes())
        if (node.kind == NodeKind::Tree)
            results.emplace(node.id, currentResult(document, node.id));
    return [kept = std::move(results)](const Node& node, Stage, const Progress&) -> Expected<TreeResult> {
        const auto found = kept.find(node.id);
        if (found == kept.end())
            return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(node.id)});
        return found->second;
    };
}

Expected<ExportSet> collectExport(EvaluatedScene scene, const ExportOptions& options,
                                  const Progress& progress)
{
    const auto trees = candidates(scene, options);
    if (!trees)
        return fail(trees.error());
    ExportSet set;
    if (options.model == ExportModel::Skeleton)
        set.lines = LinePart{"skeleton", {}, {}};
    const auto count = static_cast<double>(trees->size());
    for (std::size_t i = 0; i < trees->size(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const Candidate& tree = (*trees)[i];
        const double from = static_cast<double>(i) / count;
        const auto added = addTree(set, tree, scene, options, progress.part(from, from + 1.0 / count));
        if (!added)
            return fail(added.error());
    }
    if (set.meshes.empty() && !(set.lines && !set.lines->lines.empty()))
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("the chosen parts are empty: there is nothing to export"));
    return set;
}

std::uint8_t usualParts(const FileFormat& format)
{
    return (format.holds & holdsObjects) ? exportAll : exportBranches;
}

Expected<void> writeExport(const ExportSet& set, const std::string& path, const WriteOptions& options,
                           const Progress& progress)
{
    const auto format = findFormat(path, FormatUse::Write, options.ascii);
    if (!format)
        return fail(format.error());
    const std::vector<MeshPart> parts = set.parts();
    return (*format)->write(path, {parts, set.lines ? &*set.lines : nullptr}, options, progress);
}

Expected<void> exportScene(EvaluatedScene scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress)
{
    if (const auto format = findFormat(path, FormatUse::Write); !format)
        return fail(format.error());
    const auto set = collectExport(std::move(scene), options, progress.part(0.0, 0.5));
    if (!set)
        return fail(set.error());
    WriteOptions head = options.write;
    head.comment = options.space.comment();
    return writeExport(*set, path, head, progress.part(0.5, 1.0));
}

} // namespace ramure
