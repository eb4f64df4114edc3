#include "core/evaluate/tree_run.h"

#include "core/rig/physics/animated_physics.h"
#include "core/rig/physics/pose_blend.h"
#include "core/rig/physics/tree_body.h"
#include "core/scene/loop_blend.h"
#include <algorithm>
#include <chrono>
#include <utility>

namespace ramure {

/// How far leaves reach from their branch, in radii of an apple: the grammar's length is two of them, a leaf
/// hangs up to one length past a tip and is one length wide.
static constexpr double leafReach = 4.0;

bool TreeRun::setBody(const TreeResult& rest, const NodeParams& params)
{
    const double alpha = params.turtle.alpha;
    if (m_cache && m_skeleton == rest.simplified && m_foliage == rest.foliage && m_alpha == alpha)
        return false;
    m_skeleton = rest.simplified;
    m_foliage = rest.foliage;
    m_alpha = alpha;
    const auto body = makeTreeBody(m_skeleton->skeleton, m_foliage.get(), alpha);
    if (m_cache && m_cache->physics().body().key == body->key)
        return false; // computed again, the same as before
    m_params = params.physics;
    if (m_cache)
        m_cache->setBody(body);
    else
        m_cache = std::make_unique<PhysicsCache>(body, m_params);
    m_cache->setScript(PhysicsScript(m_params));
    m_scripted = -1;
    m_mixed = false;
    return true;
}

Expected<void> TreeRun::setSkins(const TreeResult& tree, SkinMethod method)
{
    const bool smooth = method != SkinMethod::Rigid;
    const bool same = m_motion.branches && m_smooth == smooth && m_motion.mesh == tree.branches &&
                      m_motion.leavesMesh == tree.leaves && m_motion.applesMesh == tree.apples;
    m_motion.method = method;
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

Expected<bool> TreeRun::setTree(const TreeResult& rest, const NodeParams& params)
{
    const bool isOther = setBody(rest, params);
    if (auto set = setSkins(rest, params.skin.method); !set)
        return fail(std::move(set.error()));
    return isOther;
}

/// Each step has its own. Other tracks, or other values of what has none, make another run.
void TreeRun::setTrackedPhysics(const PhysicsParams& params, const NodeAnimation& animation, double seconds)
{
    if (m_scripted < 0 || params != m_params || !(m_animation == animation)) {
        m_cache->setScript(PhysicsScript(physicsAtStep(params, animation, 0)));
        m_params = params;
        m_animation = animation;
        m_scripted = 0;
    }
    const std::int64_t step = m_cache->stepAt(seconds);
    scriptSteps(*m_cache, params, m_animation, m_scripted + 1, step);
    m_scripted = std::max(m_scripted, step);
    m_mixed = true;
}

bool TreeRun::setPhysics(const PhysicsParams& params, const NodeAnimation& animation, double seconds,
                         bool live)
{
    if (movesPhysics(animation)) {
        const bool isSame = m_scripted >= 0 && params == m_params && m_animation == animation;
        setTrackedPhysics(params, animation, seconds);
        return !isSame;
    }
    if (std::exchange(m_scripted, -1) >= 0)
        m_cache->setScript(PhysicsScript(params));
    const bool isSame = params == m_params && (live || !m_mixed);
    if (!isSame) {
        const std::int64_t from = live ? m_cache->step() : 0;
        m_cache->setParams(params, from);
        m_mixed = from > 0;
    }
    m_params = params;
    return !isSame;
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

Expected<NodeMotion> TreeRun::motionAt(double seconds, const TimelineSettings& timeline,
                                       const Progress& progress)
{
    using Clock = std::chrono::steady_clock;
    const LoopBlend blend = loopBlend(timeline, seconds);
    if (blend.weight > 0.0) { // the run goes back for the pose of the round before
        if (auto there = m_cache->seek(m_cache->stepAt(blend.earlierSeconds), progress.part(0.0, 0.5));
            !there)
            return fail(std::move(there.error()));
        m_cache->pose(m_earlier);
    }
    const std::int64_t step = m_cache->stepAt(seconds), from = m_cache->step();
    const Clock::time_point start = Clock::now();
    if (auto there = m_cache->seek(step, progress.part(blend.weight > 0.0 ? 0.5 : 0.0, 1.0)); !there)
        return fail(std::move(there.error()));
    NodeMotion motion = m_motion;
    if (step > from)
        motion.stepSeconds =
            std::chrono::duration<double>(Clock::now() - start).count() / double(step - from);
    m_cache->pose(m_pose);
    if (blend.weight > 0.0)
        blendPose(m_cache->physics().body(), m_earlier, blend.weight, m_pose);
    auto bones = std::make_shared<std::vector<RigidTransform>>(m_pose.bones);
    const TreeBody& body = m_cache->physics().body();
    for (const Index slot : body.appleSlot)
        bones->push_back(m_pose.bones[body.branchOf[slot]]);
    const PhysicsState& state = m_cache->state();
    const std::vector<RigidTransform> loose = m_cache->physics().loosePoses(state);
    for (std::size_t i = 0; i < loose.size(); ++i)
        (*bones)[m_pose.bones.size() + state.loose[i].apple] = loose[i];
    motion.box = movedBox(body, *bones);
    motion.bones = std::move(bones);
    motion.figures = m_cache->physics().figures(state);
    motion.step = step;
    return motion;
}

} // namespace ramure
