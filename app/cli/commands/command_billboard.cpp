#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/moments.h"
#include "app/cli/painter.h"
#include "app/cli/work.h"
#include "core/base/file_writer.h"
#include "core/evaluate/evaluator.h"
#include "core/lod/billboard_view.h"
#include "widgets/view/render/passes/billboard_files.h"
#include <QFileInfo>
#include <QJsonArray>
#include <algorithm>
#include <filesystem>

namespace ramure::cli {

namespace {

constexpr CommandText billboardText = {
    "billboard", "draws crossed cards or an atlas of views, for trees far away", "INPUT",
    "Draws what stands for a tree that is far away: crossed cards, or an atlas of views.",
    "Pictures are without light: the colour of the surface with how much of the pixel it covers, and its "
    "normal. Colours go on where nothing is, so that mip maps have no fringe.\n\n"
    "Cards: one GLB with its pictures inside (alpha MASK, two-sided, two triangles a card); with a FOLDER "
    "cards.glb, cards_colour.png and cards_normal.png.\n\n"
    "Atlas: views of the upper hemisphere, hemi-octahedral, straight (orthographic). Into the FOLDER go "
    "atlas_colour.png (colour, coverage), atlas_normal.png (normal in the tree's axes, depth as alpha) and "
    "atlas.json, which says where each view looks from and how the numbers are read."};

constexpr int mostDirections = 10'000;

struct BillboardRequest : BillboardWish
{
    QString output;
    int compare = 0; ///< directions; 0: not
    [[nodiscard]] bool isFile() const { return isCardFile(output); }
};

Expected<int> numberFrom(const CommandLine& line, const char* name, int least, int most, const char* unit)
{
    bool isNumber = false;
    const int value = line.value(name).toInt(&isNumber);
    if (!isNumber || value < least || value > most)
        return fail(
            ErrorCode::Invalid, "--%1 \"%2\": %3 to %4%5 expected",
            {name, line.value(name).toStdString(), std::to_string(least), std::to_string(most), unit});
    return value;
}

/// What goes with one kind alone is refused with the other.
Expected<void> checkKind(const CommandLine& line, bool isAtlas)
{
    for (const char* name : {"cards", "lying"})
        if (isAtlas && line.has(name))
            return fail(ErrorCode::Invalid, "--%1 goes with --kind cards", {name});
    for (const char* name : {"views", "compare"})
        if (!isAtlas && line.has(name))
            return fail(ErrorCode::Invalid, "--%1 goes with --kind atlas", {name});
    return {};
}

Expected<void> takeOutput(const CommandLine& line, BillboardRequest& out)
{
    out.output = line.value("o");
    if (out.output.isEmpty() || line.values("o").size() != 1)
        return fail(
            ErrorCode::Invalid,
            "one -o FOLDER or -o FILE.glb expected: `ramure-cli billboard --help` shows what it takes");
    if (out.isFile() && out.isAtlas)
        return fail(ErrorCode::Invalid, "%1: an atlas is three files: -o FOLDER expected",
                    {systemPath(out.output)});
    if (!out.isFile() && !std::filesystem::is_directory(systemPath(out.output)) &&
        !QFileInfo(out.output).suffix().isEmpty())
        return fail(ErrorCode::Unknown, "%1: unknown file ending: a FOLDER or FILE.glb expected",
                    {systemPath(out.output)});
    return {};
}

Expected<BillboardRequest> billboardRequestOf(const CommandLine& line)
{
    BillboardRequest out;
    const QString kind = line.value("kind");
    if (kind != QLatin1String("cards") && kind != QLatin1String("atlas"))
        return fail(ErrorCode::Unknown, "--kind \"%1\": cards or atlas expected", {kind.toStdString()});
    out.isAtlas = kind == QLatin1String("atlas");
    RAMURE_TRY(checkKind(line, out.isAtlas));
    RAMURE_TRY(takeOutput(line, out));
    const auto size = numberFrom(line, "size", leastBillboardSize, mostBillboardSize, " pixels");
    const auto cards = numberFrom(line, "cards", leastCards, mostCards, "");
    const auto views = numberFrom(line, "views", leastViews, mostViews, "");
    for (const auto* number : {&size, &cards, &views})
        if (!*number)
            return fail(number->error());
    out.size = *size;
    out.cards = *cards;
    out.views = *views;
    out.lying = line.has("lying");
    if (out.isAtlas && !holdsViews(out.size, out.views))
        return fail(ErrorCode::Invalid,
                    "--size %1: a multiple of %2 views expected, at least %3 pixels for each",
                    {std::to_string(out.size), std::to_string(out.views), std::to_string(leastViewSize)});
    if (line.has("compare")) {
        const auto directions = numberFrom(line, "compare", 1, mostDirections, " directions");
        RAMURE_TRY(directions);
        out.compare = *directions;
    }
    return out;
}

Expected<RenderScene> sceneOf(const Input& input, const Moments& moments, const Progress& progress)
{
    if (!input.scene())
        return sceneOfMesh(input.mesh()->joined());
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), moments.timeline);
    EvaluatedScene now = evaluator.at(*input.scene(), moments.timeSeconds);
    RAMURE_TRY(now.poseArms(progress));
    return renderSceneOf(now);
}

/// How alike the tree and the atlas are, of as many pixels as a view has.
Expected<QJsonObject> compared(const DrawSurfaces& draw, const BillboardAtlas& atlas, int count,
                               const Progress& progress)
{
    const int side = atlas.picture.width / atlas.views;
    const PlaneRect seen{glm::dvec2(-atlas.radius), glm::dvec2(atlas.radius)};
    Likeness mean{0.0, 0.0}, least;
    int done = 0;
    for (const glm::dvec3& direction : hemisphereDirections(count)) {
        const auto tree =
            bakeView(draw, viewFrame(direction), atlas.middle, seen, QSize(side, side), atlas.radius, false);
        RAMURE_TRY(tree);
        const Likeness now =
            likenessOf(coverageOf(*tree), atlasCoverage(atlas.picture, atlas.views, direction));
        mean.soft += now.soft / count;
        mean.hard += now.hard / count;
        least = {std::min(least.soft, now.soft), std::min(least.hard, now.hard)};
        progress.report(double(++done) / count);
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, "cancelled");
    }
    return QJsonObject{
        {QStringLiteral("directions"), count},        {QStringLiteral("pixels"), side},
        {QStringLiteral("coverageIou"), mean.soft},   {QStringLiteral("leastCoverageIou"), least.soft},
        {QStringLiteral("silhouetteIou"), mean.hard}, {QStringLiteral("leastSilhouetteIou"), least.hard}};
}

/// \returns what --json prints.
Expected<QJsonObject> bake(const DrawSurfaces& draw, const SceneBall& ball, const BillboardRequest& request,
                           const Progress& progress)
{
    const auto listed = [](const QStringList& names) {
        return QJsonObject{{QStringLiteral("files"), QJsonArray::fromStringList(names)}};
    };
    if (!request.isAtlas) {
        const auto cards = bakeCards(draw, ball, request.size, request.cards, request.lying, progress);
        RAMURE_TRY(cards);
        const auto names = writeCards(*cards, request.output);
        RAMURE_TRY(names);
        QJsonObject said = listed(*names);
        said.insert(QStringLiteral("triangles"), int(cards->mesh.faceCount()));
        return said;
    }
    const double baked = request.compare > 0 ? 0.5 : 1.0;
    const auto atlas = bakeAtlas(draw, ball, request.size, request.views, progress.part(0.0, baked));
    RAMURE_TRY(atlas);
    const auto names = writeAtlas(*atlas, request.output);
    RAMURE_TRY(names);
    QJsonObject said = listed(*names);
    if (request.compare > 0) {
        const auto likeness = compared(draw, *atlas, request.compare, progress.part(baked, 1.0));
        RAMURE_TRY(likeness);
        said.insert(QStringLiteral("likeness"), *likeness);
    }
    return said;
}

void addBillboardOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes into this folder, which is made where there is none; cards also as one "
                            "file."),
             QStringLiteral("FOLDER|FILE.glb"));
    line.addDefault({QStringLiteral("kind")},
                    QStringLiteral("cards (the default): upright rectangles through the middle; atlas: views "
                                   "all around and from above."),
                    QStringLiteral("cards|atlas"), QStringLiteral("cards"));
    line.addDefault({QStringLiteral("size")},
                    QStringLiteral("Pixels a side of the pictures, 64 to 8192; 2048 without it."),
                    QStringLiteral("PIXELS"), QStringLiteral("2048"));
    line.addDefault({QStringLiteral("cards")},
                    QStringLiteral("So many stand, 1 to 16, evenly turned; 2 without it."),
                    QStringLiteral("N"), QStringLiteral("2"));
    line.add({QStringLiteral("lying")}, QStringLiteral("One more card lies, seen from above."));
    line.addDefault({QStringLiteral("views")},
                    QStringLiteral("Of an atlas, so many each way, 2 to 32; 8 without it. The size is a "
                                   "multiple of it."),
                    QStringLiteral("N"), QStringLiteral("8"));
    line.add({QStringLiteral("compare")},
             QStringLiteral("Of an atlas: how alike it and the tree are from so many directions, 1 to 10000, "
                            "at the size of a view. Prints the mean and the least intersection over union: "
                            "of what each pixel is covered (coverageIou), and of the pixels that are covered "
                            "by half and more (silhouetteIou)."),
             QStringLiteral("N"));
    line.addInputOptions();
    line.addNodeOption();
    line.add({QStringLiteral("time")}, QStringLiteral("The scene after so many seconds; 0 without it."),
             QStringLiteral("SECONDS"));
    line.add(
        {QStringLiteral("json")},
        QStringLiteral("Prints one JSON object: the names of the files, the triangles of cards, and what "
                       "--compare found."));
}

Expected<int> runBillboard(const CommandLine& line)
{
    const auto request = billboardRequestOf(line);
    RAMURE_TRY(request);
    auto input = loadInput(line);
    RAMURE_TRY(input);
    RAMURE_TRY(keepNodes(*input, line.values("node")));
    const auto moments = momentsOf(line, *input);
    RAMURE_TRY(moments);
    const Work work("billboard");
    const auto scene = sceneOf(*input, *moments, work.progress());
    RAMURE_TRY(scene);
    RAMURE_TRY(!request->isFile() ? makeFolder(systemPath(request->output)) : Expected<void>());
    Painter painter;
    RAMURE_TRY(painter.begin());
    const DrawSurfaces draw = [&](const Camera& camera, QSize size, double reach, bool sparing) {
        return painter.drawSurfaces(*scene, camera, size, reach, sparing);
    };
    const auto said = bake(draw, ballOf(*scene), *request, work.progress());
    RAMURE_TRY(said);
    if (line.has("json") || request->compare > 0)
        RAMURE_TRY(printJson(*said));
    return exitGood;
}

} // namespace

const Command billboardCommand{billboardText, &addBillboardOptions, &runBillboard, true};

} // namespace ramure::cli
