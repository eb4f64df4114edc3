#include "core/session/tree_actor.h"

#include "core/rig/physics/physics_bake.h"
#include "core/rig/physics/pose_blend.h"
#include "core/rig/physics/tree_body.h"
#include "core/scene/loop_blend.h"
#include "core/rig/physics/animated_physics.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace ramure {

using Clock = std::chrono::steady_clock;

/// How far leaves reach from their branch, in radii of an apple: the grammar's length is two of them, a leaf
/// hangs up to one length past a tip and is one length wide.
static constexpr double leafReach = 4.0;
Expected<void> TreeActor::setTree(const MotionTree& wanted)
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

Expected<void> TreeActor::setSkins(const MotionTree& wanted)
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
void TreeActor::setParams(const PhysicsParams& params, bool live)
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
void TreeActor::setTrackedParams(const MotionTree& wanted, const MotionRequest& request)
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

Expected<void> TreeActor::prepare(const MotionTree& wanted, const MotionRequest& request,
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
bool TreeActor::isBakeOfUse() const
{
    return m_bake && !m_mixed && m_bake->params == m_params && m_bake->bodyKey == cache->physics().body().key;
}

/// The hand, or other parameters, may have put their own states in the place of some.
bool TreeActor::isBakeHere() const
{
    return m_bakedStep >= 0 &&
           cache->ranges(0, m_bakedStep) == std::vector<StepRange>{{0, m_bakedStep, StepState::Cached}};
}

BakeState TreeActor::bakeState() const
{
    if (m_bakeFile.empty())
        return BakeState::None;
    return isBakeOfUse() ? BakeState::Good : BakeState::Stale;
}

/// A file is read when it is new, and again when what made its states stale is taken back.
Expected<void> TreeActor::takeBake(const MotionTree& wanted, const Progress& progress)
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

Expected<NodeMotion> TreeActor::motionAt(std::int64_t step, const LoopBlend& blend, const Progress& progress)
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
void TreeActor::addBand(const TimelineSettings& timeline, std::vector<FrameState>& states) const
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

} // namespace ramure
