#include "app/cli/commands/commands.h"
#include "app/cli/export_options.h"
#include "app/cli/input.h"
#include "app/cli/work.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/qt/document/project/project_file.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <filesystem>

namespace ramure::cli {

namespace {

constexpr CommandText importText = {
    "import", "makes a project of meshes, trees of other programs or what a script for Blender wrote",
    "INPUT", "Makes a project of mesh files, or writes a project as files for Blender.",
    "INPUT is any file {read}, or what a script for Blender wrote: NAME.obj with a line TRANSFORM, "
    "NAME.animation, or a folder of them; the other file of the same name is read too; or a tree of Arbaro "
    "(.xml) or ez-tree (.json), which becomes one of Weber and Penn. Colours come from the "
    ".mtl that an .obj names. A file that Ramure wrote says its axes and its unit itself. All that was "
    "guessed or mended is told on the standard error, or under \"notes\" with "
    "--json.\nThe other way round: INPUT is a .ramure or demo:NAME, and -o a folder that exists."};

Expected<CubicMeaning> cubicOf(const CommandLine& line)
{
    const QString given = line.value("cubic");
    if (given == QLatin1String("automatic"))
        return CubicMeaning::Automatic;
    if (given == QLatin1String("spline"))
        return CubicMeaning::Spline;
    if (given == QLatin1String("easing"))
        return CubicMeaning::Easing;
    return fail(ErrorCode::Invalid, "--cubic \"%1\": automatic, spline or easing expected",
                {given.toStdString()});
}

/// One line, whatever the note.
QString textOf(const Note& note)
{
    return fromText(note.message());
}

Expected<void> report(const CommandLine& line, const std::vector<Note>& notes, QJsonObject facts)
{
    if (!line.has("json")) {
        for (const Note& note : notes)
            printError(textOf(note));
        return {};
    }
    QJsonArray list;
    for (const Note& note : notes)
        list.append(textOf(note));
    facts.insert(QStringLiteral("notes"), list);
    return printJson(facts);
}

Expected<void> importTo(const CommandLine& line, const QString& input, const QString& output,
                        const Progress& progress)
{
    const auto cubic = cubicOf(line);
    RAMURE_TRY(cubic);
    const auto options = exportOptionsOf(line, ofImport);
    RAMURE_TRY(options);
    auto imported = importObjects(systemPath(input), {*cubic, spaceGiven(line, *options)}, progress);
    RAMURE_TRY(imported);
    const auto count = static_cast<qint64>(imported->nodes.size());
    auto scene = Scene::fromNodes(std::move(imported->nodes));
    RAMURE_TRY(scene);
    scene->setTimeline(imported->timeline);
    if (auto saved = saveProjectFile({std::move(*scene), {}}, output); !saved)
        return saved;
    return report(line, imported->notes,
                  {{QStringLiteral("nodes"), count},
                   {QStringLiteral("keys"), static_cast<qint64>(imported->keyCount)}});
}

Expected<void> exportTo(const CommandLine& line, const Scene& scene, const QString& folder,
                        const Progress& progress)
{
    const auto written = exportBlender(scene, systemPath(folder), progress);
    RAMURE_TRY(written);
    QJsonArray files;
    for (const std::string& file : written->files)
        files.append(QFileInfo(fromText(file)).fileName());
    return report(line, written->notes, {{QStringLiteral("files"), files}});
}

void addImportOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes this project, or into this folder."),
             QStringLiteral("FILE.ramure|FOLDER"));
    line.addDefault({QStringLiteral("cubic")},
                    QStringLiteral("What CUBIC means: the spline through the keys, Blender's easing, or "
                                   "automatic: the easing where our own script wrote the file."),
                    QStringLiteral("automatic|spline|easing"), QStringLiteral("automatic"));
    addExportOptions(line, ofImport);
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
}

Expected<int> runImport(const CommandLine& line)
{
    const QString input = line.arguments().front(), output = line.value("output");
    if (output.isEmpty())
        return fail(ErrorCode::Invalid,
                    "missing -o FILE.ramure: `ramure-cli import --help` shows what it takes");
    const Work work("import");
    if (std::filesystem::is_directory(systemPath(output))) {
        const auto scene = loadInput(input, {});
        RAMURE_TRY(scene);
        if (!scene->scene())
            return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only scenes are written into a folder",
                        {input.toStdString()});
        RAMURE_TRY(exportTo(line, *scene->scene(), output, work.progress()));
        return exitGood;
    }
    if (QFileInfo(output).suffix().toLower() != QLatin1String("ramure"))
        return fail(ErrorCode::Unknown, "%1: a project is written as .ramure, or into a folder that exists",
                    {output.toStdString()});
    RAMURE_TRY(importTo(line, input, output, work.progress()));
    return exitGood;
}

} // namespace

const Command importCommand{importText, &addImportOptions, &runImport};

} // namespace ramure::cli
