#include "core/qt/session/motion/motion_worker.h"

#include "core/rig/physics/animated_physics.h"
#include "core/scene/object_mesh.h"

#include <QScopeGuard>
#include <algorithm>
#include <chrono>
#include <utility>

namespace ramure {

using Clock = std::chrono::steady_clock;

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
            if (tree.node == from.node)
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

/// The tree as its tracks shape it now; its physics knows its tracks itself.
Expected<void> MotionWorker::reshape(MotionTree& tree, EvaluatedScene& now, MotionFrame& frame,
                                     const Progress& progress)
{
    const Node* node = movesShape(tree.animation) ? now.scene().find(tree.node) : nullptr;
    if (!node)
        return {};
    const PhysicsParams physics = tree.params.physics;
    tree.params = now.params(*node);
    auto made = m_pipeline.evaluate(tree.params, Stage::Foliage, progress);
    RAMURE_TRY(made);
    tree.params.physics = physics;
    tree.tree = *made;
    frame.trees.emplace(tree.node, std::move(*made));
    return {};
}

Expected<void> MotionWorker::moveTree(const MotionTree& tree, const MotionRequest& request,
                                      MotionFrame& frame, const Progress& progress)
{
    TreeActor& actor = m_actors[tree.node];
    if (auto ready = actor.prepare(tree, request, request.memoryBytes / request.trees.size()); !ready) {
        m_actors.erase(tree.node);
        return ready;
    }
    if (auto baked = actor.takeBake(tree, progress.part(0.0, 0.5));
        !baked && baked.error().code != ErrorCode::Cancelled)
        m_listener.bakeRefused(std::move(baked.error()));
    return move(tree.node, actor.run(), request, frame, progress);
}

Expected<void> MotionWorker::moveArm(const MotionArm& arm, const MotionRequest& request, MotionFrame& frame,
                                     const Progress& progress)
{
    ArmRun& run = m_arms[arm.node];
    run.set(arm.params, arm.animation);
    return move(arm.node, run, request, frame, progress);
}

/// Runs of nodes that are no longer asked for go.
template <class Run, class Asked>
static void keepAsked(std::map<NodeId, Run>& runs, const std::vector<Asked>& asked)
{
    std::erase_if(runs, [&asked](const auto& run) {
        return std::ranges::none_of(asked, [&run](const Asked& one) { return one.node == run.first; });
    });
}

void MotionWorker::run(const MotionRequest& request, const Progress& progress)
{
    auto halfMade = qScopeGuard([this] { // memory ran out
        m_actors.clear();
        m_arms.clear();
    });
    keepAsked(m_actors, request.trees);
    keepAsked(m_arms, request.arms);
    if (request.forgetHand) // even where the request is cancelled before it comes to a tree
        for (auto& [node, actor] : m_actors)
            actor.forgetHand();
    auto frame = std::make_shared<MotionFrame>();
    frame->frame = request.frame;
    frame->document = request.document;
    frame->timeSeconds = request.timeline.timeOf(request.frame);
    const Scene nothingMoves;
    EvaluatedScene now(request.scene ? *request.scene : nothingMoves, frame->timeSeconds);
    placeNodes(*frame, now);
    std::optional<Error> problem;
    const auto note = [&problem](Expected<void> done) {
        if (!done && done.error().code != ErrorCode::Cancelled)
            problem = std::move(done.error());
        return done.has_value();
    };
    const auto count = static_cast<double>(request.trees.size());
    for (std::size_t i = 0; i < request.trees.size() && !progress.cancelled(); ++i) {
        MotionTree tree = request.trees[i];
        const Progress part = progress.part(double(i) / count, double(i + 1) / count);
        if (note(reshape(tree, now, *frame, part)))
            note(moveTree(tree, request, *frame, part));
    }
    for (const MotionArm& arm : request.arms)
        note(moveArm(arm, request, *frame, progress));
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
