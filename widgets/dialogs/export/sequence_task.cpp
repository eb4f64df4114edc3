#include "widgets/dialogs/export/sequence_task.h"

#include "core/qt/document/document.h"
#include "widgets/dialogs/export/export_task.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/render/passes/film_file.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/picture_file.h"
#include "widgets/view/render/scene_at.h"
#include <QFile>
#include <numbers>

namespace ramure {
namespace {

struct Pictures
{
    Scene scene;
    TreeSource rest;
    PictureLook look;
    std::vector<PictureShot> shots;
};

/// What there is to see at a time, and from where.
struct Shown
{
    RenderScene scene;
    std::optional<NodeView> through;
};

Expected<Shown> sceneAt(const Pictures& pictures, double timeSeconds, Evaluator& evaluator,
                        const Progress& progress)
{
    EvaluatedScene now = evaluator.at(pictures.scene, timeSeconds);
    auto scene = renderSceneAt(now, pictures.look.view, progress);
    RAMURE_TRY(scene);
    return Shown{std::move(*scene), viewThrough(now, pictures.look.through)};
}

Expected<void> drawAll(const Pictures& pictures, OffscreenRenderer& renderer, const Progress& progress)
{
    Evaluator evaluator(pictures.rest, pictures.scene.timeline());
    std::optional<Shown> shown;
    std::unique_ptr<FilmFile> film;
    if (const PictureLook& look = pictures.look; !look.film.empty()) {
        auto begun = FilmFile::begin(look.film, look.size, look.framesPerSecond);
        RAMURE_TRY(begun);
        film = std::move(*begun);
    }
    const auto count = static_cast<double>(pictures.shots.size());
    for (std::size_t i = 0; i < pictures.shots.size(); ++i) {
        const PictureShot& shot = pictures.shots[i];
        const double from = static_cast<double>(i) / count;
        if (!shown || shot.timeSeconds != pictures.shots[i - 1].timeSeconds) {
            auto built =
                sceneAt(pictures, shot.timeSeconds, evaluator, progress.part(from, from + 0.5 / count));
            RAMURE_TRY(built);
            shown = std::move(*built);
        }
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        Camera camera = pictures.look.camera;
        RenderOptions options = pictures.look.options;
        if (shown->through && !pictures.look.allAround) {
            camera = shown->through->camera;
            options.lens = shown->through->lens;
        }
        if (pictures.look.allAround)
            camera.frameAllAround(shown->scene.framePoints(),
                                  double(pictures.look.size.width()) / pictures.look.size.height());
        camera.yawRad += shot.turnRad;
        const auto image = renderer.draw(shown->scene, camera, pictures.look.size, options,
                                         progress.part(from + 0.5 / count, from + 1.0 / count));
        RAMURE_TRY(image);
        RAMURE_TRY(film ? film->add(*image, progress) : savePicture(*image, shot.file));
        progress.report(static_cast<double>(i + 1) / count);
    }
    return film ? film->finish(progress) : Expected<void>();
}

} // namespace

std::vector<PictureShot> frameShots(const FrameSequence& frames, const std::string& path)
{
    std::vector<PictureShot> shots;
    for (std::int64_t i = 0; i < frames.count(); ++i) {
        const std::int64_t frame = frames.frame(i);
        shots.push_back({frames.timeOf(frame), 0.0, numberedFile(path, frame)});
    }
    return shots;
}

std::vector<PictureShot> turntableShots(int count, double timeSeconds, const std::string& path)
{
    std::vector<PictureShot> shots;
    for (int i = 0; i < count; ++i)
        shots.push_back({timeSeconds, 2.0 * std::numbers::pi * i / count, numberedFile(path, i)});
    return shots;
}

void SequenceTask::startMeshes(const Document& document, const ExportOptions& options,
                               const FrameSequence& frames, const QString& path)
{
    if (isRunning())
        return;
    m_files = frames.count();
    m_path = path;
    start([options, frames, scene = document.scene(), rest = snapshotOf(document),
           file = QFile::encodeName(path).toStdString()](const Progress& progress) {
        return exportSequence(scene, options, frames, rest, file, progress);
    });
}

void SequenceTask::startPictures(const Document& document, const PictureLook& look,
                                 std::vector<PictureShot> shots)
{
    if (isRunning() || shots.empty())
        return;
    m_files = look.film.empty() ? static_cast<std::int64_t>(shots.size()) : 1;
    m_path = QFile::decodeName((look.film.empty() ? shots.front().file : look.film).c_str());
    m_renderer = rendererForJob();
    const Pictures pictures{document.scene(), snapshotOf(document), look, std::move(shots)};
    start([pictures, renderer = m_renderer](const Progress& progress) -> Expected<void> {
        if (auto begun = renderer->begin(); !begun)
            return begun;
        auto drawn = drawAll(pictures, *renderer, progress);
        renderer->end();
        return drawn;
    });
}

} // namespace ramure
