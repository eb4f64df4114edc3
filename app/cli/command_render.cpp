#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/moments.h"
#include "app/cli/virtual_display.h"
#include "app/cli/work.h"
#include "core/evaluate/evaluator.h"
#include "widgets/view/render/offscreen_renderer.h"
#include "widgets/view/render/picture_file.h"
#include "widgets/view/render/scene_builder.h"
#include <QFileInfo>
#include <QGuiApplication>
#include <map>
#include <numbers>
#include <optional>

namespace ramure::cli {

namespace {

constexpr CommandText text = {"render", "draws a picture", "INPUT",
                              "Draws a picture of a tree, a scene or a mesh file.",
                              "Without a display a virtual X server (Xvfb) is started for the time it takes. "
                              "The camera shows all that is visible."};

/// In the order of Backdrop; then without any.
constexpr std::string_view backgroundNames[] = {"landscape", "light", "dark", "none"};
constexpr int smallestSide = 16;
constexpr int largestSide = 8192;

Expected<QSize> parseSize(const QString& value)
{
    const QStringList sides = value.toLower().split(QLatin1Char('x'));
    bool isWidth = false;
    bool isHeight = false;
    const int width = sides.front().toInt(&isWidth);
    const int height = sides.back().toInt(&isHeight);
    const auto isSide = [](int side) { return side >= smallestSide && side <= largestSide; };
    if (sides.size() != 2 || !isWidth || !isHeight || !isSide(width) || !isSide(height))
        return fail(ErrorCode::Invalid, "--size \"%1\": WIDTHxHEIGHT expected, each %2 to %3 pixels",
                    {value.toStdString(), std::to_string(smallestSide), std::to_string(largestSide)});
    return QSize(width, height);
}

struct Request
{
    QString file;
    QSize size;
    DisplayMode mode = DisplayMode::Mesh;
    int turntable = 0;            ///< pictures all around; 0 = one from the front
    std::optional<Camera> camera; ///< else one that shows all that is visible
    RenderOptions options;
};

/// So many numbers with commas between them. \param form what is expected, for the error
Expected<std::vector<double>> numbersOf(const CommandLine& line, const char* option, qsizetype least,
                                        qsizetype most, const char* form)
{
    const QStringList words = line.value(option).split(u',');
    std::vector<double> numbers;
    for (const QString& word : words) {
        bool isNumber = false;
        numbers.push_back(word.toDouble(&isNumber));
        if (!isNumber || !(std::abs(numbers.back()) <= 1e6)) {
            numbers.clear();
            break;
        }
    }
    const auto count = static_cast<qsizetype>(numbers.size());
    if (count < least || count > most)
        return fail(ErrorCode::Invalid, "--%1 \"%2\": %3 expected",
                    {option, line.value(option).toStdString(), form});
    return numbers;
}

Expected<Camera> cameraOf(const CommandLine& line)
{
    const char* form = "EX,EY,EZ,TX,TY,TZ[,ANGLE], metres and degrees,";
    const auto numbers = numbersOf(line, "camera", 6, 7, form);
    if (!numbers)
        return fail(numbers.error());
    const std::vector<double>& n = *numbers;
    const glm::dvec3 eye(n[0], n[1], n[2]), target(n[3], n[4], n[5]), away = eye - target;
    const double angle = n.size() > 6 ? n[6] : glm::degrees(Camera().fovRad);
    const double distance = glm::length(away);
    if (distance < 1e-3 || angle < 1.0 || angle > 150.0)
        return fail(
            ErrorCode::Invalid,
            "--camera \"%1\": the eye must be a millimetre or more from the target, the angle 1 to 150 "
            "degrees",
            {line.value("camera").toStdString()});
    Camera camera;
    camera.target = target;
    camera.distance = distance;
    camera.pitchRad = std::asin(std::clamp(away.y / distance, -1.0, 1.0));
    camera.yawRad = std::atan2(away.x, away.z);
    camera.fovRad = glm::radians(angle);
    return camera;
}

Expected<RenderOptions> optionsOf(const CommandLine& line)
{
    RenderOptions options;
    if (line.has("sun")) {
        const auto sun = numbersOf(line, "sun", 2, 2, "DIRECTION,HEIGHT in degrees");
        if (!sun)
            return fail(sun.error());
        if ((*sun)[1] < SceneLight::leastHeightDeg || (*sun)[1] > 90.0)
            return fail(ErrorCode::Invalid, "--sun \"%1\": its height must be 2 to 90 degrees",
                        {line.value("sun").toStdString()});
        options.light.azimuthDeg = (*sun)[0];
        options.light.heightDeg = (*sun)[1];
    }
    const QString quality = line.value("quality");
    const auto row = std::ranges::find(qualities(), quality.toStdString(), &ModeRow<Quality>::name);
    if (row == qualities().end())
        return fail(ErrorCode::Unknown, "--quality \"%1\": draft, good or best expected",
                    {quality.toStdString()});
    options.quality = row->mode;
    const QString background = line.value("background");
    const auto known = std::ranges::find(backgroundNames, background.toStdString());
    if (known == std::end(backgroundNames))
        return fail(ErrorCode::Unknown, "--background \"%1\": landscape, light, dark or none expected",
                    {background.toStdString()});
    const auto number = static_cast<int>(known - std::begin(backgroundNames));
    options.world = number < backdropCount;
    if (options.world)
        options.light.backdrop = static_cast<Backdrop>(number);
    return options;
}

constexpr int mostTurns = 10'000;

QStringList modeNames()
{
    QStringList names;
    for (const DisplayModeRow& row : displayModes())
        names << QLatin1String(row.name());
    return names;
}

Expected<Request> requestOf(const CommandLine& line)
{
    Request out;
    out.file = line.value("o");
    if (out.file.isEmpty() || line.values("o").size() != 1)
        return fail(ErrorCode::Invalid,
                    "one -o FILE.png expected: `ramure-cli render --help` shows what it takes");
    if (QFileInfo(out.file).suffix().toLower() != QLatin1String("png"))
        return fail(ErrorCode::Unknown, "%1: unknown file ending: pictures are written as .png",
                    {out.file.toStdString()});
    const auto size = parseSize(line.value("size"));
    if (!size)
        return fail(size.error());
    out.size = *size;
    const auto mode = displayModeFromName(line.value("mode").toStdString());
    if (!mode)
        return fail(ErrorCode::Unknown, "--mode \"%1\": %2 expected",
                    {line.value("mode").toStdString(), commaList(modeNames()).toStdString()});
    out.mode = *mode;
    const auto options = optionsOf(line);
    if (!options)
        return fail(options.error());
    out.options = *options;
    if (line.has("camera")) {
        const auto camera = cameraOf(line);
        if (!camera)
            return fail(camera.error());
        out.camera = *camera;
    }
    if (line.has("turntable")) {
        bool whole = false;
        out.turntable = line.value("turntable").toInt(&whole);
        if (!whole || out.turntable < 2 || out.turntable > mostTurns)
            return fail(ErrorCode::Invalid, "--turntable \"%1\": a whole number from 2 to %2 expected",
                        {line.value("turntable").toStdString(), std::to_string(mostTurns)});
        if (line.has("frames") || line.has("camera"))
            return fail(ErrorCode::Invalid, "--turntable goes with neither --frames nor --camera");
    }
    return out;
}

Expected<RenderScene> treeScene(EvaluatedScene& now, DisplayMode mode)
{
    const Scene& scene = now.scene();
    const auto nodes = treesOrShapes(scene);
    if (!nodes)
        return fail(nodes.error());
    std::map<NodeId, TreeResult> results;
    for (const Node* node : *nodes) {
        if (!scene.isShown(node->id))
            continue;
        auto result = evaluateTree(now, *node, nodes->size() > 1, rowOf(mode).stage);
        if (!result)
            return fail(result.error());
        results.emplace(node->id, std::move(*result));
    }
    SceneView view;
    view.mode = mode;
    const auto resultOf = [&](NodeId id) {
        const auto found = results.find(id);
        return found == results.end() ? nullptr : &found->second;
    };
    return SceneBuilder().build(now, resultOf, view);
}

Expected<RenderScene> sceneOf(const Input& input, const CommandLine& line, DisplayMode mode,
                              Evaluator& evaluator, double timeSeconds, const Progress& progress)
{
    if (input.scene()) {
        EvaluatedScene now = evaluator.at(*input.scene(), timeSeconds);
        if (auto posed = now.poseArms(progress); !posed)
            return fail(std::move(posed.error()));
        return treeScene(now, mode);
    }
    if (line.has("mode") && mode != DisplayMode::Mesh)
        return fail(ErrorCode::Invalid, "--mode needs a tree: the input is a mesh");
    return sceneOfMesh(input.mesh()->joined());
}

/// The platform without windows of Qt: all it needs is the X server behind DISPLAY, where it finds OpenGL.
class Painter
{
public:
    Expected<void> begin()
    {
        if (const auto ensured = m_display.ensure(); !ensured)
            return fail(ensured.error());
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
            qputenv("QT_QPA_PLATFORM", "offscreen");
        m_application.emplace(m_argc, m_argv);
        m_renderer.emplace();
        return m_renderer->begin();
    }
    Expected<void> draw(const RenderScene& scene, const Camera& camera, const Request& request,
                        const QString& file)
    {
        const auto image = m_renderer->draw(scene, camera, request.size, request.options);
        if (!image)
            return fail(image.error());
        return savePicture(*image, systemPath(file));
    }

private:
    VirtualDisplay m_display;
    char m_name[11] = "ramure-cli";
    char* m_argv[2] = {m_name, nullptr};
    int m_argc = 1;
    std::optional<QGuiApplication> m_application;
    std::optional<OffscreenRenderer> m_renderer;
};

Camera cameraFor(const RenderScene& scene, QSize size)
{
    Camera camera;
    camera.frame(scene.framePoints(), double(size.width()) / double(size.height()));
    return camera;
}

/// All around one scene: the camera keeps its height and a distance from which all is seen from every side.
Expected<void> drawTurntable(Painter& painter, const RenderScene& scene, Camera camera,
                             const Request& request, const Progress& progress)
{
    camera.frameAllAround(scene.framePoints(), double(request.size.width()) / double(request.size.height()));
    const double start = camera.yawRad;
    for (int i = 0; i < request.turntable; ++i) {
        camera.yawRad = start + 2.0 * std::numbers::pi * i / request.turntable;
        if (auto drawn = painter.draw(scene, camera, request, numberedFile(request.file, i)); !drawn)
            return drawn;
        progress.report(double(i + 1) / request.turntable);
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, "cancelled");
    }
    return {};
}

/// One picture, one for each frame, or one from each side. The camera of a sequence is that of its first
/// frame.
Expected<void> drawAll(const Input& input, const CommandLine& line, const Request& request,
                       const Moments& moments, const Progress& progress)
{
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), moments.timeline);
    Painter painter;
    std::optional<Camera> camera;
    const std::vector<std::int64_t> frames =
        moments.isSequence() ? moments.frames : std::vector<std::int64_t>{0};
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double time = moments.isSequence() ? moments.timeOf(frames[i]) : moments.timeSeconds;
        const auto scene = sceneOf(input, line, request.mode, evaluator, time, progress);
        if (!scene)
            return fail(scene.error());
        if (!camera) {
            if (auto begun = painter.begin(); !begun)
                return begun;
            camera = request.camera ? *request.camera : cameraFor(*scene, request.size);
        }
        if (request.turntable > 0)
            return drawTurntable(painter, *scene, *camera, request, progress);
        const QString file = moments.isSequence() ? numberedFile(request.file, frames[i]) : request.file;
        if (auto drawn = painter.draw(*scene, *camera, request, file); !drawn)
            return drawn;
        progress.report(double(i + 1) / double(frames.size()));
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, "cancelled");
    }
    return {};
}

void addOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")}, QStringLiteral("Writes this file."),
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
    line.add({QStringLiteral("camera")},
             QStringLiteral("Where the camera stands and what it looks at, in metres, and its vertical angle "
                            "in degrees (40 without it). Without this option it shows all that is visible."),
             QStringLiteral("EX,EY,EZ,TX,TY,TZ[,ANGLE]"));
    line.add({QStringLiteral("sun")},
             QStringLiteral("Where the sun stands: degrees clockwise from the north (-Z; 90 is the east, X), "
                            "and its height over the horizon, 2 to 90; 136,46 without it."),
             QStringLiteral("DIRECTION,HEIGHT"));
    line.addDefault(
        {QStringLiteral("quality")},
        QStringLiteral("draft (sun and sky light alone), good (crowns that are darker inside, the "
                       "response of film; the usual) or best (several samples a pixel, softer "
                       "shadows; slower)."),
        QStringLiteral("draft|good|best"), QStringLiteral("good"));
    line.addDefault({QStringLiteral("background")},
                    QStringLiteral("landscape (sky and meadow), light or dark (a studio of one colour that "
                                   "takes shadows) or none (transparent)."),
                    QStringLiteral("landscape|light|dark|none"), QStringLiteral("landscape"));
    line.addInputOptions();
    line.addNodeOption();
}

Expected<int> run(const CommandLine& line)
{
    const auto request = requestOf(line);
    if (!request)
        return fail(request.error());
    const DisplayModeRow& mode = rowOf(request->mode);
    if (mode.shown == Shown::Texture && (line.has("time") || line.has("frames")))
        return fail(ErrorCode::Invalid, "--mode %1 needs the tree at rest: without --time and --frames",
                    {mode.name()});
    auto input = loadInput(line.arguments().front(), line.values("set"));
    if (!input)
        return fail(input.error());
    if (const auto kept = keepNodes(*input, line.values("node")); !kept)
        return fail(kept.error());
    const auto moments = momentsOf(line, *input);
    if (!moments)
        return fail(moments.error());
    const Work work("render");
    if (const auto drawn = drawAll(*input, line, *request, *moments, work.progress()); !drawn)
        return fail(drawn.error());
    return exitGood;
}

} // namespace

const Command renderCommand{text, &addOptions, &run, true};

} // namespace ramure::cli
