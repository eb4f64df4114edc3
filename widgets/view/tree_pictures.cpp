#include "widgets/view/tree_pictures.h"

#include "core/evaluate/evaluator.h"
#include "core/pipeline/tree_pipeline.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/scene_builder.h"
#include <QCoreApplication>
#include <QThread>
#include <algorithm>
#include <atomic>
#include <utility>

namespace ramure {
namespace {

constexpr std::int64_t mostTriangles = 60'000; ///< of bark: more is not seen in a small picture

Expected<RenderScene> grown(TreePipeline& pipeline, const NodeParams& params, const Progress& progress)
{
    Node tree;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.name = "tree";
    tree.params = params;
    tree.params.tree = {};
    if (tree.params.mesh.targetTriangles > 0)
        tree.params.mesh.targetTriangles = std::min(tree.params.mesh.targetTriangles, mostTriangles);
    auto scene = Scene::fromNodes({std::move(tree)});
    RAMURE_TRY(scene);
    Evaluator evaluator(pipelineSource(pipeline), scene->timeline());
    EvaluatedScene now = evaluator.at(*scene, 0.0);
    const auto result = now.tree(scene->nodes().front(), Stage::Foliage, progress);
    RAMURE_TRY(result);
    return SceneBuilder().build(
        now, [&](NodeId) { return &*result; }, SceneView());
}

} // namespace

struct TreePictures::Drawer
{
    OffscreenRenderer renderer; ///< made on the thread of the interface
    bool hasBegun = false;
    std::atomic<bool> isOver = false; ///< no picture is wanted any more
    TreePipeline pipeline;

    Expected<TreePicture> draw(const NodeParams& params, QSize size, const std::optional<Camera>& as,
                               const Progress& progress)
    {
        if (!hasBegun)
            RAMURE_TRY(renderer.begin());
        hasBegun = true;
        const auto scene = grown(pipeline, params, progress);
        RAMURE_TRY(scene);
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        Camera camera = as.value_or(Camera());
        if (!as)
            camera.frame(scene->framePoints(), double(size.width()) / double(size.height()));
        auto image = renderer.draw(*scene, camera, size);
        RAMURE_TRY(image);
        return TreePicture{std::move(*image), camera};
    }
    /// The context ends on the thread that it was made on.
    void end()
    {
        if (std::exchange(hasBegun, false))
            renderer.end();
    }
};

/// Its surface may be a window of the system.
void TreePictures::deleteOnMainThread(Drawer* drawer)
{
    if (qApp && QThread::currentThread() != qApp->thread())
        QMetaObject::invokeMethod(
            qApp, [drawer] { delete drawer; }, Qt::QueuedConnection);
    else
        delete drawer;
}

TreePictures::TreePictures(QObject* parent)
    : QObject(parent)
    , m_drawer(new Drawer, deleteOnMainThread)
    , m_job(nullptr, Job::Manner::Polite)
{
    m_drawer->pipeline.setCacheSize(1);
}

/// A picture that takes longer than that is drawn to its end by a thread left to itself, which ends the
/// context then.
TreePictures::~TreePictures()
{
    m_drawer->isOver = true;
    m_job.start([drawer = m_drawer](const Progress&) -> Expected<void> {
        drawer->end();
        return {};
    });
    m_job.wait(Job::patience);
}

void TreePictures::draw(const NodeParams& params, QSize size, Take take, const std::optional<Camera>& camera)
{
    m_job.start(
        [drawer = m_drawer, params, size, camera](const Progress& progress) {
            auto made = drawer->draw(params, size, camera, progress);
            if (drawer->isOver)
                drawer->end();
            return made;
        },
        [take = std::move(take)](Expected<TreePicture>&& made) { take(std::move(made)); });
}

void TreePictures::stop()
{
    m_job.forget();
}

} // namespace ramure
