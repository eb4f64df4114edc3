#include "app/cli/batch/batch_options.h"
#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/moments.h"
#include "app/cli/painter.h"
#include "app/cli/picture_options.h"
#include "app/cli/work.h"
#include "core/evaluate/evaluator.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/render/passes/film_file.h"
#include "widgets/view/render/passes/picture_file.h"
#include "widgets/view/render/passes/sky_picture.h"
#include <QFileInfo>
#include <memory>
#include <numbers>
#include <optional>

namespace ramure::cli {

namespace {

constexpr CommandText renderText = {
    "render", "draws a picture", "INPUT", "Draws a picture of a tree, a scene or a mesh file.",
    "Without a display a virtual X server (Xvfb) is started for the time it takes. "
    "The camera shows all that is visible."};

constexpr int skyWidth = 1024;

struct RenderRequest
{
    QString file;
    QSize size;
    DisplayMode mode = DisplayMode::Mesh;
    int turntable = 0; ///< pictures all around; 0 = one from the front
    bool isFilm = false;
    PictureOptions picture;
};

constexpr int mostTurns = 10'000;

QStringList modeNames()
{
    QStringList names;
    for (const DisplayModeRow& row : displayModes())
        names << QLatin1String(row.name());
    return names;
}

Expected<RenderRequest> renderRequestOf(const CommandLine& line)
{
    RenderRequest out;
    out.file = line.value("o");
    if (out.file.isEmpty() || line.values("o").size() != 1)
        return fail(ErrorCode::Invalid,
                    "one -o FILE.png expected: `ramure-cli render --help` shows what it takes");
    out.isFilm = isFilm(systemPath(out.file));
    if (!out.isFilm && QFileInfo(out.file).suffix().toLower() != QLatin1String("png"))
        return fail(ErrorCode::Unknown,
                    "%1: unknown file ending: pictures are written as .png, films as .mp4 or .webm",
                    {out.file.toStdString()});
    const auto size = pictureSizeFrom(line.value("size"));
    RAMURE_TRY(size);
    out.size = *size;
    const auto mode = displayModeFromName(line.value("mode").toStdString());
    if (!mode)
        return fail(ErrorCode::Unknown, "--mode \"%1\": %2 expected",
                    {line.value("mode").toStdString(), commaList(modeNames()).toStdString()});
    out.mode = *mode;
    auto picture = pictureOptionsOf(line);
    RAMURE_TRY(picture);
    out.picture = std::move(*picture);
    if (line.has("turntable")) {
        bool whole = false;
        out.turntable = line.value("turntable").toInt(&whole);
        if (!whole || out.turntable < 2 || out.turntable > mostTurns)
            return fail(ErrorCode::Invalid, "--turntable \"%1\": a whole number from 2 to %2 expected",
                        {line.value("turntable").toStdString(), std::to_string(mostTurns)});
        if (line.has("frames") || line.has("camera"))
            return fail(ErrorCode::Invalid, "--turntable goes with neither --frames nor --camera");
    }
    if (out.isFilm)
        RAMURE_TRY(canFilm(systemPath(out.file)));
    if (out.isFilm && !line.has("turntable") && !line.has("frames") && !line.has("wind-loop"))
        return fail(ErrorCode::Invalid, "%1: a film needs --frames, --wind-loop or --turntable",
                    {out.file.toStdString()});
    return out;
}

/// The camera of this name; noNode where none is asked for.
Expected<NodeId> cameraNode(const Input& input, const QString& name)
{
    if (name.isEmpty())
        return noNode;
    QStringList names;
    for (const Node& node : input.scene() ? input.scene()->nodes() : std::vector<Node>()) {
        if (node.kind != NodeKind::Camera)
            continue;
        names << QString::fromStdString(node.name);
        if (names.back() == name)
            return node.id;
    }
    if (names.isEmpty())
        return fail(ErrorCode::Unknown,
                    "--camera \"%1\": EX,EY,EZ,TX,TY,TZ[,ANGLE] expected: there is no camera",
                    {name.toStdString()});
    return fail(ErrorCode::Unknown, "--camera \"%1\": no camera has this name, there is %2",
                {name.toStdString(), commaList(names).toStdString()});
}

struct Sight
{
    RenderScene scene;
    std::optional<NodeView> through; ///< of the camera that was asked for
};

Expected<Sight> sceneOf(const Input& input, const CommandLine& line, const RenderRequest& request,
                        NodeId camera, Evaluator& evaluator, double timeSeconds, const Progress& progress)
{
    if (input.scene()) {
        EvaluatedScene now = evaluator.at(*input.scene(), timeSeconds);
        RAMURE_TRY(now.poseArms(progress));
        SceneView view;
        view.mode = request.mode;
        view.figure = line.has("figure");
        view.meadow = !line.has("bare-ground");
        auto scene = renderSceneOf(now, view);
        RAMURE_TRY(scene);
        return Sight{std::move(*scene), viewThrough(now, camera)};
    }
    if (line.has("mode") && request.mode != DisplayMode::Mesh)
        return fail(ErrorCode::Invalid, "--mode needs a tree: the input is a mesh");
    return Sight{sceneOfMesh(input.mesh()->joined()), {}};
}

/// Draws pictures, and puts each into a file of its own or into the film.
class Pictures
{
public:
    explicit Pictures(const RenderRequest& request)
        : m_request(request)
    {
    }

    /// Call it once. Errors: those of Painter and FilmFile.
    Expected<void> begin(double framesPerSecond)
    {
        RAMURE_TRY(m_painter.begin());
        if (!m_request.isFilm)
            return {};
        auto film = FilmFile::begin(systemPath(m_request.file), m_request.size, framesPerSecond);
        RAMURE_TRY(film);
        m_film = std::move(*film);
        return {};
    }
    /// \param file of the picture where there is no film
    Expected<void> draw(const RenderScene& scene, const NodeView& view, const QString& file,
                        const Progress& progress)
    {
        const auto image =
            m_painter.draw(scene, view.camera, m_request.size, optionsFor(m_request.picture, view), progress);
        RAMURE_TRY(image);
        const auto kept = m_film ? m_film->add(*image, progress) : savePicture(*image, systemPath(file));
        RAMURE_TRY(kept);
        progress.report(1.0);
        return progress.cancelled() ? fail(ErrorCode::Cancelled, "cancelled") : Expected<void>();
    }
    Expected<void> finish(const Progress& progress)
    {
        return m_film ? m_film->finish(progress) : Expected<void>();
    }

private:
    const RenderRequest& m_request;
    Painter m_painter;
    std::unique_ptr<FilmFile> m_film;
};

/// All around one scene: the camera keeps its height and a distance from which all is seen from every side.
Expected<void> drawTurntable(Pictures& pictures, const RenderScene& scene, Camera camera,
                             const RenderRequest& request, const Progress& progress)
{
    camera.frameAllAround(scene.framePoints(), double(request.size.width()) / double(request.size.height()));
    const double start = camera.yawRad;
    for (int i = 0; i < request.turntable; ++i) {
        camera.yawRad = start + 2.0 * std::numbers::pi * i / request.turntable;
        const Progress part = progress.part(double(i) / request.turntable, double(i + 1) / request.turntable);
        RAMURE_TRY(pictures.draw(scene, {camera, {}}, numberedFile(request.file, i), part));
    }
    return {};
}

/// One picture, one for each frame, or one from each side. The camera of a sequence is that of its first
/// frame, or a node's as it moves.
Expected<void> drawAll(const Input& input, const CommandLine& line, const RenderRequest& request,
                       const Moments& moments, const Progress& progress)
{
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), moments.timeline);
    Pictures pictures(request);
    std::optional<Camera> camera;
    const auto node = cameraNode(input, request.picture.cameraNode);
    RAMURE_TRY(node);
    const std::vector<std::int64_t> frames =
        moments.isSequence() ? moments.frames : std::vector<std::int64_t>{0};
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double time = moments.isSequence() ? moments.timeOf(frames[i]) : moments.timeSeconds;
        const auto shown = sceneOf(input, line, request, *node, evaluator, time, progress);
        RAMURE_TRY(shown);
        if (!camera) {
            const std::int64_t step = frames.size() > 1 ? frames[1] - frames[0] : 1;
            RAMURE_TRY(pictures.begin(moments.framesPerSecond / double(step)));
            camera = request.picture.camera ? *request.picture.camera : cameraFor(shown->scene, request.size);
        }
        if (request.turntable > 0) {
            RAMURE_TRY(drawTurntable(pictures, shown->scene, *camera, request, progress));
            break;
        }
        const QString file = moments.isSequence() ? numberedFile(request.file, frames[i]) : request.file;
        const NodeView view = shown->through.value_or(NodeView{*camera, {}});
        const auto count = double(frames.size());
        const Progress part = progress.part(double(i) / count, double(i + 1) / count);
        RAMURE_TRY(pictures.draw(shown->scene, view, file, part));
    }
    return pictures.finish(progress);
}

void addRenderOptions(CommandLine& line)
{
    line.add(
        {QStringLiteral("o"), QStringLiteral("output")},
        QStringLiteral("Writes this file: pictures as .png; as .mp4 or .webm a film of all pictures, for "
                       "which the program ffmpeg must be installed."),
        QStringLiteral("FILE.png"));
    line.addDefault(
        {QStringLiteral("size")},
        QStringLiteral("Size of the picture in pixels, 16 to 8192 each way; 1280x800 without it."),
        QStringLiteral("WIDTHxHEIGHT"), QStringLiteral("1280x800"));
    line.addDefault(
        {QStringLiteral("mode")},
        QStringLiteral(
            "skeleton, simplified (removed nodes in red), rough, sections, mesh (the default), checker "
            "(texture coordinates as squares) or stretch (blue where squares stay squares, yellow "
            "from 1.25 on, red from 2 on)."),
        modeNames().join(QLatin1Char('|')), QStringLiteral("mesh"));
    addMomentOptions(line, MomentOptions::Sequence);
    line.add(
        {QStringLiteral("turntable")},
        QStringLiteral("So many pictures all around, 2 to 10000; the number goes before the file's ending."),
        QStringLiteral("N"));
    addPictureOptions(line);
    line.addInputOptions();
    line.addNodeOption();
}

Expected<int> runRender(const CommandLine& line)
{
    const auto request = renderRequestOf(line);
    RAMURE_TRY(request);
    const DisplayModeRow& mode = rowOf(request->mode);
    if (mode.shown == Shown::Texture && (line.has("time") || line.has("frames")))
        return fail(ErrorCode::Invalid, "--mode %1 needs the tree at rest: without --time and --frames",
                    {mode.name()});
    auto input = loadInput(line);
    RAMURE_TRY(input);
    RAMURE_TRY(keepNodes(*input, line.values("node")));
    const auto moments = momentsOf(line, *input);
    RAMURE_TRY(moments);
    if (const auto& sky = request->picture.skyFile; !sky.isEmpty()) {
        RAMURE_TRY(saveSkyPicture(request->picture.options.light, skyWidth, systemPath(sky),
                                  request->picture.skyHasSun));
    }
    const Work work("render");
    RAMURE_TRY(drawAll(*input, line, *request, *moments, work.progress()));
    return exitGood;
}

} // namespace

const Command renderCommand{renderText, &addRenderOptions, &runRender, true};

} // namespace ramure::cli
