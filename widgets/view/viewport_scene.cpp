// The way of a scene: wished for when something changes, made in the background, uploaded in slices, shown.
#include "core/base/stopwatch.h"
#include "core/qt/session/motion/player.h"
#include "widgets/view/render/framing_points.h"
#include "widgets/view/viewport_private.h"
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

std::vector<NodeId> withAllBelow(const Scene& scene, NodeId top)
{
    std::vector<NodeId> nodes;
    for (const Node& node : scene.nodes())
        if (node.id == top || scene.isAncestor(top, node.id))
            nodes.push_back(node.id);
    return nodes;
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
    view.crowns = settings->crownsVisible();
    view.cameras = true;
    view.wind = settings->gameWind();
    view.seenThrough = through;
    view.branchNode = selection.branchNode;
    view.branches = selection.branches;
    view.activeBranch = selection.activeBranch;
    // What is pointed at elsewhere goes before what the mouse left behind here.
    const Branches& shownAs = pointed.node != noNode ? pointed : marked;
    view.hoverNode = shownAs.node != noNode ? shownAs.node : context.hoverNode;
    if (shownAs.node != noNode)
        view.hoverBranches = shownAs.branches;
    else if (context.hoverBranch != noIndex)
        view.hoverBranches = {context.hoverBranch};
    view.hoverGoes = shownAs.go;
    view.hoverThrough = shownAs.node != noNode && !shownAs.branches.empty();
    if (pointed.node != noNode && pointed.branches.empty())
        view.hoverNodes = withAllBelow(document->scene(), pointed.node);
    view.inspected = inspected;
    view.isolatedNode = isolated.node;
    view.isolatedBranches = isolated.branches;
    view.timeSeconds = context.seconds();
    return view;
}

const TreeResult* Viewport::Private::resultOf(NodeId id) const
{
    if (wishedMotion)
        if (const auto now = wishedMotion->trees.find(id); now != wishedMotion->trees.end())
            return &now->second;
    const NodeResult* result = document->result(id);
    return result ? &result->tree : nullptr;
}

/// The branches of the document have the numbers of those in the picture.
bool Viewport::Private::showsBranchesOf(NodeId node) const
{
    const TreeResult *now = resultOf(node), *seen = shownTree(node);
    return node == noNode || (now && seen && now->simplified == seen->simplified);
}

/// Of every tree there is a result, or a reason.
bool Viewport::Private::isAllGrown() const
{
    return std::ranges::all_of(document->scene().nodes(), [this](const Node& node) {
        return node.kind != NodeKind::Tree || document->isCurrent(node.id);
    });
}

/// The draft of a bent tree is worse than its pose.
bool Viewport::Private::isPosedDraft(const Change& change) const
{
    if (!context.limbPose || change.kinds != changeResults ||
        change.nodes != std::vector{context.limbPose->node()})
        return false;
    const NodeResult* result = document->result(context.limbPose->node());
    return result && result->draft;
}

SceneWish Viewport::Private::wish()
{
    SceneWish wish;
    wish.scene = document->scene();
    wish.view = sceneView();
    wish.view.waitsForBark = false;
    wish.serial = ++wishes;
    wish.revision = std::numeric_limits<quint64>::max();
    for (const Node& node : document->scene().nodes()) {
        if (const NodeResult* result = document->result(node.id)) {
            wish.results.emplace(node.id, *resultOf(node.id));
            wish.revision = std::min(wish.revision, result->revision);
        }
    }
    wishedBlocks = blocksOf(*document);
    if (const NodeResult* bent = context.limbPose ? document->result(context.limbPose->node()) : nullptr)
        context.limbPose->noteWish(wish.serial, bent->revision);
    return wish;
}

void Viewport::onDocumentChanged(const Change& change)
{
    if (change.has(~quint32(changeFile | changeResults)))
        updateTrail();
    else if (change.has(changeResults))
        d->trail.forgetSkeletons();
    if (change.has(changeSelection | changeStructure | changeReset))
        d->updateHint();
    d->outline.isNew = d->outline.isNew || change.has(changeSelection | changeReset);
    // The tint goes where the selection goes at once: another scene comes late while trees move or grow.
    if (change.has(changeSelection) && d->showsBranchesOf(d->document->selection().branchNode)) {
        d->highlightsStale = true;
        update();
    }
    if (d->through != noNode && !d->document->scene().find(d->through))
        d->leaveCamera();
    d->frame.again = d->frame.again || (change.has(changeStructure) && d->frame.isAll);
    if (change.has(changeReset)) {
        d->frame.isOfLast = true; // and stays as long as the last document is seen
        d->frame.next = true;
        d->frame.after = d->wishes;
        d->frame.wanted = Private::Frame::Wish::None;
        d->context.hoverNode = noNode;
        d->context.hoverBranch = noIndex;
        d->pointed = d->marked = {};
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
    if (change.kinds == changeFile || waitsForResult || d->isPosedDraft(change))
        return;
    // A second opinion on a mesh changes no picture.
    if (change.kinds == changeResults && blocksOf(*d->document) == d->wishedBlocks)
        return;
    wishScene();
}

void Viewport::onSettingsChanged()
{
    if (d->settings->orthographic())
        d->leaveCamera();
    d->flight.setOrthographic(d->settings->orthographic());
    wishScene();
    update();
}

bool Viewport::isPicturePending() const
{
    return d->isStale() || d->sceneIsNew || d->highlightsStale || d->barks.isBusy();
}

bool Viewport::isSettling() const
{
    return d->settling.isActive();
}

void Viewport::wishScene()
{
    d->settling.start();
    SceneWish wish = d->wish();
    d->barks.follow(wish);
    d->builder.wish(std::move(wish));
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
    d->barks.wait();
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
    d->highlightsStale = now.hoverNode != built.view.hoverNode ||
                         now.hoverBranches != built.view.hoverBranches ||
                         now.hoverGoes != built.view.hoverGoes || now.hoverNodes != built.view.hoverNodes;
    d->builder.dispose(std::exchange(d->scene, std::move(built.scene)));
    d->builder.dispose(std::make_shared<decltype(d->trees)>(std::exchange(d->trees, std::move(built.trees))));
    d->sceneIsNew = true;
    d->times.buildMs = built.buildMs;
    d->times.revision = built.revision;
    if (d->context.limbPose)
        d->context.limbPose->noteShown(built.serial);
    d->context.forgetLimbAtRest();
    d->updateShown();
    if (underMouse())
        d->hoverRest.start(); // what is under the cursor has other numbers now
    if (built.serial > d->frame.after && std::exchange(d->frame.isOfLast, false)) {
        Camera camera;
        camera.orthographic = d->settings->orthographic();
        d->flight.setCamera(camera);
    }
    if (d->frame.next && built.serial > d->frame.after && !d->scene->box.empty()) {
        d->frame.next = false;
        d->frame.isAll = true;
        Camera camera = d->camera();
        camera.frame(framingPoints(d->document->scene(), *d->scene), d->view().aspect());
        d->flight.setCamera(camera);
    }
    if (!d->isStale()) {
        if (std::exchange(d->outline.isNew, false))
            d->showOutline();
        if (d->frame.again && d->frame.isAll)
            d->frame.wanted = Private::Frame::Wish::All;
        d->frame.again = d->frame.again && d->frame.isAll && !d->isAllGrown();
        const auto framing = std::exchange(d->frame.wanted, Private::Frame::Wish::None);
        if (framing == Private::Frame::Wish::All)
            frameAll();
        else if (framing == Private::Frame::Wish::Selection)
            frameSelection();
        d->tools.sceneReady();
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
