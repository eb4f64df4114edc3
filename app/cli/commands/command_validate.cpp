#include "app/cli/commands/commands.h"
#include "app/cli/mesh_check.h"
#include "app/cli/moments.h"
#include "app/cli/work.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include <numbers>

namespace ramure::cli {

namespace {

constexpr CommandText validateText = {
    "validate", "is the mesh closed and manifold?", "INPUT",
    "Checks whether a mesh is one closed, oriented 2-manifold. Exit code 1 where it is not.",
    "The verdict is \"clean\" (closed, and no triangle runs through another), \"crossing\" (closed, but some "
    "do), \"closed\" (without --self-intersections: not looked for) or \"broken\", and broken alone fails. "
    "Of a tree the mesh of its branches is checked, before its placement: every edge has two faces in "
    "opposite directions, every "
    "vertex one fan; no duplicate or degenerate element, one component and Euler characteristic 2 per root, "
    "positive volume. Of a "
    "file all its objects together; the Euler characteristic may be any. OpenMesh's half-edge structure has "
    "to agree. Of a scene every node with a shape is checked: arms (their skin as it is at --time), "
    "terrains, "
    "primitives and imported meshes too; terrains without depth and planes are open surfaces, their boundary "
    "is no "
    "fault. Of "
    "several the figures are summed, and \"trees\" or, where not all are trees, \"nodes\" (JSON) lists "
    "each."};

/// \param open a surface that need not be closed
QString textReport(const MeshReport& r, const QString& verdict, bool open = false)
{
    const auto row = [](const char* name, const QString& value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -20).arg(value);
    };
    const auto count = [&](const char* name, std::int64_t value) {
        return row(name, QString::number(value));
    };
    return row("valid", !r.valid ? QStringLiteral("no")
                        : open   ? QStringLiteral("yes, an open surface")
                                 : QStringLiteral("yes")) +
           row("verdict", verdict) + count("vertices", r.vertices) + count("faces", r.faces) +
           count("boundaryEdges", r.boundaryEdges) + count("nonManifoldEdges", r.nonManifoldEdges) +
           count("nonManifoldVertices", r.nonManifoldVertices) +
           count("inconsistentEdges", r.inconsistentEdges) + count("duplicateVertices", r.duplicateVertices) +
           count("duplicateFaces", r.duplicateFaces) + count("degenerateFaces", r.degenerateFaces) +
           count("isolatedVertices", r.isolatedVertices) + count("components", r.components) +
           count("eulerCharacteristic", r.eulerCharacteristic) +
           row("volume", QString::number(r.volume, 'g', 9) + QStringLiteral(" m³")) +
           row("OpenMesh", !r.openMeshChecked ? QStringLiteral("not asked: too many faces around one vertex")
                           : r.openMeshAgrees ? QStringLiteral("closed and manifold")
                                              : QStringLiteral("not closed, or not manifold"));
}

QString textCrossings(const MeshAnalysis& analysis)
{
    const SelfIntersections& found = analysis.crossings;
    const auto row = [](const char* name, std::uint64_t value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -20).arg(value);
    };
    QString lines = row("selfIntersections", found.total());
    if (!found.kindsKnown)
        return lines;
    lines += row("  same", found.count(PairKind::Same)) + row("  siblings", found.count(PairKind::Siblings)) +
             row("  parentChild", found.count(PairKind::ParentChild)) +
             row("  far", found.count(PairKind::Far)) + row("collisions", analysis.collisions.size());
    for (const Collision& c : analysis.collisions)
        lines += QStringLiteral("  branches %1 and %2, %3 m deep at (%4, %5, %6), %7 triangles\n")
                     .arg(c.first)
                     .arg(c.second)
                     .arg(c.depth, 0, 'g', 4)
                     .arg(c.place.x, 0, 'f', 4)
                     .arg(c.place.y, 0, 'f', 4)
                     .arg(c.place.z, 0, 'f', 4)
                     .arg(c.facePairs);
    return lines;
}

QString textShape(const MeshAnalysis& analysis)
{
    const MeshQuality& quality = analysis.quality;
    const auto row = [](const char* name, const QString& value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -20).arg(value);
    };
    QString lines;
    if (quality.smallestAngleFace != noIndex)
        lines += row("smallestAngle", QStringLiteral("%1° (face %2)")
                                          .arg(quality.smallestAngleRad * 180.0 / std::numbers::pi, 0, 'g', 4)
                                          .arg(quality.smallestAngleFace)) +
                 row("largestAspect", QStringLiteral("%1 (face %2)")
                                          .arg(quality.largestAspect, 0, 'g', 4)
                                          .arg(quality.largestAspectFace));
    lines += row("nearVertices", QStringLiteral("%1 pairs within %2 mm")
                                     .arg(quality.nearPairs)
                                     .arg(1000.0 * MeshQuality::nearDistance));
    return lines + row("hash", fromText(analysis.hash.text()));
}

QString textTexture(const TextureReport& texture)
{
    const auto row = [](const char* name, const QString& value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -20).arg(value);
    };
    return row("textureStretch", QStringLiteral("under %1 on %2 % of the triangles")
                                     .arg(TextureReport::goodStretch)
                                     .arg(100.0 * texture.goodShare(), 0, 'f', 2)) +
           row("textureMirrored", QString::number(texture.mirrored)) +
           row("textureUnevenness", QStringLiteral("%1 % between the branches' levels")
                                        .arg(100.0 * texture.unevenness, 0, 'f', 1));
}

/// What became of the triangle budget; nothing where there is none.
QString textBudget(const CheckedMesh& one)
{
    if (one.budget == BudgetFit::NotAsked)
        return {};
    const QString note = QLatin1String(budgetText(one.budget));
    return QStringLiteral("%1 %2 triangles wanted: %3\n")
        .arg(QStringLiteral("budget"), -20)
        .arg(one.targetTriangles)
        .arg(note.isEmpty() ? QStringLiteral("kept within %1 %").arg(100.0 * budgetSlack) : note);
}

QString textOf(const CheckedMesh& one, bool crossings)
{
    return textReport(one.report, verdictText(one.verdict(), one.analysis.crossings.total()), one.isOpen) +
           textBudget(one) + textShape(one.analysis) + (crossings ? textCrossings(one.analysis) : QString()) +
           (one.texture ? textTexture(*one.texture) : QString());
}

Expected<void> showJson(const std::vector<CheckedMesh>& all, bool crossings, const QJsonArray& warnings)
{
    QJsonObject told = jsonOf(all, crossings);
    if (!warnings.isEmpty())
        told.insert(QStringLiteral("warnings"), warnings);
    return printJson(told);
}

Expected<void> show(const std::vector<CheckedMesh>& all, bool crossings)
{
    if (all.size() == 1)
        return print(textOf(all.front(), crossings));
    QString texts;
    for (const CheckedMesh& one : all)
        texts += QStringLiteral("%1\n%2\n").arg(fromText(one.name), textOf(one, crossings));
    const QString what = isOfTrees(all) ? QStringLiteral("trees") : QStringLiteral("nodes");
    return print(texts +
                 QStringLiteral("%1 %2\n%3")
                     .arg(all.size())
                     .arg(what, textReport(sumOf(all), verdictText(verdictOn(all), crossingsOf(all)))));
}

void addValidateOptions(CommandLine& line)
{
    line.addInputOptions();
    line.addNodeOption();
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
    addMomentOptions(line, MomentOptions::One);
    line.add(
        {QStringLiteral("separate")},
        QStringLiteral("Moves colliding branches apart first, in memory: what `export --separate` writes."));
    line.add(
        {QStringLiteral("self-intersections")},
        QStringLiteral("Also counts the pairs of triangles that run through each other, by kind, and lists "
                       "the branches that collide. They change the verdict, not the exit code."));
    line.add(
        {QStringLiteral("texture")},
        QStringLiteral("Also says how the texture coordinates of a tree fit: stretch, mirrored triangles and "
                       "density by level; with --time how those of the tree at rest fit it then. They do not "
                       "change the exit code."));
}

Expected<int> runValidate(const CommandLine& line)
{
    const bool crossings = line.has("self-intersections");
    QJsonArray warnings;
    const auto checked = [&]() -> Expected<std::vector<CheckedMesh>> {
        const Work work("validate");
        const Progress progress = work.progress();
        auto input = loadInput(line, progress.part(0.0, 0.1));
        RAMURE_TRY(input);
        RAMURE_TRY(keepNodes(*input, line.values("node")));
        if (input->scene())
            warnings = jsonWarnings(*input->scene());
        const auto moments = momentsOf(line, *input);
        RAMURE_TRY(moments);
        TreePipeline pipeline;
        double begun = 0.1;
        if (line.has("separate")) {
            RAMURE_TRY(separateTrees(*input, pipeline, progress.part(0.1, 0.6)));
            begun = 0.6;
        }
        Evaluator evaluator(pipelineSource(pipeline), moments->timeline);
        const MeshChecks checks{moments->timeSeconds, crossings, !line.has("node"), line.has("texture")};
        return checkMeshes(*input, evaluator, checks, progress.part(begun, 1.0));
    }();
    RAMURE_TRY(checked);
    RAMURE_TRY(line.has("json") ? showJson(*checked, crossings, warnings) : show(*checked, crossings));
    return sumOf(*checked).valid ? exitGood : exitCheckFailed;
}

} // namespace

const Command validateCommand{validateText, &addValidateOptions, &runValidate};

} // namespace ramure::cli
