#include "core/session/motion_worker.h"

#include "core/evaluate/evaluator.h"
#include "core/rig/physics/animated_physics.h"
#include "core/scene/object_mesh.h"
#include "core/session/tree_actor.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

namespace ramure {

using Clock = std::chrono::steady_clock;

/// The band is looked through at most so often while frames follow each other.
static constexpr std::chrono::milliseconds bandRest{200};

std::optional<Error> MotionWorker::runArms(const MotionRequest& request, MotionFrame& frame,
                                           const Progress& progress)
{
    std::erase_if(m_arms, [&](const auto& run) {
        return std::ranges::none_of(request.arms,
                                    [&](const MotionArm& arm) { return arm.node == run.first; });
    });
    std::optional<Error> problem;
    for (const MotionArm& arm : request.arms) {
        ArmRun& run = m_arms[arm.node];
        run.set(arm.params, arm.animation);
        auto motion = run.motionAt(frame.timeSeconds, request.timeline, progress);
        if (motion)
            frame.nodes.insert_or_assign(arm.node, std::move(*motion));
        else if (motion.error().code != ErrorCode::Cancelled)
            problem = std::move(motion.error());
    }
    return problem;
}

MotionWorker::MotionWorker(Listener listener)
    : m_listener(std::move(listener))
    , m_thread([this](const std::stop_token& quit) { loop(quit); })
{
}

MotionWorker::~MotionWorker()
{
    m_thread.request_stop();
    stop();
    m_thread.join();
}

void MotionWorker::post(MotionRequest request, bool interrupt)
{
    const std::scoped_lock lock(m_mutex);
    if (m_waiting) { // an apple let go must not be forgotten with the frame that nobody saw
        request.forgetHand = request.forgetHand || m_waiting->forgetHand;
        for (const MotionTree& skipped : m_waiting->trees)
            for (MotionTree& tree : request.trees)
                if (tree.node == skipped.node)
                    tree.shaken.insert(tree.shaken.begin(), skipped.shaken.begin(), skipped.shaken.end());
    }
    m_waiting = std::move(request);
    if (interrupt && m_running)
        m_running->request_stop();
    m_wake.notify_one();
}

void MotionWorker::stop()
{
    const std::scoped_lock lock(m_mutex);
    m_waiting.reset();
    if (m_running)
        m_running->request_stop();
}

bool MotionWorker::isBusy() const
{
    const std::scoped_lock lock(m_mutex);
    return m_waiting || m_running;
}

void MotionWorker::loop(const std::stop_token& quit)
{
    for (;;) {
        MotionRequest request;
        std::stop_source stop;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, quit, [this] { return m_waiting.has_value(); });
            if (quit.stop_requested())
                return;
            request = std::move(*m_waiting);
            m_waiting.reset();
            m_running = stop;
        }
        try {
            run(request, {stop.get_token(), m_listener.progress});
        } catch (const std::bad_alloc&) {
            m_actors.clear();
            m_listener.failed(
                fail(ErrorCode::Limit, RAMURE_NOOP("there is not enough memory to move this tree")).value());
        }
        bool idle = false;
        {
            const std::scoped_lock lock(m_mutex);
            m_running.reset();
            idle = !m_waiting;
        }
        if (idle)
            m_listener.idle(request.ticket);
    }
}

/// Where the nodes are, and the objects whose parameters move.
static void placeNodes(MotionFrame& frame, const Scene& scene)
{
    EvaluatedScene evaluated(scene, frame.timeSeconds);
    const std::vector<NodeTransforms>& transforms = evaluated.transforms();
    frame.transforms.reserve(transforms.size());
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        const Node& node = scene.nodes()[i];
        frame.transforms.emplace(node.id, transforms[i]);
        if (node.kind == NodeKind::Tree || !node.animation.movesParams())
            continue;
        const NodeParams& now = evaluated.params(node);
        const bool sameShape = now.primitive == node.params.primitive && now.terrain == node.params.terrain;
        ObjectNow& object = frame.objects[node.id];
        object = {sameShape ? nullptr : objectMesh(node, now), now.surface, std::nullopt};
        if (node.kind == NodeKind::Arm)
            object.target = now.arm.target;
    }
}

/// The tree as its tracks shape it now.
Expected<void> MotionWorker::reshape(MotionTree& tree, MotionFrame& frame, const Progress& progress)
{
    if (!movesShape(tree.animation))
        return {};
    tree.params = paramsAt(tree.params, tree.animation, frame.timeSeconds);
    auto made = m_pipeline.evaluate(tree.params, Stage::Foliage, progress);
    if (!made)
        return fail(std::move(made.error()));
    tree.tree = *made;
    frame.trees.emplace(tree.node, std::move(*made));
    return {};
}

Expected<void> MotionWorker::moveTree(const MotionTree& tree, const MotionRequest& request,
                                      MotionFrame& frame, const Progress& progress)
{
    std::unique_ptr<TreeActor>& actor = m_actors[tree.node];
    if (!actor)
        actor = std::make_unique<TreeActor>();
    if (auto ready = actor->prepare(tree, request, request.memoryBytes / request.trees.size()); !ready) {
        m_actors.erase(tree.node);
        return ready;
    }
    if (auto baked = actor->takeBake(tree, progress.part(0.0, 0.5));
        !baked && baked.error().code != ErrorCode::Cancelled)
        m_listener.bakeRefused(std::move(baked.error()));
    auto motion = actor->run().motionAt(frame.timeSeconds, request.timeline, progress);
    if (!motion)
        return fail(std::move(motion.error()));
    frame.nodes.emplace(tree.node, std::move(*motion));
    return {};
}

void MotionWorker::run(const MotionRequest& request, const Progress& progress)
{
    std::erase_if(m_actors, [&](const auto& actor) {
        return std::none_of(request.trees.begin(), request.trees.end(),
                            [&](const MotionTree& tree) { return tree.node == actor.first; });
    });
    auto frame = std::make_shared<MotionFrame>();
    frame->frame = request.frame;
    frame->document = request.document;
    frame->timeSeconds = request.timeline.timeOf(request.frame);
    if (request.scene)
        placeNodes(*frame, *request.scene);
    const auto count = static_cast<double>(request.trees.size());
    std::optional<Error> problem;
    for (std::size_t i = 0; i < request.trees.size() && !progress.cancelled(); ++i) {
        MotionTree tree = request.trees[i];
        const double from = static_cast<double>(i) / count;
        const Progress part = progress.part(from, from + 1.0 / count);
        auto done = reshape(tree, *frame, part);
        if (done)
            done = moveTree(tree, request, *frame, part);
        if (!done && done.error().code != ErrorCode::Cancelled)
            problem = std::move(done.error());
    }
    if (auto failed = runArms(request, *frame, progress))
        problem = std::move(failed);
    if (!progress.cancelled())
        m_listener.frame(std::move(frame));
    if (problem)
        m_listener.failed(*problem);
    m_listener.bakes(bakeState());
    sendBand(request);
}

BakeState MotionWorker::bakeState() const
{
    BakeState worst = BakeState::None;
    for (const auto& [node, actor] : m_actors)
        worst = std::max(worst, actor->bakeState());
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
        actor->addBand(timeline, states);
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
