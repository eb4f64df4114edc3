#include "app/cli/scene_export.h"

#include "app/cli/mesh_check.h"
#include "app/cli/moments.h"
#include "core/base/file_writer.h"
#include "core/evaluate/evaluator.h"
#include "core/io/formats/file_format.h"
#include "core/qt/document/project/mesh_report_json.h"
#include "core/qt/session/export/engine_folder.h"
#include "core/qt/session/export/exporter.h"
#include "core/surface/mesh/transformed.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <set>

namespace ramure::cli {

namespace {

/// ".glb, .usda": of the formats that are written and hold this.
std::string endingsWith(std::uint16_t holds)
{
    std::string out;
    for (const FileFormat* format : fileFormats())
        if (isFor(*format, FormatUse::Write) && (format->holds & holds) == holds)
            out.append(out.empty() ? "." : ", .").append(format->ending);
    return out;
}

/// Of an engine's folder, the format of the files inside.
Expected<const FileFormat*> knownFormat(const ExportRequest& request, const QString& file)
{
    return findFormat(request.options.engine == Engine::None ? systemPath(file) : "tree.glb",
                      FormatUse::Write, request.options.write.ascii);
}

/// exportRequestOf has checked the ending.
const FileFormat& formatOf(const ExportRequest& request, const QString& file)
{
    return **knownFormat(request, file);
}

/// Refuses options that the format of a file cannot hold: nothing else is written silently in their place.
Expected<void> checkFormats(const ExportRequest& request)
{
    for (const QString& file : request.files) {
        const auto known = knownFormat(request, file);
        RAMURE_TRY(known);
        for (const ExportOption& option : exportOptions())
            if (option.is(ofFormats) && !((*known)->holds & option.holds) &&
                !isUsual(option, request.options))
                return fail(ErrorCode::Invalid, "--%1 %2 is for %3 files: \"%4\" is none",
                            {option.name, optionText(option, request.options), endingsWith(option.holds),
                             file.toStdString()});
    }
    return {};
}

/// Checks which options go together.
Expected<void> checkRequest(const CommandLine& line, const ExportRequest& request)
{
    const bool isMesh = request.options.model == ExportModel::Mesh;
    if (line.has("report") && !request.report.endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
        return fail(ErrorCode::Invalid, "--report \"%1\": a .json file expected",
                    {request.report.toStdString()});
    if (request.options.instances && request.options.model == ExportModel::Skeleton)
        return fail(ErrorCode::Invalid, "--leaves instances and --model skeleton exclude each other: a "
                                        "skeleton has no leaves");
    if (line.has("texture") && !isMesh)
        return fail(ErrorCode::Invalid,
                    "--texture needs --model mesh: other models have no texture coordinates");
    if (request.needsCheck() && !isMesh)
        return fail(ErrorCode::Invalid,
                    "--require-valid and --report need --model mesh: there is no closed mesh "
                    "to check in another model");
    if (request.options.engine != Engine::None && (line.has("frames") || line.has("wind-loop")))
        return fail(ErrorCode::Invalid,
                    "--for writes a tree at rest, which the engine's shader moves: no --frames, no "
                    "--wind-loop");
    return checkPrintOptions(line, request.options.print);
}

/// The pipeline; says once of each tree that its mesh does not fit the budget.
TreeSource notingSource(TreePipeline& pipeline, std::function<void(const Error&)> tell)
{
    return [source = pipelineSource(pipeline), tell = std::move(tell),
            told = std::set<NodeId>()](const Node& node, Stage last, const Progress& progress) mutable {
        Expected<TreeResult> tree = source(node, last, progress);
        const char* note = tree && tree->branches ? budgetText(tree->branches->budget) : "";
        if (*note != '\0' && told.insert(node.id).second)
            tell(fail(ErrorCode::Limit, "%1: %2 (%3 triangles)",
                      {node.name, note, std::to_string(tree->branches->mesh.faceCount())})
                     .value());
        return tree;
    };
}

/// \param clip further times, for formats that hold them
Expected<void> exportAt(const Scene& scene, const ExportRequest& request, double timeSeconds,
                        Evaluator& evaluator, const QStringList& files, const Progress& progress,
                        const std::vector<double>& clip = {})
{
    const auto count = static_cast<double>(files.size());
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString& file = files.at(i);
        ExportOptions options = request.options;
        if (!request.hasParts)
            options.parts = usualParts(formatOf(request, file), options.instances);
        options.clip = clip;
        const double from = static_cast<double>(i) / count;
        const Progress part = progress.part(from, from + 1.0 / count);
        const auto write = options.engine == Engine::None ? &exportScene : &exportEngineFolder;
        const auto written = write(evaluator.at(scene, timeSeconds), options, systemPath(file), part);
        if (!written)
            return written;
    }
    return {};
}

/// A set of files for each frame.
Expected<void> exportMoments(const Scene& scene, const ExportRequest& request, const Moments& moments,
                             Evaluator& evaluator, const Progress& progress)
{
    if (!moments.isSequence())
        return exportAt(scene, request, moments.timeSeconds, evaluator, request.files, progress);
    QStringList whole, each; // files that move, and those of which every frame has one
    for (const QString& file : request.files)
        ((formatOf(request, file).holds & holdsClip) ? whole : each) << file;
    std::vector<double> clip;
    for (const std::int64_t frame : moments.frames)
        clip.push_back(moments.timeOf(frame));
    const double first = clip.front(), share = whole.isEmpty() ? 0.0 : each.isEmpty() ? 1.0 : 0.5;
    clip.erase(clip.begin());
    if (auto written = exportAt(scene, request, first, evaluator, whole, progress.part(0.0, share), clip);
        !written || each.isEmpty())
        return written;
    const Progress rest = progress.part(share, 1.0);
    const auto count = static_cast<double>(moments.frames.size());
    for (std::size_t i = 0; i < moments.frames.size(); ++i) {
        const std::int64_t frame = moments.frames[i];
        QStringList files;
        for (const QString& file : each)
            files << numberedFile(file, frame);
        const double from = static_cast<double>(i) / count;
        const auto written = exportAt(scene, request, moments.timeOf(frame), evaluator, files,
                                      rest.part(from, from + 1.0 / count));
        if (!written)
            return written;
    }
    return {};
}

Expected<void> exportMesh(const ReadMesh& mesh, const ExportRequest& request, const Progress& progress)
{
    if (request.needsTree)
        return fail(ErrorCode::Invalid, "--part, --model, --leaves, --texture, --levels, --budget, --switch, "
                                        "--wind and --for need a tree: the "
                                        "input is a mesh");
    const FileSpace& space = request.options.space;
    const auto placed = [&](TriangleMesh object) {
        if (!request.options.texture) {
            object.uv.clear();
            object.uvTriangles.clear();
        }
        return space.isOwn() ? object : transformed(object, space.matrix());
    };
    std::vector<ReadObject> objects = mesh.objects;
    for (ReadObject& object : objects)
        object.mesh = placed(std::move(object.mesh));
    const ExportScene parts = sceneOfMeshes(std::move(objects), barkMaterial());
    // Where all is one mesh, vertices that the objects share stay shared.
    const ExportScene whole = sceneOfMeshes({{"mesh", placed(mesh.joined()), {}}}, barkMaterial());
    WriteOptions options{request.options.write.ascii, space.comment()};
    options.compressed = request.options.write.compressed;
    for (const QString& file : request.files) {
        const FileFormat& format = formatOf(request, file);
        const auto written =
            format.write(systemPath(file), (format.holds & holdsObjects) ? parts : whole, options, progress);
        if (!written)
            return written;
    }
    return {};
}

/// What was written, and what is known about the meshes.
QByteArray reportText(const ExportRequest& request, const QString& input,
                      const std::vector<CheckedMesh>& checked)
{
    QJsonArray files;
    for (const QString& file : request.files)
        for (const std::string& written : exportFiles(request.options, systemPath(file)))
            files.append(QFileInfo(QString::fromStdString(written)).fileName());
    QJsonObject report = jsonOf(checked, true);
    report.insert(QStringLiteral("format"), QStringLiteral("ramure-report"));
    report.insert(QStringLiteral("version"), meshReportVersion);
    report.insert(QStringLiteral("program"), versionText().trimmed());
    report.insert(QStringLiteral("input"), input);
    report.insert(QStringLiteral("files"), files);
    return QJsonDocument(report).toJson();
}

/// The first thing that is wrong with a mesh, in words.
std::string faultOf(const CheckedMesh& checked)
{
    const MeshReport& r = checked.report;
    const std::pair<const char*, Index> counts[] = {{"boundary edges", r.boundaryEdges},
                                                    {"non-manifold edges", r.nonManifoldEdges},
                                                    {"non-manifold vertices", r.nonManifoldVertices},
                                                    {"inconsistent edges", r.inconsistentEdges},
                                                    {"duplicate vertices", r.duplicateVertices},
                                                    {"duplicate faces", r.duplicateFaces},
                                                    {"degenerate faces", r.degenerateFaces},
                                                    {"isolated vertices", r.isolatedVertices}};
    std::string fault;
    for (const auto& [name, count] : counts)
        if (count > 0)
            fault.append(fault.empty() ? "" : ", ").append(std::to_string(count)).append(" ").append(name);
    if (fault.empty())
        fault = "not one closed, outward surface per root";
    if (checked.isSpoiltByPlace)
        fault += ", so far from the origin or so small that single precision cannot tell its vertices apart";
    return checked.name.empty() ? fault : checked.name + ": " + fault;
}

Expected<void> writeFiles(const Input& input, const ExportRequest& request, const Moments& moments,
                          Evaluator& evaluator, const Progress& progress)
{
    return input.scene() ? exportMoments(*input.scene(), request, moments, evaluator, progress)
                         : exportMesh(*input.mesh(), request, progress);
}

Expected<ExportOutcome> checkAndWrite(const Input& input, const QString& name, const ExportRequest& request,
                                      const Moments& moments, TreePipeline& pipeline,
                                      const Progress& progress)
{
    Evaluator evaluator(notingSource(pipeline, request.options.write.tell), moments.timeline);
    if (!request.needsCheck()) {
        const auto written = writeFiles(input, request, moments, evaluator, progress);
        return written ? Expected<ExportOutcome>(ExportOutcome()) : fail(written.error());
    }
    MeshChecks checks{moments.timeSeconds, !request.report.isEmpty()};
    checks.placed = true;
    const auto checked = checkMeshes(input, evaluator, checks, progress.part(0.0, 0.6));
    RAMURE_TRY(checked);
    if (request.requireValid)
        for (const CheckedMesh& one : *checked)
            if (!one.report.valid)
                return ExportOutcome{exitCheckFailed,
                                     QStringLiteral("the mesh is not valid, nothing was written: ") +
                                         fromText(faultOf(one))};
    std::optional<FileWriter> report; // opened first: what cannot be written is told before a mesh is
    if (!request.report.isEmpty()) {
        auto opened = FileWriter::open(systemPath(request.report));
        RAMURE_TRY(opened);
        report.emplace(std::move(*opened));
    }
    const auto written = writeFiles(input, request, moments, evaluator, progress.part(0.6, 1.0));
    RAMURE_TRY(written);
    if (report) {
        report->append(reportText(request, name, *checked).toStdString());
        RAMURE_TRY(report->commit());
    }
    return ExportOutcome();
}

} // namespace

void addSceneExportOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes this file; may be repeated."), QStringLiteral("FILE"));
    line.addInputOptions();
    line.addNodeOption();
    addExportOptions(line, ofExport);
    line.add({QStringLiteral("json")}, QStringLiteral("With --print, prints the report as JSON."));
    line.add({QStringLiteral("ascii")}, QStringLiteral("Writes a format that has both as text, not binary."));
    addMomentOptions(line, MomentOptions::Sequence);
    line.add(
        {QStringLiteral("wind-loop")},
        QStringLiteral(
            "A .glb or .usda that moves for so long and then goes on from its beginning without a seam: the "
            "last key is the first one, the second before it blends into the motion before the "
            "first. It begins at --time; without it after 2 s, when the wind has taken hold."),
        QStringLiteral("SECONDS"));
    line.add({QStringLiteral("separate")},
             QStringLiteral("Moves branches that collide apart before they are written; says how many."));
    line.add(
        {QStringLiteral("require-valid")},
        QStringLiteral("Writes nothing and ends with exit code 1 where `validate` would: where a mesh is "
                       "broken. Crossings do not count: --report tells of them."));
    line.add(
        {QStringLiteral("report")},
        QStringLiteral("Writes beside the mesh what `validate --self-intersections --json` says of it, or "
                       "with --print the report of the print."),
        QStringLiteral("FILE.json"));
}

Expected<ExportRequest> exportRequestOf(const CommandLine& line,
                                        const std::function<void(const Error&)>& tell)
{
    ExportRequest out;
    out.files = line.values("o");
    if (line.has("texture") && line.has("no-texture"))
        return fail(ErrorCode::Invalid, "--texture and --no-texture exclude each other");
    ExportOptions usual;
    usual.texture = true;
    usual.write.ascii = line.has("ascii");
    usual.write.tell = tell;
    auto options = exportOptionsOf(line, ofExport, std::move(usual));
    RAMURE_TRY(options);
    out.options = std::move(*options);
    out.hasParts = line.has("part");
    out.needsTree = out.options.wind != WindProfile::None ||
                    std::ranges::any_of(exportOptions(), [&](const ExportOption& option) {
                        return option.is(ofTrees) && line.has(option.name);
                    });
    if (out.files.isEmpty())
        return fail(ErrorCode::Invalid, "missing -o FILE: `ramure-cli export --help` shows what it takes");
    RAMURE_TRY(checkFormats(out));
    out.requireValid = line.has("require-valid");
    out.report = line.value("report");
    RAMURE_TRY(checkRequest(line, out));
    out.options.texture = out.options.texture && out.options.model == ExportModel::Mesh;
    return out;
}

Expected<ExportOutcome> exportInput(const CommandLine& line, const ExportRequest& request, Input& input,
                                    TreePipeline& pipeline, const Progress& progress)
{
    RAMURE_TRY(keepNodes(input, line.values("node")));
    const auto moments = momentsOf(line, input);
    RAMURE_TRY(moments);
    const auto isStill = [&](const QString& file) { return !(formatOf(request, file).holds & holdsClip); };
    if (const auto still = std::ranges::find_if(request.files, isStill);
        moments->closes && still != request.files.end())
        return fail(ErrorCode::Invalid,
                    "--wind-loop: %1 cannot move; .glb, .usda and .usdz can, other formats take --frames",
                    {still->toStdString()});
    if (moments->isSequence() && request.needsCheck())
        return fail(ErrorCode::Invalid,
                    "--require-valid and --report look at one moment: --time, not --frames");
    double begun = 0.0;
    if (line.has("separate")) {
        RAMURE_TRY(separateTrees(input, pipeline, progress.part(0.0, 0.5), request.options.write.tell));
        begun = 0.5;
    }
    if (line.has("print")) {
        Evaluator evaluator(pipelineSource(pipeline), moments->timeline);
        return printTo(line, input, request.options, evaluator, progress.part(begun, 1.0));
    }
    return checkAndWrite(input, line.arguments().front(), request, *moments, pipeline,
                         progress.part(begun, 1.0));
}

} // namespace ramure::cli
