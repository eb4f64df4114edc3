#include "core/qt/session/motion/motion_worker.h"

#include "core/rig/physics/animated_physics.h"
#include "core/scene/object_mesh.h"

#include <QScopeGuard>
#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace ramure {

using Clock = std::chrono::steady_clock;

/// Trees whose shape took less the last time need no sketch.
static constexpr double sketchSeconds = 0.1;

/// The band is looked through at most so often while frames follow each other.
static constexpr std::chrono::milliseconds bandRest{200};

MotionWorker::MotionWorker(Listener listener)
    : m_listener(std::move(listener))
{
}

void takeOverHand(MotionRequest& next, const MotionRequest& skipped)
{
    next.forgetHand = next.forgetHand || skipped.forgetHand;
    for (const MotionTree& from : skipped.trees)
        for (MotionTree& tree : next.trees)
            if (tree.node->id == from.node->id)
                tree.shaken.insert(tree.shaken.begin(), from.shaken.begin(), from.shaken.end());
}

/// Where the nodes are, and the objects whose parameters move.
static void placeNodes(MotionFrame& frame, EvaluatedScene& now)
{
    for (std::size_t i = 0; i < now.scene().nodes().size(); ++i) {
        const Node& node = now.scene().nodes()[i];
        frame.transforms.emplace(node.id, now.transforms()[i]);
        if (node.kind == NodeKind::Tree || !node.animation.movesParams())
            continue;
        const NodeParams& params = now.params(node);
        const bool isSame =
            params.primitive == node.params.primitive && params.terrain == node.params.terrain;
        ObjectNow& object = frame.objects[node.id];
        object = {isSame ? nullptr : objectMesh(node, params), params.surface, std::nullopt};
        if (node.kind == NodeKind::Arm)
            object.target = params.arm.target;
    }
}

/// Into the frame what a run makes of its node.
static Expected<void> move(NodeId node, NodeRun& run, const MotionRequest& request, MotionFrame& frame,
                           const Progress& progress)
{
    auto motion = run.motionAt(frame.timeSeconds, request.timeline, progress);
    RAMURE_TRY(motion);
    frame.nodes.insert_or_assign(node, std::move(*motion));
    return {};
}

/// The tree as its tracks shape it now.
Expected<TreeResult> MotionWorker::shapeOf(const MotionTree& tree, EvaluatedScene& now, MotionFrame& frame,
                                           const Progress& progress)
{
    if (!movesShape(tree.node->animation))
        return tree.tree;
    auto made = m_pipeline.evaluate(now.params(*tree.node), Stage::Foliage, progress);
    if (!made)
        return made;
    double& seconds = m_shapeSeconds[tree.node->id];
    seconds = std::max(made->seconds, 0.5 * seconds); // one out of the cache says little about the next
    frame.trees.emplace(tree.node->id, *made);
    return made;
}

/// The frame with trees that a quick look has made, where the shapes of some are not known yet.
/// \param soFar the frame with all that tracks do not reshape
void MotionWorker::sketch(const MotionRequest& request, EvaluatedScene& now, const MotionFrame& soFar,
                          const Progress& progress)
{
    auto quick = std::make_shared<MotionFrame>(soFar);
    for (const MotionTree& tree : request.trees) {
        const Node& node = *tree.node;
        if (!movesShape(node.animation) || progress.cancelled())
            continue;
        const auto known = m_shapeSeconds.find(node.id);
        if (known != m_shapeSeconds.end() && known->second < sketchSeconds)
            continue;
        auto draft = m_pipeline.evaluateDraft(now.params(node), {progress.stop, {}});
        if (!draft)
            continue; // the whole tree says why
        quick->trees.emplace(node.id, std::move(*draft));
    }
    if (isSketch(*quick) && !progress.cancelled())
        m_listener.frame(std::move(quick));
}

/// Its physics knows the tracks itself.
Expected<void> MotionWorker::moveTree(const MotionTree& tree, EvaluatedScene& now,
                                      const MotionRequest& request, MotionFrame& frame,
                                      const Progress& progress)
{
    const Node& node = *tree.node;
    const auto shape = shapeOf(tree, now, frame, progress);
    RAMURE_TRY(shape);
    const NodeParams& params = movesShape(node.animation) ? now.params(node) : node.params;
    TreeActor& actor = m_actors[node.id];
    const std::size_t memoryBytes = request.memoryBytes / request.trees.size();
    if (auto ready = actor.prepare(tree, *shape, params, request, memoryBytes); !ready) {
        m_actors.erase(node.id);
        return ready;
    }
    if (auto baked = actor.takeBake(tree, progress.part(0.0, 0.5));
        !baked && baked.error().code != ErrorCode::Cancelled)
        m_listener.bakeRefused(std::move(baked.error()));
    return move(node.id, actor.run(), request, frame, progress);
}

Expected<void> MotionWorker::moveArm(const Node& arm, const MotionRequest& request, MotionFrame& frame,
                                     const Progress& progress)
{
    ArmRun& run = m_arms[arm.id];
    run.set(arm.params, arm.animation);
    return move(arm.id, run, request, frame, progress);
}

/// Runs of nodes that are no longer asked for go.
template <class Run> static void keepAsked(std::map<NodeId, Run>& runs, const std::set<NodeId>& asked)
{
    std::erase_if(runs, [&asked](const auto& run) { return !asked.contains(run.first); });
}

void MotionWorker::run(const MotionRequest& request, const Progress& progress)
{
    auto halfMade = qScopeGuard([this] { // memory ran out
        m_actors.clear();
        m_arms.clear();
    });
    std::set<NodeId> asked;
    for (const MotionTree& tree : request.trees)
        asked.insert(tree.node->id);
    for (const Node* arm : request.arms)
        asked.insert(arm->id);
    keepAsked(m_actors, asked);
    keepAsked(m_arms, asked);
    keepAsked(m_shapeSeconds, asked);
    if (request.forgetHand) // even where the request is cancelled before it comes to a tree
        for (auto& [node, actor] : m_actors)
            actor.forgetHand();
    auto frame = std::make_shared<MotionFrame>();
    frame->frame = request.frame;
    frame->document = request.document;
    frame->timeSeconds = request.timeline.timeOf(request.frame);
    EvaluatedScene now(*request.scene, frame->timeSeconds);
    if (hasTracks(*request.scene))
        placeNodes(*frame, now);
    std::optional<Error> problem;
    const auto note = [&problem](Expected<void> done) {
        if (!done && done.error().code != ErrorCode::Cancelled)
            problem = std::move(done.error());
    };
    const auto count = static_cast<double>(request.trees.size());
    const auto moveTrees = [&](bool reshaped) {
        for (std::size_t i = 0; i < request.trees.size() && !progress.cancelled(); ++i)
            if (movesShape(request.trees[i].node->animation) == reshaped) {
                const Progress part = progress.part(double(i) / count, double(i + 1) / count);
                note(moveTree(request.trees[i], now, request, *frame, part));
            }
    };
    moveTrees(false);
    for (const Node* arm : request.arms)
        note(moveArm(*arm, request, *frame, progress));
    if (request.sketches)
        sketch(request, now, *frame, progress);
    moveTrees(true);
    if (!progress.cancelled())
        m_listener.frame(std::move(frame));
    if (problem)
        m_listener.failed(*problem);
    m_listener.bakes(bakeState());
    sendBand(request);
    halfMade.dismiss();
}

BakeState MotionWorker::bakeState() const
{
    BakeState worst = BakeState::None;
    for (const auto& [node, actor] : m_actors)
        worst = std::max(worst, actor.bakeState());
    return worst;
}

/// Adjacent frames of one state as one range.
void MotionWorker::sendBand(const MotionRequest& request)
{
    const Clock::time_point now = Clock::now();
    if (request.live && now - m_bandSent < bandRest)
        return;
    m_bandSent = now;
    const TimelineSettings& timeline = request.timeline;
    std::vector<FrameState> states(static_cast<std::size_t>(timeline.lastFrame - timeline.firstFrame + 1),
                                   FrameState::Cached);
    for (const auto& [node, actor] : m_actors)
        actor.addBand(timeline, states);
    std::vector<FrameRange> band;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const std::int64_t frame = timeline.firstFrame + std::int64_t(i);
        if (band.empty() || band.back().state != states[i])
            band.push_back({frame, frame, states[i]});
        band.back().last = frame;
    }
    m_listener.band(request.document, std::move(band));
}

} // namespace ramure
