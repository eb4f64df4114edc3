// The way of a scene: wished for when something changes, made in the background, uploaded in slices, shown.
#include "core/base/stopwatch.h"
#include "core/document/player.h"
#include "widgets/render/motion_reach.h"
#include "widgets/viewport/viewport_private.h"
#include <algorithm>
#include <limits>
#include <utility>

namespace ramure {
namespace {

/// What one turn of the event loop may copy to the graphics card: a few milliseconds where the processor has
/// to touch fresh memory for it.
constexpr std::size_t bytesPerTurn = std::size_t(2) << 20;

void addBlocks(const TreeResult& tree, std::vector<const void*>& blocks)
{
    for (const void* block :
         {static_cast<const void*>(tree.skeleton.get()), static_cast<const void*>(tree.simplified.get()),
          static_cast<const void*>(tree.sections.get()), static_cast<const void*>(tree.branches.get()),
          static_cast<const void*>(tree.draftTubes.get()), static_cast<const void*>(tree.foliage.get()),
          static_cast<const void*>(tree.leaves.get()), static_cast<const void*>(tree.apples.get())})
        blocks.push_back(block);
}

std::vector<const void*> blocksOf(const Document& document)
{
    std::vector<const void*> blocks;
    for (const Node& node : document.scene().nodes())
        if (const NodeResult* result = document.result(node.id))
            addBlocks(result->tree, blocks);
    return blocks;
}

} // namespace

SceneView Viewport::Private::sceneView() const
{
    const Selection& selection = document->selection();
    SceneView view;
    view.mode = settings->displayMode();
    view.leaves = settings->leavesVisible();
    view.apples = settings->applesVisible();
    view.frames = settings->frameDisplay();
    view.selectedNodes = selection.nodes;
    view.branchNode = selection.branchNode;
    view.branches = selection.branches;
    view.activeBranch = selection.activeBranch;
    view.hoverNode = hoverNode;
    view.hoverBranch = hoverBranch;
    view.inspected = inspected;
    view.isolatedNode = isolatedNode;
    view.isolatedBranches = isolatedBranches;
    view.timeSeconds = player ? player->timeSeconds() : 0.0;
    return view;
}

SceneWish Viewport::Private::wish()
{
    SceneWish wish;
    wish.scene = document->scene();
    wish.view = sceneView();
    wish.serial = ++wishes;
    wish.revision = std::numeric_limits<quint64>::max();
    for (const Node& node : document->scene().nodes()) {
        if (const NodeResult* result = document->result(node.id)) {
            wish.results.emplace(node.id, *resultOf(node.id));
            wish.revision = std::min(wish.revision, result->revision);
        }
    }
    wishedBlocks = blocksOf(*document);
    return wish;
}

void Viewport::onDocumentChanged(const Change& change)
{
    followGizmo(change);
    if (change.has(changeReset)) {
        d->frameNext = true;
        d->frameAfter = d->wishes;
        d->framing = Private::Framing::None;
        d->hoverNode = noNode;
        d->hoverBranch = noIndex;
        d->inspected = {};
        clearDefect();
    }
    // A new shape comes with its result: before it, the same picture would be drawn again.
    const bool trees = std::ranges::all_of(change.nodes, [this](NodeId id) {
        const Node* node = d->document->scene().find(id);
        return node && node->kind == NodeKind::Tree;
    });
    const bool waitsForResult = trees && change.firstStale < Stage::Placement &&
                                !change.has(~quint32(changeFile | changeParams | changeBranches));
    if (change.kinds == changeFile || waitsForResult)
        return;
    // A second opinion on a mesh changes no picture.
    if (change.kinds == changeResults && blocksOf(*d->document) == d->wishedBlocks)
        return;
    wishScene();
}

void Viewport::onSettingsChanged()
{
    if (d->camera.orthographic != d->settings->orthographic()) {
        d->camera.orthographic = d->settings->orthographic();
        d->to.orthographic = d->camera.orthographic;
        emit cameraChanged();
    }
    wishScene();
    update();
}

bool Viewport::isPicturePending() const
{
    return d->isStale() || d->sceneIsNew || d->highlightsStale;
}

void Viewport::wishScene()
{
    d->builder.wish(d->wish());
}

/// One scene after the other: each that was begun is shown, however fast new ones come.
void Viewport::takeScene()
{
    if (d->next)
        return;
    d->next = d->builder.take();
    if (!d->next)
        return;
    d->uploadedMs = 0.0;
    uploadScene();
}

void Viewport::uploadScene()
{
    if (!d->next)
        return;
    if (d->renderer) {
        const Stopwatch watch;
        makeCurrent();
        const bool ready = d->renderer->prepare(*d->next->scene, bytesPerTurn);
        doneCurrent();
        d->uploadedMs += watch.elapsed().wallMs;
        if (!ready) {
            d->uploading.start(0);
            return;
        }
    }
    showScene();
    takeScene();
}

/// For pictures and answers that must be of now, however long that takes.
void Viewport::finishScene()
{
    if (auto built = d->builder.finish())
        d->next = std::move(built);
    d->uploading.stop();
    showScene();
}

void Viewport::showScene()
{
    if (!d->next)
        return;
    BuiltScene built = *std::exchange(d->next, std::nullopt);
    const SceneView now = d->sceneView();
    d->highlightsStale = now.hoverNode != built.view.hoverNode || now.hoverBranch != built.view.hoverBranch;
    if (d->defectLines)
        built.scene->lines.push_back({d->defectLines, glm::dmat4(1.0), noNode, true, false});
    if (d->defectPoints)
        built.scene->points.push_back({d->defectPoints, glm::dmat4(1.0), noNode, true});
    d->builder.dispose(std::exchange(d->scene, std::move(built.scene)));
    d->sceneIsNew = true;
    d->times.buildMs = built.buildMs;
    d->times.revision = built.revision;
    d->updateShown();
    if (d->frameNext && built.serial > d->frameAfter && !d->scene->box.empty()) {
        d->frameNext = false;
        d->flight.stop();
        d->framed = true;
        d->camera.frame(reachPoints(d->document->scene(), *d->scene),
                        double(width()) / std::max(1, height()));
        emit cameraChanged();
    }
    if (!d->isStale()) {
        const auto framing = std::exchange(d->framing, Private::Framing::None);
        if (framing == Private::Framing::All)
            frameAll();
        else if (framing == Private::Framing::Selection)
            frameSelection();
        if (d->pending)
            finishSelecting();
    }
    update();
}

void Viewport::rebuildHighlights()
{
    d->highlightsStale = false;
    auto changed = std::make_shared<RenderScene>(*d->scene);
    updateHighlights(
        *changed, [this](NodeId id) { return d->resultOf(id); }, d->sceneView());
    d->scene = std::move(changed);
}

} // namespace ramure
