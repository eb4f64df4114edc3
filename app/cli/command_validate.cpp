#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "core/mesh/validate.h"
#include <QJsonArray>
#include <QJsonObject>

namespace ramure::cli {

namespace {

constexpr CommandText text = {
    "validate", "INPUT",
    "Checks whether a mesh is one closed, oriented 2-manifold. Exit code 1 where it is not.",
    "Of a tree the mesh of its branches is checked, before its placement: every edge has two faces in "
    "opposite directions, every "
    "vertex one fan; no duplicate or degenerate element, one component and Euler characteristic 2 per root, "
    "positive volume. Of a "
    "file all its objects together; the Euler characteristic may be any. OpenMesh's half-edge structure has "
    "to agree. Of a project "
    "with several trees the figures are summed, and \"trees\" (JSON) lists each."};

struct Checked
{
    std::string name;
    MeshReport report;
};

/// Adds OpenMesh's opinion, and makes it count.
Expected<void> confirm(const TriangleMesh& mesh, MeshReport& report)
{
    if (const auto asked = confirmWithOpenMesh(mesh, report); !asked)
        return asked;
    if (report.openMeshChecked && !report.openMeshAgrees)
        report.valid = false;
    return {};
}

Expected<std::vector<Checked>> checkScene(const Scene& scene)
{
    const auto nodes = treesOf(scene);
    if (!nodes)
        return fail(nodes.error());
    TreePipeline pipeline;
    std::vector<Checked> out;
    for (const Node* node : *nodes) {
        const auto result = evaluateTree(pipeline, *node, nodes->size() > 1, Stage::Mesh);
        if (!result)
            return fail(result.error());
        MeshReport report = *result->report;
        if (const auto confirmed = confirm(result->branches->mesh, report); !confirmed)
            return fail(confirmed.error());
        const Index roots = result->branches->roots;
        report.valid = report.valid && report.components == roots &&
                       report.eulerCharacteristic == 2 * std::int64_t(roots);
        out.push_back({node->name, std::move(report)});
    }
    return out;
}

Expected<std::vector<Checked>> checkMesh(const ReadMesh& mesh)
{
    const TriangleMesh joined = mesh.joined();
    auto report = validateMesh(joined);
    if (!report)
        return fail(report.error());
    if (const auto confirmed = confirm(joined, *report); !confirmed)
        return fail(confirmed.error());
    return std::vector<Checked>{{{}, std::move(*report)}};
}

MeshReport sumOf(const std::vector<Checked>& all)
{
    MeshReport sum;
    sum.valid = sum.openMeshChecked = sum.openMeshAgrees = true;
    for (const Checked& one : all) {
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
        sum.volume += r.volume;
    }
    return sum;
}

QJsonObject jsonReport(const MeshReport& r)
{
    return {{QStringLiteral("valid"), r.valid},
            {QStringLiteral("vertices"), qint64(r.vertices)},
            {QStringLiteral("faces"), qint64(r.faces)},
            {QStringLiteral("boundaryEdges"), qint64(r.boundaryEdges)},
            {QStringLiteral("nonManifoldEdges"), qint64(r.nonManifoldEdges)},
            {QStringLiteral("nonManifoldVertices"), qint64(r.nonManifoldVertices)},
            {QStringLiteral("inconsistentEdges"), qint64(r.inconsistentEdges)},
            {QStringLiteral("duplicateVertices"), qint64(r.duplicateVertices)},
            {QStringLiteral("duplicateFaces"), qint64(r.duplicateFaces)},
            {QStringLiteral("degenerateFaces"), qint64(r.degenerateFaces)},
            {QStringLiteral("isolatedVertices"), qint64(r.isolatedVertices)},
            {QStringLiteral("components"), qint64(r.components)},
            {QStringLiteral("eulerCharacteristic"), qint64(r.eulerCharacteristic)},
            {QStringLiteral("volume"), r.volume}};
}

QString textReport(const MeshReport& r)
{
    const auto row = [](const char* name, const QString& value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -20).arg(value);
    };
    const auto count = [&](const char* name, std::int64_t value) {
        return row(name, QString::number(value));
    };
    return row("valid", r.valid ? QStringLiteral("yes") : QStringLiteral("no")) +
           count("vertices", r.vertices) + count("faces", r.faces) + count("boundaryEdges", r.boundaryEdges) +
           count("nonManifoldEdges", r.nonManifoldEdges) +
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

Expected<void> show(const std::vector<Checked>& all, bool json)
{
    if (all.size() == 1)
        return json ? printJson(jsonReport(all.front().report)) : print(textReport(all.front().report));
    QJsonObject sum = jsonReport(sumOf(all));
    QJsonArray list;
    QString texts;
    for (const Checked& one : all) {
        QJsonObject entry = jsonReport(one.report);
        entry.insert(QStringLiteral("name"), fromText(one.name));
        list.append(entry);
        texts += QStringLiteral("%1\n%2\n").arg(fromText(one.name), textReport(one.report));
    }
    sum.insert(QStringLiteral("trees"), list);
    return json ? printJson(sum)
                : print(texts + QStringLiteral("%1 trees\n%2").arg(all.size()).arg(textReport(sumOf(all))));
}

} // namespace

Expected<int> runValidate(const QStringList& arguments)
{
    CommandLine line(text);
    line.addInputOptions();
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
    const auto done = line.parse(arguments, 1, 1);
    if (!done)
        return fail(done.error());
    if (*done)
        return **done;
    const auto input = loadInput(line.arguments().front(), line.values("set"));
    if (!input)
        return fail(input.error());
    const auto checked = input->scene() ? checkScene(*input->scene()) : checkMesh(*input->mesh());
    if (!checked)
        return fail(checked.error());
    if (const auto shown = show(*checked, line.has("json")); !shown)
        return fail(shown.error());
    return sumOf(*checked).valid ? exitGood : exitCheckFailed;
}

} // namespace ramure::cli
