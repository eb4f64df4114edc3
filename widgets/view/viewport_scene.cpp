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
          tree.leaves.key().get(), tree.apples.key().get()})
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

/// A tree of both has another shape.
bool haveGrown(const std::map<NodeId, TreeResult>& before, const std::map<NodeId, TreeResult>& now)
{
    return std::ranges::any_of(now, [&before](const auto& tree) {
        const auto found = before.find(tree.first);
        return found != before.end() && (found->second.skeleton != tree.second.skeleton ||
                                         found->second.branches != tree.second.branches);
    });
}

bool haveDrafts(const std::map<NodeId, TreeResult>& trees)
{
    return std::ranges::any_of(trees, [](const auto& tree) { return tree.second.draftTubes != nullptr; });
}

/// Every tree has a result, or a reason why there is none.
bool isAllGrown(const Document& document)
{
    return std::ranges::all_of(document.scene().nodes(), [&document](const Node& node) {
        return node.kind != NodeKind::Tree || document.isCurrent(node.id);
    });
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
    view.figure = settings->figureVisible();
    view.meadow = settings->meadowVisible();
    view.cameras = true;
    view.wind = settings->gameWind();
    view.seenThrough = through;
    view.branchNode = selection.branchNode;
    view.branches = selection.branches;
    view.activeBranch = selection.activeBranch;
    view.timeSeconds = context.seconds();
    view.hoverNode = context.hoverNode;
    if (context.hoverBranch != noIndex)
        view.hoverBranches = {context.hoverBranch};
    marks.addTo(view, document->scene());
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

/// To be called when the picture may have become one of other parameters than those of now, or of another
/// moment, or is so no more. For eyes and for screen readers; what lasts for a moment needs no words.
void Viewport::Private::noteAge()
{
    constexpr int momentMs = 400;
    const Player* player = context.player;
    const auto isOld = [this](const Node& node) {
        const NodeResult* result = document->result(node.id);
        return node.kind == NodeKind::Tree && result && !result->error &&
               result->revision < document->shapeRevision(node.id);
    };
    const bool isLate = isStale() || std::ranges::any_of(document->scene().nodes(), isOld) ||
                        (player && player->isBusy() && player->motion()->frame != player->frame());
    const bool isSaid = !widget->accessibleDescription().isEmpty();
    // What plays is seen to be late.
    if (!isLate || scene->box.empty() || (player && player->isPlaying())) {
        upload.late.stop();
        if (isSaid) {
            widget->setAccessibleDescription({});
            widget->update();
        }
    } else if (!isSaid && !upload.late.isActive()) {
        upload.late.start(momentMs);
    }
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
    d->outlineIsNew = d->outlineIsNew || change.has(changeSelection | changeReset);
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
        d->marks.beginDocument();
        clearDefect();
    }
    // A new shape comes with its result: before it, the same picture would be drawn again.
    const bool trees = std::ranges::all_of(change.nodes, [this](NodeId id) {
        const Node* node = d->document->scene().find(id);
        return node && node->kind == NodeKind::Tree;
    });
    const bool waitsForResult = trees && change.firstStale < Stage::Placement &&
                                !change.has(~quint32(changeFile | changeParams | changeBranches));
    d->noteAge();
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

void Viewport::wishScene()
{
    d->settling.start();
    SceneWish wish = d->wish();
    d->pending.follow(wish);
    d->builder.wish(std::move(wish));
}

/// One scene after the other: each that was begun is shown, however fast new ones come.
void Viewport::takeScene()
{
    if (d->upload.next)
        return;
    d->upload.next = d->builder.take();
    if (!d->upload.next)
        return;
    d->upload.pastMs = 0.0;
    uploadScene();
}

void Viewport::uploadScene()
{
    if (!d->upload.next)
        return;
    if (d->renderer) {
        const Stopwatch watch;
        makeCurrent();
        const bool ready = d->renderer->prepare(*d->upload.next->scene, bytesPerTurn);
        doneCurrent();
        d->upload.pastMs += watch.elapsed().wallMs;
        if (!ready) {
            d->upload.turns.start(0);
            return;
        }
    }
    showScene();
    takeScene();
}

/// For pictures and answers that must be of now, however long that takes.
void Viewport::finishScene()
{
    d->pending.wait();
    if (auto built = d->builder.finish())
        d->upload.next = std::move(built);
    d->upload.turns.stop();
    showScene();
}

void Viewport::showScene()
{
    if (!d->upload.next)
        return;
    BuiltScene built = *std::exchange(d->upload.next, std::nullopt);
    const SceneView now = d->sceneView();
    d->highlightsStale = now.hoverNode != built.view.hoverNode ||
                         now.hoverBranches != built.view.hoverBranches ||
                         now.hoverGoes != built.view.hoverGoes || now.hoverNodes != built.view.hoverNodes;
    auto before = std::exchange(d->scene, std::move(built.scene));
    auto treesBefore = std::make_shared<decltype(d->trees)>(std::exchange(d->trees, std::move(built.trees)));
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
    } else if (d->through == noNode && d->settings->hand()->tool() == HandTool::None && !d->tools.current() &&
               haveGrown(*treesBefore, d->trees)) { // what hands make is no growth
        const Camera to = d->frame.follow(d->flight.goal(), d->view().aspect(), haveDrafts(d->trees),
                                          framingPoints(d->document->scene(), *before),
                                          framingPoints(d->document->scene(), *d->scene));
        if (to != d->flight.goal())
            d->flight.setCamera(to);
    }
    d->builder.dispose(std::move(before));
    d->builder.dispose(std::move(treesBefore));
    if (!d->isStale()) {
        if (std::exchange(d->outlineIsNew, false))
            d->outline.show();
        if (d->frame.again && d->frame.isAll)
            d->frame.wanted = Private::Frame::Wish::All;
        d->frame.again = d->frame.again && d->frame.isAll && !isAllGrown(*d->document);
        const auto framing = std::exchange(d->frame.wanted, Private::Frame::Wish::None);
        if (framing == Private::Frame::Wish::All)
            frameAll();
        else if (framing == Private::Frame::Wish::Selection)
            frameSelection();
        d->tools.sceneReady();
    }
    d->noteAge();
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
