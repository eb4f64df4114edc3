#include "app/cli/commands/commands.h"
#include "app/cli/export_options.h"
#include "app/cli/input.h"
#include "app/cli/work.h"
#include "core/lod/level_likeness.h"
#include "core/qt/session/export/level_export.h"
#include <QJsonArray>
#include <QJsonObject>

namespace ramure::cli {

namespace {

constexpr CommandText levelsText = {
    "levels", "the levels of detail of a tree, and how alike they are", "INPUT",
    "Makes the levels of detail of each tree, as export writes them, and tells their triangles and the "
    "distance from "
    "which each is shown.",
    "Without --levels or --budget they are the usual ones of a game: 80000, 20000, 5000 and 1250 triangles "
    "with cards, "
    "and the billboard. With --check every level but the first is compared with the one before, from three "
    "sides: as "
    "large as the tree is on the screen where one takes the place of the other (\"atSwitch\"), and where the "
    "details "
    "in which they differ are a pixel (\"atPixel\"). \"overlap\" is how much of what either covers both "
    "cover, "
    "pixels being covered by shares (the least of the three), \"outline\" the same of pixels that are "
    "covered by a "
    "half, \"cover\" what the level covers over what the one before covers, and \"colour\" the distance of "
    "their "
    "mean colours in one light (CIE76). The exit code does not depend on it."};

constexpr int checkedMaps = 1024; ///< pixels a side of the pictures of cards

struct TreeLevelsFound
{
    QString name;
    LevelledTree made;
    /// Of each level but the first, where it takes over and where its details are a pixel; empty: not asked
    /// for
    std::vector<LevelLikeness> likeness, unseen;
};

QString textOf(const TreeLevelsFound& tree)
{
    QString out = tree.name + u'\n';
    for (std::size_t i = 0; i < tree.made.levels.size(); ++i) {
        out += QStringLiteral("%1 %2 triangles, from %3 m")
                   .arg(i)
                   .arg(tree.made.levels[i].triangles(), 8)
                   .arg(tree.made.switches.distances[i], 7, 'f', 1);
        if (i > 0 && !tree.likeness.empty()) {
            for (const LevelLikeness& own : {tree.likeness[i - 1], tree.unseen[i - 1]})
                out += QStringLiteral(", %1 pixels: overlap %2, outline %3, cover %4, colour %5")
                           .arg(own.pixels)
                           .arg(own.overlap, 0, 'f', 3)
                           .arg(own.outline, 0, 'f', 3)
                           .arg(own.cover, 0, 'f', 2)
                           .arg(own.colourDistance, 0, 'f', 1);
        }
        out += u'\n';
    }
    return out;
}

QJsonObject jsonOf(const LevelLikeness& own)
{
    return {{QStringLiteral("pixels"), own.pixels},
            {QStringLiteral("overlap"), own.overlap},
            {QStringLiteral("outline"), own.outline},
            {QStringLiteral("cover"), own.cover},
            {QStringLiteral("colour"), own.colourDistance}};
}

QJsonObject jsonOf(const TreeLevelsFound& tree)
{
    QJsonArray rows;
    for (std::size_t i = 0; i < tree.made.levels.size(); ++i) {
        const TreeLevel& level = tree.made.levels[i];
        QJsonObject row{{QStringLiteral("triangles"), qint64(level.triangles())},
                        {QStringLiteral("billboard"), level.billboard != nullptr},
                        {QStringLiteral("distance"), tree.made.switches.distances[i]}};
        if (i > 0 && !tree.likeness.empty()) {
            row.insert(QStringLiteral("atSwitch"), jsonOf(tree.likeness[i - 1]));
            row.insert(QStringLiteral("atPixel"), jsonOf(tree.unseen[i - 1]));
        }
        rows.append(row);
    }
    return {{QStringLiteral("name"), tree.name}, {QStringLiteral("levels"), rows}};
}

void addLevelsOptions(CommandLine& line)
{
    line.addInputOptions();
    line.addNodeOption();
    addExportOptions(line, ofLevels);
    line.add({QStringLiteral("check")}, QStringLiteral("Compares each level with the one before."));
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON array."));
}

Expected<ExportOptions> levelOptionsOf(const CommandLine& line)
{
    ExportOptions usual;
    usual.texture = true;
    usual.write.mapSize = checkedMaps;
    auto options = exportOptionsOf(line, ofLevels, usual);
    if (options && !options->levels.isWanted())
        options->levels = gameLevels();
    return options;
}

Expected<TreeLevelsFound> levelsFound(const Node& node, const Scene& scene, const ExportOptions& options,
                                      bool isChecked, const Progress& progress)
{
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), {});
    EvaluatedScene now = evaluator.at(scene, 0.0);
    auto made = levelsOf(node, now, options, progress.part(0.0, isChecked ? 0.5 : 1.0));
    RAMURE_TRY(made);
    TreeLevelsFound out{fromText(node.name), std::move(*made), {}, {}};
    if (!isChecked || out.made.levels.size() < 2)
        return out;
    const std::vector<TreeLevel>& levels = out.made.levels;
    auto likeness = likenessOf(levels, now.params(node), switchPixels(out.made.switches), checkedMaps,
                               progress.part(0.5, 0.9));
    RAMURE_TRY(likeness);
    auto unseen =
        likenessOf(levels, now.params(node), detailPixels(levels), checkedMaps, progress.part(0.9, 1.0));
    RAMURE_TRY(unseen);
    out.likeness = std::move(*likeness);
    out.unseen = std::move(*unseen);
    return out;
}

Expected<int> runLevels(const CommandLine& line)
{
    const auto options = levelOptionsOf(line);
    RAMURE_TRY(options);
    const auto found = [&]() -> Expected<std::vector<TreeLevelsFound>> {
        const Work work("levels");
        auto input = loadInput(line);
        RAMURE_TRY(input);
        RAMURE_TRY(keepNodes(*input, line.values("node")));
        if (!input->scene())
            return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees have levels of detail",
                        {line.arguments().front().toStdString()});
        const auto trees = treesOf(*input->scene());
        RAMURE_TRY(trees);
        std::vector<TreeLevelsFound> out;
        for (const Node* node : *trees) {
            if (!input->scene()->isShown(node->id))
                continue;
            const auto all = double(trees->size()), done = double(out.size());
            auto tree = levelsFound(*node, *input->scene(), *options, line.has("check"),
                                    work.progress().part(done / all, (done + 1.0) / all));
            RAMURE_TRY(tree);
            out.push_back(std::move(*tree));
        }
        return out;
    }();
    RAMURE_TRY(found);
    if (line.has("json")) {
        QJsonArray all;
        for (const TreeLevelsFound& tree : *found)
            all.append(jsonOf(tree));
        RAMURE_TRY(printJson(all));
        return exitGood;
    }
    QStringList texts;
    for (const TreeLevelsFound& tree : *found)
        texts.append(textOf(tree));
    RAMURE_TRY(print(texts.join(u'\n')));
    return exitGood;
}

} // namespace

const Command levelsCommand{levelsText, &addLevelsOptions, &runLevels};

} // namespace ramure::cli
