#include "app/cli/batch/batch_row.h"
#include "app/cli/batch/file_hash.h"
#include "app/cli/json_measures.h"
#include "app/cli/mesh_check.h"
#include "app/cli/painter.h"
#include "core/base/file_writer.h"
#include "core/generators/variety.h"
#include "core/io/formats/file_format.h"
#include "core/io/material_maps.h"
#include "core/qt/session/export/exporter.h"
#include "core/scene/growth_spaces.h"
#include "core/scene/object_mesh.h"
#include "core/skeleton/measures.h"
#include "core/surface/bark/bark_maps.h"
#include "widgets/view/render/passes/picture_file.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QRegularExpression>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <unistd.h>

namespace ramure::cli {

namespace {

/// What every line says, whether the row could be done or not. No times, no paths, no names of machines:
/// the same row gives the same line everywhere.
QJsonObject lineOf(const BatchPlan& plan, const BatchRow& row)
{
    QJsonObject line{{QStringLiteral("row"), qint64(row.number)},
                     {QStringLiteral("line"), row.line},
                     {QStringLiteral("input"),
                      row.input.contains(QLatin1Char(':')) ? row.input : QFileInfo(row.input).fileName()},
                     {QStringLiteral("inputs"), QString::fromLatin1(inputsHash(plan, row))}};
    if (row.seed)
        line.insert(QStringLiteral("seed"), qint64(*row.seed));
    if (!row.sets.isEmpty())
        line.insert(QStringLiteral("set"), QJsonArray::fromStringList(row.sets));
    return line;
}

/// As `validate` says it.
QJsonObject proofOf(const std::vector<CheckedMesh>& checked)
{
    const MeshReport sum = sumOf(checked);
    QJsonObject proof{{QStringLiteral("valid"), sum.valid},
                      {QStringLiteral("closed"), sum.boundaryEdges == 0},
                      {QStringLiteral("manifold"), sum.nonManifoldEdges == 0 && sum.nonManifoldVertices == 0},
                      {QStringLiteral("oriented"), sum.inconsistentEdges == 0},
                      {QStringLiteral("openMesh"), sum.openMeshChecked && sum.openMeshAgrees},
                      {QStringLiteral("verdict"), QLatin1String(verdictName(verdictOn(checked)))}};
    if (checked.size() == 1)
        proof.insert(QStringLiteral("mesh"), fromText(checked.front().analysis.hash.text()));
    return proof;
}

/// Of the trees that are shown; triangles are those of the checked meshes.
QJsonObject countsOf(EvaluatedScene& now, const std::vector<CheckedMesh>& checked, Stage stage,
                     QJsonObject& line)
{
    const MeshReport sum = sumOf(checked);
    qint64 leaves = 0, branches = 0, trees = 0;
    for (const Node& node : now.scene().nodes()) {
        if (node.kind != NodeKind::Tree || !now.scene().isShown(node.id))
            continue;
        const auto tree = now.tree(node, stage);
        if (!tree)
            continue;
        ++trees;
        leaves += tree->foliage ? qint64(leafCount(*tree->foliage)) : 0;
        branches += qint64(tree->skeleton->size());
        if (trees == 1)
            line.insert(QStringLiteral("measures"), jsonMeasures(measuresOf(*tree->skeleton)));
    }
    return {{QStringLiteral("vertices"), qint64(sum.vertices)},
            {QStringLiteral("faces"), qint64(sum.faces)},
            {QStringLiteral("trees"), trees},
            {QStringLiteral("branches"), branches},
            {QStringLiteral("leaves"), leaves},
            {QStringLiteral("volume"), sum.volume}};
}

/// Of levels that are all that is written: bark of the finest, and triangles and leaves of each.
QJsonObject countsOf(EvaluatedScene& now, const ExportScene& written, const std::vector<CheckedMesh>& checked,
                     QJsonObject& line)
{
    struct Level
    {
        qint64 triangles = 0, leaves = 0;
    };
    std::vector<Level> levels(std::size_t(lastLevel(written)) + 1);
    std::vector<CheckedMesh> finest;
    auto bark = checked.begin();
    for (const ExportMesh& mesh : written.meshes) {
        levels[std::size_t(mesh.level)].triangles += mesh.mesh->faceCount();
        if (mesh.name.starts_with("leaves"))
            levels[std::size_t(mesh.level)].leaves += mesh.pieces;
        if (mesh.name.starts_with("branches"))
            if (const CheckedMesh& each = *bark++; mesh.level == 0)
                finest.push_back(each);
    }
    QJsonArray list;
    for (const Level& level : levels)
        list.append(QJsonObject{{QStringLiteral("triangles"), level.triangles},
                                {QStringLiteral("leaves"), level.leaves}});
    QJsonObject counts = countsOf(now, finest, Stage::Simplified, line);
    counts.insert(QStringLiteral("leaves"), levels.front().leaves);
    counts.insert(QStringLiteral("levels"), list);
    return counts;
}

bool holdsLevelsIn(const QString& file)
{
    const auto format = findFormat(systemPath(file), FormatUse::Write);
    return format && ((*format)->holds & holdsLevels) != 0;
}

/// Are levels the only meshes? Then the whole tree, many times as large, is neither made nor proved.
bool isOfLevelsAlone(const BatchPlan& plan, const BatchRow& row, const Scene& scene)
{
    const auto has = [&](const char* ending) {
        return std::ranges::count_if(row.files, [&](const QString& file) {
            return file.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
        });
    };
    const auto meshes = std::ranges::count_if(row.files, &holdsLevelsIn);
    return plan.options.levels.isWanted() && !plan.options.levels.beginsWhole() && meshes > 0 &&
           meshes + has(".png") + has("/") == row.files.size() &&
           std::ranges::none_of(
               scene.nodes(), [&](const Node& node) { return isShape(node.kind) && scene.isShown(node.id); });
}

Expected<void> writeMapsOf(EvaluatedScene& now, const std::string& folder, int size)
{
    for (const Node& node : now.scene().nodes()) {
        if (node.kind != NodeKind::Tree || !now.scene().isShown(node.id))
            continue;
        const NodeParams& params = now.params(node);
        if (params.bark.family != BarkFamily::Plain)
            RAMURE_TRY(writeMaps(folder, params.bark, size));
        if (params.leaf.shape != LeafShape::Faithful)
            RAMURE_TRY(writeMaps(folder, params.leaf.shape, size, params.leaf.season));
    }
    return {};
}

QJsonArray filesBelow(const QString& folder)
{
    namespace fs = std::filesystem;
    const fs::path below = systemPath(folder);
    QStringList names;
    std::error_code problem; // where there is no folder, there is no file
    for (fs::recursive_directory_iterator at(below, problem), end; !problem && at != end;
         at.increment(problem))
        if (at->is_regular_file(problem))
            names << pathText(at->path().lexically_relative(below).string());
    names.sort();
    QJsonArray out;
    for (const QString& name : names) {
        const QString path = folder + QLatin1Char('/') + name;
        out.append(QJsonObject{{QStringLiteral("name"), name},
                               {QStringLiteral("bytes"), qint64(fs::file_size(systemPath(path), problem))},
                               {QStringLiteral("sha256"), QString::fromLatin1(sha256Of(path))}});
    }
    return out;
}

/// "trees.csv:12: turtle.alpha: …", without the paths of this machine.
QString placed(const BatchPlan& plan, const BatchRow& row, QString text)
{
    if (!row.input.contains(QLatin1Char(':')))
        text.replace(row.input, QFileInfo(row.input).fileName());
    for (const QString& folder : {stagingFolder(plan, row), plan.folder})
        text.remove(fromText(systemPath(folder)) + QLatin1Char('/'));
    return QStringLiteral("%1:%2: %3").arg(plan.table).arg(row.line).arg(text);
}

} // namespace

Expected<Input> inputOf(const BatchRow& row)
{
    auto input = loadInput(row.input, {});
    RAMURE_TRY(input);
    Scene* scene = std::get_if<Scene>(&input->content);
    if (!scene) {
        if (row.seed || !row.sets.isEmpty())
            return fail(ErrorCode::Invalid, "\"%1\" is a mesh: it has neither a seed nor parameters",
                        {row.input.toStdString()});
        return input;
    }
    if (row.seed)
        for (const Node& listed : scene->nodes())
            if (listed.kind == NodeKind::Tree)
                scene->find(listed.id)->params = reseeded(listed.params, *row.seed);
    RAMURE_TRY(applySettings(*scene, row.sets));
    linkGrowthSpaces(*scene);
    return input;
}

QString stagingFolder(const BatchPlan& plan, const BatchRow& row)
{
    return QStringLiteral("%1/.row-%2.part").arg(plan.folder).arg(row.number);
}

void clearStaging(const BatchPlan& plan, const BatchRow& row)
{
    std::error_code problem; // what cannot be removed is in nobody's way
    std::filesystem::remove_all(systemPath(stagingFolder(plan, row)), problem);
}

void clearStaging(const BatchPlan& plan)
{
    if (plan.rows.empty())
        return;
    // What is there is looked at, not what might be: a row more costs nothing.
    namespace fs = std::filesystem;
    static const QRegularExpression name(QStringLiteral("^\\.row-(\\d+)\\.part$"));
    std::vector<fs::path> left;
    std::error_code problem;
    for (fs::directory_iterator at(systemPath(plan.folder), problem), end; !problem && at != end;
         at.increment(problem))
        if (const qint64 row = name.match(pathText(at->path().filename().string())).captured(1).toLongLong();
            row >= plan.rows.front().number && row <= plan.rows.back().number)
            left.push_back(at->path());
    for (const fs::path& folder : left)
        fs::remove_all(folder, problem);
}

const char* rowErrorOf(const Error& error)
{
    return isDiskFull(error) ? row_error::disk : isWriteError(error) ? row_error::output : row_error::input;
}

QJsonObject failedLine(const BatchPlan& plan, const BatchRow& row, const char* kind, const QString& text)
{
    QJsonObject line = lineOf(plan, row);
    line.insert(QStringLiteral("error"), QJsonObject{{QStringLiteral("kind"), QLatin1String(kind)},
                                                     {QStringLiteral("text"), placed(plan, row, text)}});
    return line;
}

RowMaker::RowMaker(const BatchPlan& plan)
    : m_plan(plan)
    , m_painter(std::make_unique<Painter>())
{
}

RowMaker::~RowMaker() = default;

ExportOptions RowMaker::optionsFor(const QString& path) const
{
    ExportOptions options = m_plan.options;
    const FileFormat& format = **findFormat(systemPath(path), FormatUse::Write);
    options.parts = usualParts(format);
    options.texture = true;
    if (!holdsLevelsIn(path)) // they would be several files, of which no name is known
        options.levels = {};
    if ((format.holds & holdsWind) == 0)
        options.wind = WindProfile::None;
    return options;
}

Expected<std::vector<CheckedMesh>> RowMaker::checkWhole(const Input& input, Evaluator& evaluator,
                                                        QJsonObject& line)
{
    MeshChecks checks;
    checks.placed = true;
    auto checked = checkMeshes(input, evaluator, checks, {});
    if (checked) {
        EvaluatedScene now = evaluator.at(*input.scene());
        line.insert(QStringLiteral("counts"), countsOf(now, *checked, Stage::Foliage, line));
    }
    return checked;
}

Expected<std::vector<CheckedMesh>> RowMaker::checkLevels(EvaluatedScene& now, QJsonObject& line)
{
    auto collected = collectExport(now, optionsFor(QStringLiteral(".glb")));
    RAMURE_TRY(collected);
    m_levels = std::move(*collected);
    auto checked = checkBarks(*m_levels);
    if (checked)
        line.insert(QStringLiteral("counts"), countsOf(now, *m_levels, *checked, line));
    return checked;
}

QJsonObject RowMaker::make(const BatchRow& row)
{
    if (!row.problem.isEmpty())
        return failedLine(m_plan, row, row_error::input, row.problem);
    const auto failed = [&](const Error& error) {
        return failedLine(m_plan, row, rowErrorOf(error), fromText(error.message()));
    };
    const auto input = inputOf(row);
    if (!input)
        return failed(input.error());
    if (!input->scene())
        return failedLine(m_plan, row, row_error::input, QStringLiteral("a mesh: trees and scenes expected"));
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), input->scene()->timeline());
    EvaluatedScene now = evaluator.at(*input->scene());
    QJsonObject line = lineOf(m_plan, row);
    if (const QJsonArray warnings = jsonWarnings(*input->scene()); !warnings.isEmpty())
        line.insert(QStringLiteral("warnings"), warnings);
    m_levels.reset();
    const auto checked = isOfLevelsAlone(m_plan, row, *input->scene()) ? checkLevels(now, line)
                                                                       : checkWhole(*input, evaluator, line);
    if (!checked)
        return failed(checked.error());
    line.insert(QStringLiteral("proof"), proofOf(*checked));
    if (!sumOf(*checked).valid) {
        QJsonObject broken = failedLine(m_plan, row, row_error::check,
                                        QStringLiteral("the mesh is not valid, nothing was written"));
        line.insert(QStringLiteral("error"), broken.value(QStringLiteral("error")));
        return line;
    }
    const QString staging = stagingFolder(m_plan, row);
    clearStaging(m_plan, row);
    for (const QString& file : row.files)
        if (const auto written = write(now, staging + QLatin1Char('/') + file); !written) {
            clearStaging(m_plan, row);
            return failed(written.error());
        }
    line.insert(QStringLiteral("files"), filesBelow(staging));
    return line;
}

Expected<void> RowMaker::write(EvaluatedScene& now, const QString& path)
{
    const QString folder = folderOf(path);
    if (auto made = makeFolder(systemPath(folder)); !made)
        return made;
    if (path.endsWith(QLatin1Char('/')))
        return writeMapsOf(now, systemPath(folder),
                           std::max(m_plan.options.write.mapSize, int(leastBarkSize)));
    if (path.endsWith(QLatin1String(".png")))
        return draw(now, path);
    const ExportOptions options = optionsFor(path);
    return m_levels && options.levels.isWanted() ? writeExport(*m_levels, options, systemPath(path))
                                                 : exportScene(now, options, systemPath(path));
}

Expected<void> RowMaker::draw(EvaluatedScene& now, const QString& path)
{
    if (!m_painter->hasBegun())
        if (auto begun = m_painter->begin(); !begun)
            return begun;
    const auto scene = renderSceneOf(now);
    RAMURE_TRY(scene);
    const auto image = m_painter->draw(*scene, cameraFor(*scene, m_plan.picture), m_plan.picture, {});
    RAMURE_TRY(image);
    return savePicture(*image, systemPath(path));
}

Expected<void> placeFiles(const BatchPlan& plan, const BatchRow& row, const QJsonObject& line)
{
    const QString staging = stagingFolder(plan, row);
    for (const QString& name : filesOf(line)) {
        const QString target = plan.folder + QLatin1Char('/') + name;
        if (auto made = makeFolder(systemPath(folderOf(target))); !made)
            return made;
        if (::rename(systemPath(staging + QLatin1Char('/') + name).c_str(), systemPath(target).c_str()) != 0)
            return fail(writeError(systemPath(target), errno));
    }
    clearStaging(plan, row);
    return {};
}

QStringList filesOf(const QJsonObject& line)
{
    QStringList names;
    for (const QJsonValue file : line.value(QStringLiteral("files")).toArray())
        names << file.toObject().value(QStringLiteral("name")).toString();
    return names;
}

/// With the folders that are empty then.
static void removeBelow(const QString& folder, const QString& name)
{
    if (!isBelowFolder(name)) // a manifest may have been written by hand
        return;
    ::unlink(systemPath(folder + QLatin1Char('/') + name).c_str());
    for (QString empty = folderOf(name); !empty.isEmpty(); empty = folderOf(empty))
        if (::rmdir(systemPath(folder + QLatin1Char('/') + empty).c_str()) != 0)
            return;
}

void removeStale(const BatchPlan& plan, const ManifestLines& before, const ManifestLines& now)
{
    const auto hasFailed = [&](const BatchRow& row) {
        const auto line = now.find(row.number);
        return line != now.end() && line->second.contains(QStringLiteral("error"));
    };
    if (std::ranges::none_of(plan.rows, hasFailed))
        return;
    QSet<QString> stale, kept;
    for (const BatchRow& row : plan.rows) {
        if (!hasFailed(row))
            continue;
        for (const QString& file : row.files)
            if (!file.endsWith(QLatin1Char('/')))
                for (const QString& name : ownNames(file, plan.options.wind))
                    stale << name;
        if (const auto line = before.find(row.number); line != before.end())
            for (const QString& name : filesOf(line->second))
                if (!plan.foreignFolders.contains(folderOf(name)))
                    stale << name;
    }
    for (const auto& [number, line] : now)
        for (const QString& name : filesOf(line)) // those that failed have none
            kept << name;
    for (const auto& [number, line] : before) // rows that were not reached have what they had
        for (const QString& name : now.contains(number) ? QStringList() : filesOf(line))
            kept << name;
    for (const QString& name : stale - kept)
        removeBelow(plan.folder, name);
}

bool isDone(const BatchPlan& plan, const BatchRow& row, const QJsonObject& line)
{
    if (line.contains(QStringLiteral("error")) ||
        line.value(QStringLiteral("inputs")).toString() != QString::fromLatin1(inputsHash(plan, row)))
        return false;
    const QJsonArray files = line.value(QStringLiteral("files")).toArray();
    return std::all_of(files.begin(), files.end(), [&](const QJsonValue& value) {
        const QJsonObject file = value.toObject();
        const QString path = plan.folder + QLatin1Char('/') + file.value(QStringLiteral("name")).toString();
        return QString::fromLatin1(sha256Of(path)) == file.value(QStringLiteral("sha256")).toString();
    });
}

} // namespace ramure::cli
