#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "core/qt/document/edit_script.h"
#include <QFile>
#include <QFileInfo>
#include <filesystem>

namespace ramure::cli {

namespace {

constexpr CommandText editText = {
    "edit", "shapes a tree by a script of edits", "INPUT",
    "Makes the edits of a script, one after the other, and saves the project: the same bytes as by hand.",
    "A script has one JSON object a line. Limbs are named by the 16 digits that `info --json --axes` lists; "
    "\"at\", \"from\" and \"to\" are shares of an axis' length; vectors are in the tree's own space, in "
    "metres, "
    "or with \"frame\": \"parent\" in the frame that the parent carries to the fork; \"angle\" and "
    "\"azimuth\" "
    "are degrees, \"rotation\" is an axis times an angle in radians. \"target\" may list several limbs.\n"
    "Operations: `cut` (at), `remove`, `keep`, `bend` (from, rotation), `curl` (from, to, rotation), `twist` "
    "(angle), `length` and `thickness` (factor, below), `taper` (factor), `draw` (parent, at, points, below; "
    "its \"id\" becomes the axis' address), `extend` and `redraw` (points), `graft` (source, parent, at, "
    "azimuth, factor), `move` (at, azimuth, parent), `prune` (shape: sphere [x, y, z, r], box [x, y, z, X, "
    "Y, "
    "Z], cone [x, y, z, r, height], profile [x, y, z, r, height, r, height ...] or mesh NAME, a solid of the "
    "scene), `attract` and `comb` (centre, radius, strength, direction), `leaves` (shown), `root` (offset, "
    "factor). Points are [x, y, z, radius].\n"
    "Every edit may have a \"name\" and \"enabled\". A line that cannot be carried out is an error with its "
    "number, and nothing is written."};

void addEditOptions(CommandLine& line)
{
    line.addInputOptions();
    line.add({QStringLiteral("node")},
             QStringLiteral("The tree, by its name; needed where there are several."),
             QStringLiteral("NAME"));
    line.add({QStringLiteral("script")}, QStringLiteral("The edits; - reads the standard input."),
             QStringLiteral("FILE"));
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("The project to write, .ramure."), QStringLiteral("FILE"));
}

Expected<QByteArray> readScript(const QString& path)
{
    QFile file;
    if (path == QLatin1String("-"))
        file.open(stdin, QIODevice::ReadOnly);
    else if (auto opened = openToRead(file, path); !opened)
        return fail(std::move(opened.error()));
    return file.readAll();
}

Expected<NodeId> treeOf(const Scene& scene, const QString& name)
{
    const auto trees = treesOf(scene);
    RAMURE_TRY(trees);
    if (name.isEmpty() && trees->size() > 1)
        return fail(ErrorCode::Invalid, "the project holds several trees: --node names one");
    for (const Node* tree : *trees)
        if (name.isEmpty() || fromText(tree->name) == name)
            return tree->id;
    return fail(ErrorCode::Unknown, "there is no tree \"%1\"", {name.toStdString()});
}

/// What the file holds besides its scene is kept.
Expected<std::string> extrasOf(const QString& input)
{
    if (QFileInfo(input).suffix().toLower() != QLatin1String("ramure") ||
        !std::filesystem::exists(systemPath(input)))
        return std::string();
    return loadProjectFile(input).map([](Project&& project) { return std::move(project.extras); });
}

Expected<int> runEdit(const CommandLine& line)
{
    if (!line.has("script"))
        return fail(ErrorCode::Invalid, "missing --script FILE");
    if (QFileInfo(line.value("output")).suffix().toLower() != QLatin1String("ramure"))
        return fail(ErrorCode::Invalid, "missing -o FILE.ramure");
    auto input = loadInput(line);
    RAMURE_TRY(input);
    auto* const scene = std::get_if<Scene>(&input->content);
    if (!scene)
        return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees can be shaped",
                    {line.arguments().front().toStdString()});
    const auto tree = treeOf(*scene, line.value("node"));
    const auto script = readScript(line.value("script"));
    auto extras = extrasOf(line.arguments().front());
    RAMURE_TRY(tree);
    RAMURE_TRY(script);
    RAMURE_TRY(extras);
    Document document;
    document.reset(std::move(*scene), {}, std::move(*extras));
    if (auto replayed = replayEdits(document, *tree, *script); !replayed) {
        Error error = std::move(replayed.error());
        if (error.line > 0)
            error.file = systemPath(line.value("script"));
        return fail(std::move(error));
    }
    RAMURE_TRY(saveProjectFile(document.project(), line.value("output")));
    return exitGood;
}

} // namespace

const Command editCommand{editText, &addEditOptions, &runEdit};

} // namespace ramure::cli
