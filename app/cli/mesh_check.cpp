#include "app/cli/mesh_check.h"

#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/pipeline/separate_branches.h"
#include "core/qt/document/project/mesh_report_json.h"
#include "core/scene/object_mesh.h"
#include "core/scene/shape_check.h"
#include "core/surface/mesh/transformed.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include <QJsonArray>
#include <algorithm>

namespace ramure::cli {

namespace {

/// The check again, of the mesh where it stands in the world.
Expected<void> checkPlaced(CheckedMesh& checked, const TriangleMesh& mesh, const glm::dmat4& world,
                           const Progress& progress)
{
    const auto placed = std::make_shared<const TriangleMesh>(transformed(mesh, world));
    auto again = checkMesh(placed, false, progress);
    RAMURE_TRY(again);
    if (checked.isOpen)
        again->report.valid = isGoodSurface(again->report);
    checked.isSpoiltByPlace = checked.report.valid && !again->report.valid;
    checked.report = std::move(again->report);
    checked.analysis.hash = again->analysis.hash;
    checked.analysis.quality = std::move(again->analysis.quality);
    for (Collision& collision : checked.analysis.collisions)
        collision.place = glm::dvec3(world * glm::dvec4(collision.place, 1.0));
    return {};
}

Expected<CheckedMesh> checkTree(const Node& node, bool isOneOfSeveral, EvaluatedScene& scene,
                                const MeshChecks& checks, const glm::dmat4& world, const Progress& progress)
{
    const auto result = evaluateTree(scene, node, isOneOfSeveral, Stage::Mesh, progress.part(0.0, 0.4));
    RAMURE_TRY(result);
    const BranchMesh& branches = *result->branches;
    CheckedMesh checked{node.name, *result->report, {},
                        {},        branches.budget, static_cast<Index>(node.params.mesh.targetTriangles)};
    RAMURE_TRY(confirmWithOpenMesh(branches.mesh, checked.report, progress.part(0.4, 0.6)));
    auto analysis = checks.crossings
                        ? analyseMesh(branches, result->simplified->skeleton, 0, progress.part(0.6, 0.9))
                        : analyseShape(branches.mesh, 0, progress.part(0.6, 0.9));
    RAMURE_TRY(analysis);
    checked.analysis = std::move(*analysis);
    if (checks.placed && world != glm::dmat4(1.0))
        RAMURE_TRY(checkPlaced(checked, branches.mesh, world, progress.part(0.9, 1.0)));
    checked.report.valid = verdictOn(checked.report, nullptr, branches.roots) != MeshVerdict::Broken;
    checked.crossingsKnown = checks.crossings;
    if (checks.texture) {
        const auto coordinates = result->texture->coordinates(node.params.texture, progress.part(0.9, 1.0));
        RAMURE_TRY(coordinates);
        checked.texture = textureReport(branches, **coordinates);
    }
    return checked;
}

CheckedMesh checkedMesh(ShapeCheck&& check, bool crossings)
{
    CheckedMesh checked{{}, std::move(check.report), std::move(check.analysis), {}};
    checked.isOpen = check.isOpen;
    checked.crossingsKnown = crossings;
    return checked;
}

Expected<CheckedMesh> checkFile(const ReadMesh& mesh, bool crossings, const Progress& progress)
{
    auto checked = checkMesh(std::make_shared<const TriangleMesh>(mesh.joined()), crossings, progress);
    RAMURE_TRY(checked);
    return checkedMesh(std::move(*checked), crossings);
}

/// An arm, a terrain, a primitive or an imported mesh.
Expected<CheckedMesh> checkNode(const Node& node, EvaluatedScene& scene, const MeshChecks& checks,
                                const glm::dmat4& world, const Progress& progress)
{
    RAMURE_TRY(scene.pose(node, progress.part(0.0, 0.2)));
    auto check = checkShape(node, scene.params(node), checks.crossings, progress.part(0.2, 0.8));
    if (!check)
        return fail(named(node, std::move(check.error())));
    const std::shared_ptr<const TriangleMesh> mesh = check->mesh;
    CheckedMesh checked = checkedMesh(std::move(*check), checks.crossings);
    checked.name = node.name;
    checked.kind = node.kind;
    if (checks.placed && world != glm::dmat4(1.0))
        if (const auto placed = checkPlaced(checked, *mesh, world, progress.part(0.8, 1.0)); !placed)
            return fail(named(node, placed.error()));
    return checked;
}

} // namespace

Expected<std::vector<CheckedMesh>> checkMeshes(const Input& input, Evaluator& evaluator,
                                               const MeshChecks& checks, const Progress& progress)
{
    std::vector<CheckedMesh> out;
    if (input.mesh()) {
        auto checked = checkFile(*input.mesh(), checks.crossings, progress);
        RAMURE_TRY(checked);
        out.push_back(std::move(*checked));
        return out;
    }
    const Scene& scene = *input.scene();
    auto nodes = treesOrShapes(scene);
    RAMURE_TRY(nodes);
    for (const Node& node : scene.nodes())
        if (isShape(node.kind))
            nodes->push_back(&node);
    if (!checks.hidden)
        std::erase_if(*nodes, [&](const Node* node) { return !scene.isShown(node->id); });
    EvaluatedScene now = evaluator.at(scene, checks.timeSeconds);
    const auto count = static_cast<double>(nodes->size());
    for (const Node* node : *nodes) {
        const double from = static_cast<double>(out.size()) / count;
        const Progress part = progress.part(from, from + 1.0 / count);
        const glm::dmat4 world = checks.placed ? now.transforms(node->id).geometry : glm::dmat4(1.0);
        auto checked = isShape(node->kind) ? checkNode(*node, now, checks, world, part)
                                           : checkTree(*node, nodes->size() > 1, now, checks, world, part);
        RAMURE_TRY(checked);
        out.push_back(std::move(*checked));
    }
    return out;
}

Expected<std::vector<CheckedMesh>> checkBarks(const ExportScene& scene)
{
    std::vector<CheckedMesh> out;
    for (const ExportMesh& mesh : scene.meshes) {
        if (!mesh.name.starts_with("branches"))
            continue;
        const glm::dmat4& world = scene.frames.front().transforms[mesh.node].geometry;
        auto check = checkMesh(world == glm::dmat4(1.0)
                                   ? mesh.mesh
                                   : std::make_shared<const TriangleMesh>(transformed(*mesh.mesh, world)),
                               false);
        RAMURE_TRY(check);
        out.push_back(checkedMesh(std::move(*check), false));
        out.back().name = scene.nodes[mesh.node].name;
    }
    return out;
}

Expected<void> separateTrees(Input& input, TreePipeline& pipeline, const Progress& progress,
                             const std::function<void(const Error&)>& tell)
{
    Scene* scene = std::get_if<Scene>(&input.content);
    if (!scene)
        return fail(ErrorCode::Invalid, "--separate needs a tree: the input is a mesh");
    const auto nodes = treesOf(*scene);
    RAMURE_TRY(nodes);
    std::vector<NodeId> trees;
    for (const Node* node : *nodes)
        trees.push_back(node->id);
    const auto count = static_cast<double>(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        Node& node = *scene->find(trees[i]);
        const double from = static_cast<double>(i) / count;
        auto separated = separateBranches(pipeline, node.params, {}, progress.part(from, from + 1.0 / count));
        RAMURE_TRY(separated);
        node.params = withSteps(node.params, separated->steps);
        tell(fail(ErrorCode::Invalid, "%1: %2 of %3 colliding pairs moved apart",
                  {node.name, std::to_string(separated->before - separated->rest.size()),
                   std::to_string(separated->before)})
                 .value());
    }
    return {};
}

MeshReport sumOf(const std::vector<CheckedMesh>& all)
{
    MeshReport sum;
    sum.valid = sum.openMeshChecked = sum.openMeshAgrees = true;
    for (const CheckedMesh& one : all) {
        const MeshReport& r = one.report;
        sum.valid = sum.valid && r.valid;
        sum.openMeshChecked = sum.openMeshChecked && r.openMeshChecked;
        sum.openMeshAgrees = sum.openMeshAgrees && r.openMeshAgrees;
        for (Index MeshReport::*count :
             {&MeshReport::vertices, &MeshReport::faces, &MeshReport::boundaryEdges,
              &MeshReport::nonManifoldEdges, &MeshReport::nonManifoldVertices, &MeshReport::inconsistentEdges,
              &MeshReport::duplicateVertices, &MeshReport::duplicateFaces, &MeshReport::degenerateFaces,
              &MeshReport::isolatedVertices, &MeshReport::components})
            sum.*count += r.*count;
        sum.eulerCharacteristic += r.eulerCharacteristic;
        sum.volume += one.isOpen ? 0.0 : r.volume; // an open surface encloses nothing
    }
    return sum;
}

MeshVerdict verdictOn(const std::vector<CheckedMesh>& all)
{
    MeshVerdict worst = MeshVerdict::Clean;
    for (const CheckedMesh& one : all)
        worst = std::max(worst, one.verdict());
    return worst;
}

std::uint64_t crossingsOf(const std::vector<CheckedMesh>& all)
{
    std::uint64_t sum = 0;
    for (const CheckedMesh& one : all)
        sum += one.analysis.crossings.total();
    return sum;
}

QString verdictText(MeshVerdict verdict, std::uint64_t crossings)
{
    switch (verdict) {
    case MeshVerdict::Clean:
        return QStringLiteral("closed and free of crossings");
    case MeshVerdict::Closed:
        return QStringLiteral("closed; crossings not looked for");
    case MeshVerdict::Crossing:
        return QStringLiteral("closed, but %1 pairs of triangles run through each other").arg(crossings);
    case MeshVerdict::Broken:
        break;
    }
    return QStringLiteral("broken");
}

static QJsonObject jsonOf(const TextureReport& texture)
{
    QJsonArray levels;
    for (const TextureLevel& level : texture.levels)
        levels.append(QJsonObject{{QStringLiteral("level"), qint64(level.level)},
                                  {QStringLiteral("triangles"), qint64(level.triangles)},
                                  {QStringLiteral("tilesPerMetre"), level.tilesPerMetre}});
    return {{QStringLiteral("triangles"), qint64(texture.triangles)},
            {QStringLiteral("stretchedFrom"), TextureReport::goodStretch},
            {QStringLiteral("stretched"), qint64(texture.stretched)},
            {QStringLiteral("mirrored"), qint64(texture.mirrored)},
            {QStringLiteral("stretch95"), texture.stretch95},
            {QStringLiteral("unevenness"), texture.unevenness},
            {QStringLiteral("levels"), levels}};
}

static QJsonObject budgetJson(const CheckedMesh& one)
{
    const char* fit = "within";
    switch (one.budget) {
    case BudgetFit::NotAsked:
    case BudgetFit::Within:
        break;
    case BudgetFit::Smallest:
        fit = "smallest";
        break;
    case BudgetFit::Largest:
        fit = "largest";
        break;
    case BudgetFit::Nearest:
        fit = "nearest";
        break;
    }
    return {{QStringLiteral("targetTriangles"), qint64(one.targetTriangles)},
            {QStringLiteral("fit"), QLatin1String(fit)},
            {QStringLiteral("note"), QLatin1String(budgetText(one.budget))}};
}

static QJsonObject jsonOf(const CheckedMesh& one, bool crossings)
{
    QJsonObject out = toJson(one.report, one.analysis, crossings);
    out.insert(QStringLiteral("verdict"), QLatin1String(verdictName(one.verdict())));
    if (one.isOpen)
        out.insert(QStringLiteral("openSurface"), true);
    if (one.texture)
        out.insert(QStringLiteral("texture"), jsonOf(*one.texture));
    if (one.budget != BudgetFit::NotAsked)
        out.insert(QStringLiteral("budget"), budgetJson(one));
    return out;
}

bool isOfTrees(const std::vector<CheckedMesh>& all)
{
    return std::all_of(all.begin(), all.end(),
                       [](const CheckedMesh& one) { return one.kind == NodeKind::Tree; });
}

QJsonObject jsonOf(const std::vector<CheckedMesh>& all, bool crossings)
{
    if (all.size() == 1)
        return jsonOf(all.front(), crossings);
    QJsonObject sum = toJson(sumOf(all));
    qint64 near = 0;
    for (const CheckedMesh& one : all)
        near += one.analysis.quality.nearPairs;
    sum.insert(QStringLiteral("nearVertices"), near);
    sum.insert(QStringLiteral("verdict"), QLatin1String(verdictName(verdictOn(all))));
    const bool trees = isOfTrees(all);
    QJsonArray list;
    for (const CheckedMesh& one : all) {
        QJsonObject entry = jsonOf(one, crossings);
        entry.insert(QStringLiteral("name"), fromText(one.name));
        if (!trees)
            entry.insert(QStringLiteral("kind"), QLatin1String(kindRow(one.kind).name));
        list.append(entry);
    }
    sum.insert(trees ? QStringLiteral("trees") : QStringLiteral("nodes"), list);
    return sum;
}

} // namespace ramure::cli
