#include "app/cli/commands/commands.h"
#include "app/cli/file_space_options.h"
#include "app/cli/level_options.h"
#include "app/cli/mesh_check.h"
#include "app/cli/moments.h"
#include "app/cli/print_options.h"
#include "app/cli/work.h"
#include "core/base/file_writer.h"
#include "core/evaluate/evaluator.h"
#include "core/io/formats/file_format.h"
#include "core/qt/document/project/mesh_report_json.h"
#include "core/qt/session/export/exporter.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/mesh/transformed.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>

namespace ramure::cli {

namespace {

constexpr CommandText exportText = {
    "export", "writes mesh files", "INPUT",
    "Writes a tree or a scene as meshes, or a mesh file in another format.",
    "The ending of FILE says the format: {formats}.\n"
    "All that is visible in a project is written together, where it stands in the "
    "world. Of several trees the objects are "
    "branches_1, leaves_1, fruit_1, branches_2 and so on; arms (their skin as it is "
    "at --time), terrains, primitives and imported meshes are objects with the names "
    "of their nodes. With --frames a .glb moves: one file with skins and an animation; of other "
    "formats each frame has a file. Files are written under "
    "another name and renamed: an error or Ctrl+C "
    "leaves the old file as it was."};

constexpr int mostJoints = 65535;

/// A value of an option by its name.
template <class Value> struct Choice
{
    const char* name;
    Value value;
};
constexpr Choice<std::uint8_t> partChoices[] = {
    {"branches", exportBranches}, {"leaves", exportLeaves}, {"fruit", exportApples}, {"all", exportAll}};
constexpr Choice<ExportModel> modelChoices[] = {
    {"mesh", ExportModel::Mesh}, {"rough", ExportModel::Rough}, {"skeleton", ExportModel::Skeleton}};

constexpr Choice<bool> leafChoices[] = {{"merged", false}, {"instances", true}};

template <class Value, std::size_t n>
Expected<Value> choose(const Choice<Value> (&choices)[n], const char* option, const QString& name)
{
    QStringList names;
    for (const Choice<Value>& choice : choices) {
        if (name == QLatin1String(choice.name))
            return choice.value;
        names << QLatin1String(choice.name);
    }
    return fail(ErrorCode::Unknown, "--%1 \"%2\": %3 expected",
                {option, name.toStdString(), commaList(names).toStdString()});
}

/// What the options ask for; parts nowhere where the format decides.
struct ExportRequest
{
    QStringList files;
    std::optional<std::uint8_t> parts;
    ExportModel model = ExportModel::Mesh;
    bool ascii = false;
    bool needsTree = false; ///< an option that says something about trees was given
    bool texture = true;
    bool instances = false; ///< leaves and fruit as a list
    int mapSize = WriteOptions().mapSize;
    int joints = WriteOptions().joints;
    bool compressed = false;
    LevelOptions levels;
    WindProfile wind = WindProfile::None;
    FileSpace space;
    bool requireValid = false;
    QString report; ///< file, or empty

    [[nodiscard]] bool needsCheck() const { return requireValid || !report.isEmpty(); }
};

Expected<int> jointsFrom(const CommandLine& line)
{
    const QString given = line.value("joints");
    bool isNumber = false;
    const int joints = given.toInt(&isNumber);
    if (given == QLatin1String("all"))
        return 0;
    if (isNumber && joints >= 1 && joints <= mostJoints)
        return joints;
    return fail(ErrorCode::Invalid, "--joints \"%1\": all, or 1 to %2 expected",
                {given.toStdString(), std::to_string(mostJoints)});
}

Expected<void> takeNumbers(const CommandLine& line, ExportRequest& out)
{
    const auto mapSize = mapSizeFrom(line);
    RAMURE_TRY(mapSize);
    out.mapSize = *mapSize;
    const auto joints = jointsFrom(line);
    RAMURE_TRY(joints);
    out.joints = *joints;
    const auto levels = levelsFrom(line);
    RAMURE_TRY(levels);
    out.levels = *levels;
    const auto wind = windFrom(line);
    RAMURE_TRY(wind);
    out.wind = *wind;
    out.needsTree = out.needsTree || out.levels.isWanted() || out.wind != WindProfile::None;
    if (out.wind != WindProfile::None && line.has("print"))
        return fail(ErrorCode::Invalid, "--print and --wind exclude each other");
    return {};
}

/// Of formats that cannot, there is no silent other file.
Expected<void> takeCompression(const CommandLine& line, ExportRequest& out)
{
    const auto wanted = compressionFrom(line);
    RAMURE_TRY(wanted);
    out.compressed = *wanted;
    for (const QString& file : out.files)
        if (const auto known = findFormat(systemPath(file), FormatUse::Write, out.ascii); !known)
            return fail(known.error());
        else if (out.compressed && ((*known)->holds & holdsCompressed) == 0)
            return fail(ErrorCode::Invalid, "--compress meshopt is for .glb files: \"%1\" is none",
                        {file.toStdString()});
        else if (out.wind != WindProfile::None && ((*known)->holds & holdsWind) == 0)
            return fail(ErrorCode::Invalid, "--wind is for .glb files: \"%1\" is none", {file.toStdString()});
    return {};
}

Expected<ExportRequest> exportRequestOf(const CommandLine& line)
{
    ExportRequest out;
    out.files = line.values("o");
    out.ascii = line.has("ascii");
    if (line.has("texture") && line.has("no-texture"))
        return fail(ErrorCode::Invalid, "--texture and --no-texture exclude each other");
    out.texture = !line.has("no-texture");
    out.needsTree = line.has("part") || line.has("model") || line.has("leaves") || line.has("texture");
    RAMURE_TRY(takeNumbers(line, out));
    const auto space = fileSpaceFrom(line);
    RAMURE_TRY(space);
    out.space = space->value_or(FileSpace());
    if (out.files.isEmpty())
        return fail(ErrorCode::Invalid, "missing -o FILE: `ramure-cli export --help` shows what it takes");
    RAMURE_TRY(takeCompression(line, out));
    out.requireValid = line.has("require-valid");
    out.report = line.value("report");
    if (line.has("report") && !out.report.endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
        return fail(ErrorCode::Invalid, "--report \"%1\": a .json file expected", {out.report.toStdString()});
    if (line.has("part")) {
        const bool isOldName = line.value("part") == QLatin1String("apples");
        const auto parts =
            choose(partChoices, "part", isOldName ? QStringLiteral("fruit") : line.value("part"));
        RAMURE_TRY(parts);
        out.parts = *parts;
    }
    if (line.has("model")) {
        const auto model = choose(modelChoices, "model", line.value("model"));
        RAMURE_TRY(model);
        out.model = *model;
    }
    const auto instances = choose(leafChoices, "leaves", line.value("leaves"));
    RAMURE_TRY(instances);
    out.instances = *instances;
    if (out.instances && out.model == ExportModel::Skeleton)
        return fail(ErrorCode::Invalid, "--leaves instances and --model skeleton exclude each other: a "
                                        "skeleton has no leaves");
    if (line.has("texture") && out.model != ExportModel::Mesh)
        return fail(ErrorCode::Invalid,
                    "--texture needs --model mesh: other models have no texture coordinates");
    out.texture = out.texture && out.model == ExportModel::Mesh;
    if (out.needsCheck() && out.model != ExportModel::Mesh)
        return fail(ErrorCode::Invalid,
                    "--require-valid and --report need --model mesh: there is no closed mesh "
                    "to check in another model");
    return out;
}

/// exportRequestOf has checked the ending.
const FileFormat& formatOf(const ExportRequest& request, const QString& file)
{
    return **findFormat(systemPath(file), FormatUse::Write, request.ascii);
}

/// The pipeline; says once of each tree that its mesh does not fit the budget.
TreeSource notingSource(TreePipeline& pipeline)
{
    return [source = pipelineSource(pipeline), told = std::set<NodeId>()](const Node& node, Stage last,
                                                                          const Progress& progress) mutable {
        Expected<TreeResult> tree = source(node, last, progress);
        const char* note = tree && tree->branches ? budgetText(tree->branches->budget) : "";
        if (*note != '\0' && told.insert(node.id).second)
            std::fprintf(stderr, "ramure-cli: %s: %s (%u triangles)\n", node.name.c_str(), note,
                         tree->branches->mesh.faceCount());
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
        ExportOptions options;
        options.model = request.model;
        options.parts = request.parts.value_or(usualParts(formatOf(request, file), request.instances));
        options.instances = request.instances;
        options.write.ascii = request.ascii;
        options.write.mapSize = request.mapSize;
        options.texture = request.texture;
        options.write.joints = request.joints;
        options.write.compressed = request.compressed;
        options.levels = request.levels;
        options.wind = request.wind;
        options.write.tell = [](const Error& note) { printError(fromText(note.message())); };
        options.clip = clip;
        options.space = request.space;
        const double from = static_cast<double>(i) / count;
        const auto written = exportScene(evaluator.at(scene, timeSeconds), options, systemPath(file),
                                         progress.part(from, from + 1.0 / count));
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
        return fail(
            ErrorCode::Invalid,
            "--part, --model, --leaves, --texture, --levels, --budget, --switch and --wind need a tree: the "
            "input is a mesh");
    const auto placed = [&request](TriangleMesh object) {
        if (!request.texture) {
            object.uv.clear();
            object.uvTriangles.clear();
        }
        return request.space.isOwn() ? object : transformed(object, request.space.matrix());
    };
    std::vector<ReadObject> objects = mesh.objects;
    for (ReadObject& object : objects)
        object.mesh = placed(std::move(object.mesh));
    const ExportScene parts = sceneOfMeshes(std::move(objects), barkMaterial());
    // Where all is one mesh, vertices that the objects share stay shared.
    const ExportScene whole = sceneOfMeshes({{"mesh", placed(mesh.joined()), {}}}, barkMaterial());
    WriteOptions options{request.ascii, request.space.comment()};
    options.compressed = request.compressed;
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
    ExportOptions options;
    options.levels = request.levels;
    for (const QString& file : request.files)
        for (const std::string& written : exportFiles(options, systemPath(file)))
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

Expected<int> checkAndWrite(const Input& input, const QString& name, const ExportRequest& request,
                            const Moments& moments, TreePipeline& pipeline, const Progress& progress)
{
    Evaluator evaluator(notingSource(pipeline), moments.timeline);
    if (!request.needsCheck()) {
        const auto written = writeFiles(input, request, moments, evaluator, progress);
        return written ? Expected<int>(exitGood) : fail(written.error());
    }
    MeshChecks checks{moments.timeSeconds, !request.report.isEmpty()};
    checks.placed = true;
    const auto checked = checkMeshes(input, evaluator, checks, progress.part(0.0, 0.6));
    RAMURE_TRY(checked);
    if (request.requireValid)
        for (const CheckedMesh& one : *checked)
            if (!one.report.valid) {
                printError(QStringLiteral("the mesh is not valid, nothing was written: ") +
                           fromText(faultOf(one)));
                return exitCheckFailed;
            }
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
    return exitGood;
}

void addExportOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes this file; may be repeated."), QStringLiteral("FILE"));
    line.addInputOptions();
    line.addNodeOption();
    line.add({QStringLiteral("part")},
             QStringLiteral("What is written. Without it formats with objects get all, others the branches."),
             QStringLiteral("branches|leaves|fruit|all"));
    line.add({QStringLiteral("model")},
             QStringLiteral("mesh (one continuous mesh; the default), rough (open cylinders, squares, cubes) "
                            "or skeleton (line segments)."),
             QStringLiteral("mesh|rough|skeleton"));
    line.addDefault(
        {QStringLiteral("leaves")},
        QStringLiteral(
            "merged (one mesh of all leaves, all fruit another) or instances: FILE holds what else "
            "there is, and beside it stand FILE_leaves.csv, a row for each leaf, fruit and flower "
            "with its node, shape, material, branch, colour and matrix (3 rows of 4), and "
            "FILE_leaves.json, the same as JSON, and FILE_leaves_birch.obj, FILE_fruit_acorn.obj and so on, "
            "the shapes that the rows name. "
            "A point of the shape times the matrix is the point of the merged mesh."),
        QStringLiteral("merged|instances"), QStringLiteral("merged"));
    line.add({QStringLiteral("texture")},
             QStringLiteral("With texture coordinates, which is the default for --model mesh: vt lines of "
                            ".obj, a list texcoord per face of .ply. Parameter texture.tileSize (metres) is "
                            "the size of one repeat of the bark. A "
                            "tree that moves keeps the coordinates it has at rest."));
    line.add({QStringLiteral("no-texture")}, QStringLiteral("Without texture coordinates and pictures."));
    line.addDefault(
        {QStringLiteral("map-size")},
        QStringLiteral("Pixels a side, 16 to 8192, of the pictures of bark that are written beside "
                       "an .obj and named in its .mtl; 0: none, the bark has its mean colour."),
        QStringLiteral("PIXELS"), QString::number(WriteOptions().mapSize));
    line.addDefault({QStringLiteral("joints")},
                    QStringLiteral("Of each tree in a .glb with --frames, at most, or all: thin branches "
                                   "go with those that carry them, and it is said how far that is off."),
                    QStringLiteral("NUMBER|all"), QString::number(WriteOptions().joints));
    addCompression(line);
    addLevelOptions(line, QStringLiteral("of other formats each is a file, FILE_LOD0, FILE_LOD1 and so on"));
    addWindOption(line);
    addSpaceOptions(line);
    addPrintOptions(line);
    line.add({QStringLiteral("ascii")}, QStringLiteral("Writes a format that has both as text, not binary."));
    addMomentOptions(line, MomentOptions::Sequence);
    line.add({QStringLiteral("wind-loop")},
             QStringLiteral(
                 "A .glb that moves for so long and then goes on from its beginning without a seam: the "
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

Expected<int> runExport(const CommandLine& line)
{
    const auto request = exportRequestOf(line);
    RAMURE_TRY(request);
    const auto print = printFrom(line);
    RAMURE_TRY(print);
    const Work work("export");
    const Progress progress = work.progress();
    auto input = loadInput(line, progress.part(0.0, 0.0));
    RAMURE_TRY(input);
    RAMURE_TRY(keepNodes(*input, line.values("node")));
    const auto moments = momentsOf(line, *input);
    RAMURE_TRY(moments);
    const auto isStill = [&](const QString& file) { return !(formatOf(*request, file).holds & holdsClip); };
    if (const auto still = std::ranges::find_if(request->files, isStill);
        moments->closes && still != request->files.end())
        return fail(ErrorCode::Invalid,
                    "--wind-loop: %1 cannot move; a .glb can, other formats take --frames",
                    {still->toStdString()});
    if (moments->isSequence() && request->needsCheck())
        return fail(ErrorCode::Invalid,
                    "--require-valid and --report look at one moment: --time, not --frames");
    TreePipeline pipeline; // its cache serves the second file
    double begun = 0.0;
    if (line.has("separate")) {
        RAMURE_TRY(separateTrees(*input, pipeline, progress.part(0.0, 0.5)));
        begun = 0.5;
    }
    if (*print) {
        Evaluator evaluator(pipelineSource(pipeline), moments->timeline);
        return printTo(line, *input, **print, *fileSpaceFrom(line), evaluator, progress.part(begun, 1.0));
    }
    return checkAndWrite(*input, line.arguments().front(), *request, *moments, pipeline,
                         progress.part(begun, 1.0));
}

} // namespace

const Command exportCommand{exportText, &addExportOptions, &runExport};

} // namespace ramure::cli
