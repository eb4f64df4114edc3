#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/moments.h"
#include "app/cli/work.h"
#include "core/base/file_writer.h"
#include "core/evaluate/evaluator.h"
#include "core/io/material_maps.h"
#include "core/surface/bark/bark_maps.h"
#include <QJsonArray>
#include <QJsonObject>

namespace ramure::cli {

namespace {

constexpr CommandText texturesText = {
    "textures", "writes the pictures of the bark", "INPUT",
    "Writes the pictures of the bark of every tree as PNG files.",
    "Of each bark there are five: colour (sRGB), normal (OpenGL's way: green points along the branch), "
    "height, "
    "occlusion and roughness. They repeat without a seam; one repeat is as large as the parameter "
    "texture.tileSize says. A number in the name stands for all that a picture hangs on: one that is there "
    "already is kept. `export` writes the same files beside an .obj."};

/// Of the trees that are shown, each bark once.
struct Surfaces
{
    std::vector<BarkParams> barks;
    std::vector<std::pair<LeafShape, double>> leaves; ///< with their season
};

/// Each once, as the keys have made it at that time.
Expected<Surfaces> surfacesOf(const Scene& scene, const Moments& moments)
{
    const auto trees = treesOf(scene);
    RAMURE_TRY(trees);
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), moments.timeline);
    EvaluatedScene now = evaluator.at(scene, moments.timeSeconds);
    Surfaces out;
    for (const Node* tree : *trees) {
        if (!scene.isShown(tree->id))
            continue;
        const NodeParams& params = now.params(*tree);
        const std::pair leaf(params.leaf.shape, params.leaf.season);
        if (params.bark.family != BarkFamily::Plain &&
            std::ranges::find(out.barks, params.bark) == out.barks.end())
            out.barks.push_back(params.bark);
        if (leaf.first != LeafShape::Faithful && std::ranges::find(out.leaves, leaf) == out.leaves.end())
            out.leaves.push_back(leaf);
    }
    if (out.barks.empty() && out.leaves.empty())
        return fail(ErrorCode::Invalid, "no tree that is shown has a bark or a leaf with pictures: "
                                        "--set bark.family=furrowed, for example");
    return out;
}

Expected<int> sizeFrom(const CommandLine& line)
{
    bool isNumber = false;
    const int size = line.value("size").toInt(&isNumber);
    if (!isNumber || size < leastBarkSize || size > mostBarkSize)
        return fail(
            ErrorCode::Invalid, "--size \"%1\": %2 to %3 pixels expected",
            {line.value("size").toStdString(), std::to_string(leastBarkSize), std::to_string(mostBarkSize)});
    return size;
}

void addTexturesOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes into this folder, which is made where there is none."),
             QStringLiteral("FOLDER"));
    line.addDefault({QStringLiteral("size")}, QStringLiteral("Pixels a side, 16 to 8192."),
                    QStringLiteral("PIXELS"), QStringLiteral("1024"));
    line.addInputOptions();
    line.addNodeOption();
    line.add({QStringLiteral("time")},
             QStringLiteral(
                 "The leaves in the season that the keys have brought after so many seconds; 0 without it."),
             QStringLiteral("SECONDS"));
    line.add({QStringLiteral("json")},
             QStringLiteral("Prints one JSON object: the names of all files, and of those written now."));
}

Expected<int> runTextures(const CommandLine& line)
{
    const QString folder = line.value("output");
    if (folder.isEmpty())
        return fail(ErrorCode::Invalid,
                    "missing -o FOLDER: `ramure-cli textures --help` shows what it takes");
    const auto size = sizeFrom(line);
    RAMURE_TRY(size);
    auto input = loadInput(line);
    RAMURE_TRY(input);
    RAMURE_TRY(keepNodes(*input, line.values("node")));
    if (!input->scene())
        return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees have a bark",
                    {line.arguments().front().toStdString()});
    const auto moments = momentsOf(line, *input);
    RAMURE_TRY(moments);
    const auto surfaces = surfacesOf(*input->scene(), *moments);
    RAMURE_TRY(surfaces);
    RAMURE_TRY(makeFolder(systemPath(folder)));
    const Work work("textures");
    QJsonArray all, written;
    const auto note = [&written](const Expected<std::vector<std::string>>& names) {
        for (const std::string& name : names ? *names : std::vector<std::string>())
            written.append(fromText(name));
        return names.has_value();
    };
    const double count = double(surfaces->barks.size());
    for (std::size_t i = 0; i < surfaces->barks.size(); ++i) {
        const BarkParams& bark = surfaces->barks[i];
        const auto names = writeMaps(systemPath(folder), bark, *size,
                                     work.progress().part(double(i) / count, double(i + 1) / count));
        if (!note(names))
            return fail(names.error());
        for (std::size_t map = 0; map < mapNames.size(); ++map)
            all.append(fromText(mapFileName(bark, *size, static_cast<MaterialMap>(map))));
    }
    for (const auto& [leaf, season] : surfaces->leaves) {
        if (const auto names = writeMaps(systemPath(folder), leaf, *size, season); !note(names))
            return fail(names.error());
        for (const MaterialMap map : leafMapKinds)
            if (const QString name = fromText(mapFileName(leaf, *size, map, season)); !all.contains(name))
                all.append(name);
    }
    if (line.has("json"))
        RAMURE_TRY(
            printJson(QJsonObject{{QStringLiteral("files"), all}, {QStringLiteral("written"), written}}));
    return exitGood;
}

} // namespace

const Command texturesCommand{texturesText, &addTexturesOptions, &runTextures};

} // namespace ramure::cli
