#include "core/session/motion_worker.h"

#include "core/rig/arm/arm_blend.h"
#include "core/rig/arm/arm_driver.h"
#include "core/rig/physics/physics_bake.h"
#include "core/rig/physics/physics_cache.h"
#include "core/rig/physics/pose_blend.h"
#include "core/rig/physics/tree_body.h"
#include "core/scene/loop_blend.h"
#include "core/scene/object_mesh.h"
#include "core/session/animated_physics.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

namespace ramure {

using Clock = std::chrono::steady_clock;

/// How far leaves reach from their branch, in radii of an apple: the grammar's length is two of them, a leaf
/// hangs up to one length past a tip and is one length wide.
static constexpr double leafReach = 4.0;
/// The band is looked through at most so often while frames follow each other.
static constexpr std::chrono::milliseconds bandRest{200};

/// One tree on the worker's thread: its run and its skins.
struct MotionWorker::Actor
{
    Expected<void> prepare(const MotionTree& wanted, const MotionRequest& request, std::size_t memoryBytes);
    /// The baked run in place of what is computed, where it is of use. Error: why it is not; it is told once.
    Expected<void> takeBake(const MotionTree& wanted, const Progress& progress);
    [[nodiscard]] BakeState bakeState() const;
    /// \param blend of the loop's end into its beginning.
    Expected<NodeMotion> motionAt(std::int64_t step, const LoopBlend& blend, const Progress& progress);
    void addBand(const TimelineSettings& timeline, std::vector<FrameState>& states) const;

    std::unique_ptr<PhysicsCache> cache;

private:
    Expected<void> setTree(const MotionTree& wanted);
    Expected<void> setSkins(const MotionTree& wanted);
    void setParams(const PhysicsParams& params, bool live);
    void setTrackedParams(const MotionTree& wanted, const MotionRequest& request);
    [[nodiscard]] bool isBakeOfUse() const;
    [[nodiscard]] bool isBakeHere() const;

    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    std::shared_ptr<const Foliage> m_foliage;
    double m_alpha = 0.0;
    PhysicsParams m_params;
    NodeAnimation m_animation;    ///< of the parameters, where the physics has tracks
    std::int64_t m_scripted = -1; ///< steps that have been told theirs
    bool m_mixed = false;         ///< parameters changed within the run
    std::string m_bakeFile;
    int m_bakeVersion = 0;
    std::optional<BakeLabel> m_bake; ///< of a file that may become of use
    std::int64_t m_bakedStep = -1;   ///< the last one of the file, where it was loaded
    bool m_lookAtBake = false;       ///< tree, parameters or hand are others than when the file was looked at
    NodeMotion m_motion;             ///< meshes and skins; the rest is of the frame made last
    bool m_smooth = false;
    Pose m_pose, m_earlier;
};

Expected<void> MotionWorker::Actor::setTree(const MotionTree& wanted)
{
    const double alpha = wanted.params.turtle.alpha;
    if (cache && m_skeleton == wanted.tree.simplified && m_foliage == wanted.tree.foliage && m_alpha == alpha)
        return {};
    m_skeleton = wanted.tree.simplified;
    m_foliage = wanted.tree.foliage;
    m_alpha = alpha;
    const auto body = makeTreeBody(m_skeleton->skeleton, m_foliage.get(), alpha);
    if (cache && cache->physics().body().key == body->key)
        return {}; // computed again, the same as before
    m_params = wanted.params.physics;
    if (cache)
        cache->setBody(body);
    else
        cache = std::make_unique<PhysicsCache>(body, m_params);
    cache->setScript(PhysicsScript(m_params));
    m_scripted = -1;
    m_mixed = false;
    m_lookAtBake = true;
    return {};
}

Expected<void> MotionWorker::Actor::setSkins(const MotionTree& wanted)
{
    const TreeResult& tree = wanted.tree;
    const bool smooth = wanted.params.skin.method != SkinMethod::Rigid;
    const bool same = m_motion.branches && m_smooth == smooth && m_motion.mesh == tree.branches &&
                      m_motion.leavesMesh == tree.leaves && m_motion.applesMesh == tree.apples;
    m_motion.method = wanted.params.skin.method;
    if (same)
        return {};
    const Skeleton& skeleton = tree.simplified->skeleton;
    auto branches = bindBranches(*tree.branches, skeleton, smooth);
    if (!branches)
        return fail(std::move(branches.error()));
    m_motion.branches = std::make_shared<const Skin>(std::move(*branches));
    m_motion.leaves = m_motion.apples = nullptr;
    if (tree.foliage && tree.leaves) {
        auto leaves = bindFoliage(*tree.leaves, tree.foliage->leaves, *tree.branches, skeleton, smooth);
        if (!leaves)
            return fail(std::move(leaves.error()));
        m_motion.leaves = std::make_shared<const Skin>(std::move(*leaves));
    }
    if (tree.foliage && tree.apples) {
        auto apples = bindLoose(*tree.apples, tree.foliage->apples.size(), skeleton.size());
        if (!apples)
            return fail(std::move(apples.error()));
        m_motion.apples = std::make_shared<const Skin>(std::move(*apples));
    }
    m_motion.mesh = tree.branches;
    m_motion.leavesMesh = tree.leaves;
    m_motion.applesMesh = tree.apples;
    m_smooth = smooth;
    return {};
}

/// Live, new values act from now on and what lies behind stays as it was; at rest the whole run is theirs.
void MotionWorker::Actor::setParams(const PhysicsParams& params, bool live)
{
    m_lookAtBake = m_lookAtBake || params != m_params || (m_mixed && !live);
    if (live && params != m_params) {
        cache->setParams(params, cache->step());
        m_mixed = cache->step() > 0;
    } else if (!live && (m_mixed || params != m_params)) {
        cache->setParams(params, 0);
        m_mixed = false;
    }
    m_params = params;
}

/// Each step has its own. Other tracks, or other values of what has none, make another run.
void MotionWorker::Actor::setTrackedParams(const MotionTree& wanted, const MotionRequest& request)
{
    const PhysicsParams& params = wanted.params.physics;
    if (m_scripted < 0 || params != m_params || !(m_animation == wanted.animation)) {
        cache->setScript(PhysicsScript(physicsAtStep(params, wanted.animation, 0)));
        m_params = params;
        m_animation = wanted.animation;
        m_scripted = 0;
        m_lookAtBake = true;
    }
    const double time = request.timeline.timeOf(request.frame);
    const std::int64_t step = time <= 0.0 ? 0 : std::min(cache->stepAt(time), maxPhysicsSteps);
    scriptSteps(*cache, params, m_animation, m_scripted + 1, step);
    m_scripted = std::max(m_scripted, step);
    m_mixed = true; // no bake is of this run
}

Expected<void> MotionWorker::Actor::prepare(const MotionTree& wanted, const MotionRequest& request,
                                            std::size_t memoryBytes)
{
    if (auto set = setTree(wanted); !set)
        return set;
    if (auto set = setSkins(wanted); !set)
        return set;
    cache->setMemoryLimit(memoryBytes);
    if (request.forgetHand) {
        PhysicsScript calm = cache->script();
        calm.clear();
        cache->setScript(calm);
        m_lookAtBake = true;
    }
    if (movesPhysics(wanted.animation)) {
        setTrackedParams(wanted, request);
    } else {
        if (std::exchange(m_scripted, -1) >= 0)
            cache->setScript(PhysicsScript(wanted.params.physics));
        setParams(wanted.params.physics, request.live);
    }
    if (!request.live)
        return {};
    cache->setPull(wanted.pull, cache->step());
    for (const Index apple : wanted.shaken)
        cache->shakeOff(apple, cache->step());
    return {};
}

/// The run is, from its beginning on, the one that the file says it holds.
bool MotionWorker::Actor::isBakeOfUse() const
{
    return m_bake && !m_mixed && m_bake->params == m_params && m_bake->bodyKey == cache->physics().body().key;
}

/// The hand, or other parameters, may have put their own states in the place of some.
bool MotionWorker::Actor::isBakeHere() const
{
    return m_bakedStep >= 0 &&
           cache->ranges(0, m_bakedStep) == std::vector<StepRange>{{0, m_bakedStep, StepState::Cached}};
}

BakeState MotionWorker::Actor::bakeState() const
{
    if (m_bakeFile.empty())
        return BakeState::None;
    return isBakeOfUse() ? BakeState::Good : BakeState::Stale;
}

/// A file is read when it is new, and again when what made its states stale is taken back.
Expected<void> MotionWorker::Actor::takeBake(const MotionTree& wanted, const Progress& progress)
{
    const bool isNew = m_bakeFile != wanted.bakeFile || m_bakeVersion != wanted.bakeVersion;
    if (isNew && wanted.bakeFile.empty() && m_bakedStep >= 0)
        cache->clearStates(); // freed
    const bool look = isNew || (std::exchange(m_lookAtBake, false) && isBakeOfUse() &&
                                cache->script() == PhysicsScript(m_params) && !isBakeHere());
    if (isNew) {
        m_bakeFile = wanted.bakeFile;
        m_bakeVersion = wanted.bakeVersion;
        m_bakedStep = -1;
        m_bake.reset();
    }
    if (!look || m_bakeFile.empty())
        return {};
    const auto loaded = loadBake(*cache, m_params, m_bakeFile, progress);
    const auto label = readBakeLabel(m_bakeFile);
    m_bake = label ? std::optional(*label) : std::nullopt;
    if (loaded) {
        const auto states = cache->validStates();
        m_bakedStep = states.empty() ? 0 : states.back()->step;
        return {};
    }
    if (loaded.error().code == ErrorCode::Cancelled)
        m_lookAtBake = true;
    else if (isBakeOfUse())
        m_bake.reset(); // it says that it is this run, and yet it is not sound
    return loaded;
}

/// Around all branches and apples, with room for leaves.
static Box movedBox(const TreeBody& body, const std::vector<RigidTransform>& bones)
{
    Box box;
    double thickest = 0.0;
    for (std::size_t slot = 0; slot < body.p0.size(); ++slot) {
        const RigidTransform& bone = bones[body.branchOf[slot]];
        box.add(bone.point(body.p0[slot]));
        box.add(bone.point(body.p1[slot]));
        thickest = std::max(thickest, body.a0[slot]);
    }
    const std::size_t branches = body.p0.size();
    for (std::size_t apple = 0; apple < body.applePosition.size(); ++apple)
        box.add(bones[branches + apple].point(body.applePosition[apple]));
    return box.grown(thickest + leafReach * body.appleRadius);
}

Expected<NodeMotion> MotionWorker::Actor::motionAt(std::int64_t step, const LoopBlend& blend,
                                                   const Progress& progress)
{
    if (blend.weight > 0.0) {
        if (auto there = cache->seek(cache->stepAt(blend.earlierSeconds), progress); !there)
            return fail(std::move(there.error()));
        cache->pose(m_earlier);
    }
    const std::int64_t from = cache->step();
    const Clock::time_point start = Clock::now();
    if (auto there = cache->seek(step, progress); !there)
        return fail(std::move(there.error()));
    NodeMotion motion = m_motion;
    if (step > from)
        motion.stepSeconds =
            std::chrono::duration<double>(Clock::now() - start).count() / double(step - from);
    cache->pose(m_pose);
    if (blend.weight > 0.0)
        blendPose(cache->physics().body(), m_earlier, blend.weight, m_pose);
    auto bones = std::make_shared<std::vector<RigidTransform>>(m_pose.bones);
    const TreeBody& body = cache->physics().body();
    for (const Index slot : body.appleSlot)
        bones->push_back(m_pose.bones[body.branchOf[slot]]);
    const PhysicsState& state = cache->state();
    const std::vector<RigidTransform> loose = cache->physics().loosePoses(state);
    for (std::size_t i = 0; i < loose.size(); ++i)
        (*bones)[m_pose.bones.size() + state.loose[i].apple] = loose[i];
    motion.box = movedBox(body, *bones);
    motion.bones = std::move(bones);
    motion.figures = cache->physics().figures(state);
    motion.step = step;
    return motion;
}

/// A frame is as good as its worst tree. By ranges: a timeline may have a million frames.
void MotionWorker::Actor::addBand(const TimelineSettings& timeline, std::vector<FrameState>& states) const
{
    const auto stepOf = [&](std::size_t i) {
        return std::max<std::int64_t>(cache->stepAt(timeline.timeOf(timeline.firstFrame + std::int64_t(i))),
                                      0);
    };
    std::size_t i = 0;
    for (const StepRange& range : cache->ranges(0, stepOf(states.size() - 1)))
        for (; i < states.size() && stepOf(i) <= range.last; ++i)
            states[i] = std::min(states[i], static_cast<FrameState>(range.state));
}

/// One arm on the worker's thread: its driver, as long as nothing that it was made from changes.
struct MotionWorker::ArmActor
{
    explicit ArmActor(const MotionArm& from)
        : arm(from)
        , driver(armDriver(from.params, from.animation))
    {
    }
    [[nodiscard]] bool isFor(const MotionArm& other) const
    {
        return arm.params.joints == other.params.joints && arm.params.ik == other.params.ik &&
               arm.params.arm == other.params.arm && arm.animation == other.animation;
    }

    Expected<ArmMoment> momentAt(double seconds, const LoopBlend& blend, const Progress& progress)
    {
        if (blend.weight == 0.0)
            return driver.momentAt(seconds, progress);
        const auto earlier = driver.momentAt(blend.earlierSeconds, progress);
        if (!earlier)
            return earlier;
        auto moment = driver.momentAt(seconds, progress);
        if (!moment)
            return moment;
        blendJoints(earlier->joints, blend.weight, moment->joints);
        for (std::size_t i = 0; i < moment->joints.size(); ++i) {
            moment->angles[2 * i] = moment->joints[i].phi.angleRad;
            moment->angles[2 * i + 1] = moment->joints[i].theta.angleRad;
        }
        return moment;
    }

    MotionArm arm;
    ArmDriver driver;
};

static bool movesLengths(const NodeAnimation& animation)
{
    return std::any_of(animation.tracks().begin(), animation.tracks().end(), [](const auto& entry) {
        const JointDef* def = entry.first.jointDef();
        return def && !def->angle;
    });
}

std::optional<Error> MotionWorker::runArms(const MotionRequest& request, MotionFrame& frame,
                                           const Progress& progress)
{
    std::erase_if(m_arms, [&](const auto& actor) {
        return std::ranges::none_of(request.arms,
                                    [&](const MotionArm& arm) { return arm.node == actor.first; });
    });
    std::optional<Error> problem;
    for (const MotionArm& arm : request.arms) {
        std::unique_ptr<ArmActor>& actor = m_arms[arm.node];
        if (!actor || !actor->isFor(arm))
            actor = std::make_unique<ArmActor>(arm);
        const LoopBlend blend =
            arm.params.arm.follows ? loopBlend(request.timeline, frame.timeSeconds) : LoopBlend();
        const auto moment = actor->momentAt(frame.timeSeconds, blend, progress);
        if (!moment) {
            if (moment.error().code != ErrorCode::Cancelled)
                problem = moment.error();
            continue;
        }
        const bool changes = arm.animation.movesParams();
        NodeMotion motion = armMotion(arm.params, moment->joints);
        motion.step = changes || (frame.timeSeconds > 0.0 && arm.params.arm.follows) ? 1 : 0;
        motion.reshapes = movesLengths(arm.animation);
        auto told = std::make_shared<ArmProgress>();
        told->node = arm.node;
        told->angles = moment->angles;
        told->limits = armLimits(moment->joints, moment->angles);
        told->figures = moment->figures;
        told->residual = moment->residual;
        told->residuals = moment->residuals;
        // What the solver has reached the arm may still be on its way to.
        told->moves =
            moment->figures.status == ArmStatus::Reached && moment->residual > arm.params.ik.tolerance;
        motion.arm = std::move(told);
        frame.nodes.insert_or_assign(arm.node, std::move(motion));
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
    const std::vector<NodeTransforms> transforms = worldTransformsAt(scene, frame.timeSeconds);
    frame.transforms.reserve(transforms.size());
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        const Node& node = scene.nodes()[i];
        frame.transforms.emplace(node.id, transforms[i]);
        if (node.kind == NodeKind::Tree || !node.animation.movesParams())
            continue;
        const NodeParams now = paramsAt(node.params, node.animation, frame.timeSeconds);
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
    std::unique_ptr<Actor>& actor = m_actors[tree.node];
    if (!actor)
        actor = std::make_unique<Actor>();
    if (auto ready = actor->prepare(tree, request, request.memoryBytes / request.trees.size()); !ready) {
        m_actors.erase(tree.node);
        return ready;
    }
    const std::int64_t step =
        frame.timeSeconds <= 0.0 ? 0 : std::min(actor->cache->stepAt(frame.timeSeconds), maxPhysicsSteps);
    if (auto baked = actor->takeBake(tree, progress.part(0.0, 0.5));
        !baked && baked.error().code != ErrorCode::Cancelled)
        m_listener.bakeRefused(std::move(baked.error()));
    auto motion = actor->motionAt(step, loopBlend(request.timeline, frame.timeSeconds), progress);
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
