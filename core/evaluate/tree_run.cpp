#include "core/evaluate/tree_run.h"

#include "core/params/source_facts.h"
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
    const double alpha = trunkRadius(params);
    m_foliage = rest.foliage;
    const auto& weighed = rest.placed ? rest.placed : rest.foliage;
    if (m_cache && m_skeleton == rest.simplified && m_weighed == weighed && m_alpha == alpha)
        return false;
    m_skeleton = rest.simplified;
    m_weighed = weighed;
    m_alpha = alpha;
    const auto body = makeTreeBody(m_skeleton->skeleton, m_weighed.get(), alpha);
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

/// The places of some leaves among all that were placed, which stand in the same order. Leaves of the day
/// that are not among them have none.
static std::vector<Index> placesOf(const std::vector<FoliageItem>& leaves,
                                   const std::vector<FoliageItem>& all)
{
    std::vector<Index> places;
    places.reserve(leaves.size());
    for (std::size_t i = 0; i < all.size() && places.size() < leaves.size(); ++i) {
        const FoliageItem& next = leaves[places.size()];
        if (next.branch == all[i].branch && next.number == all[i].number)
            places.push_back(static_cast<Index>(i));
    }
    return places;
}

/// A leaf of a plant has a bone of its own; others go with their branches. All days of a year have the same
/// places on the bark.
Expected<void> TreeRun::setLeaves(const TreeResult& tree, bool smooth)
{
    m_motion.firstLeaf = noIndex;
    m_fruit = tree.foliage ? FruitSwing(*tree.foliage, m_alpha) : FruitSwing();
    if (!tree.foliage || tree.foliage->form.shape == LeafShape::Faithful)
        m_swing.reset();
    if (!tree.foliage)
        return {};
    const Skeleton& skeleton = tree.simplified->skeleton;
    const std::vector<FoliageItem>& leaves = tree.foliage->leaves;
    Expected<Skin> skin;
    if (tree.foliage->form.shape != LeafShape::Faithful) {
        if (!m_swing || m_swingOf != m_weighed) {
            auto anchors = bindAnchors(m_weighed->leaves, *tree.branches, skeleton, *m_motion.branches);
            RAMURE_TRY(anchors);
            m_swing.emplace(skeleton, *m_weighed, m_alpha, std::move(*anchors));
            m_swingOf = m_weighed;
        }
        m_hanging = placesOf(leaves, m_weighed->leaves);
        m_motion.firstLeaf = skeleton.size() + static_cast<Index>(tree.foliage->apples.size());
        if (tree.leaves)
            skin = bindLoose(tree.leaves.vertexCount(), leaves.size(), m_motion.firstLeaf);
    } else if (tree.leaves) {
        skin = bindFoliage(*tree.leaves, leaves, *tree.branches, skeleton, smooth);
    }
    RAMURE_TRY(skin);
    if (tree.leaves)
        m_motion.leaves = std::make_shared<const Skin>(std::move(*skin));
    return {};
}

Expected<void> TreeRun::setSkins(const TreeResult& tree, SkinMethod method)
{
    const bool smooth = method != SkinMethod::Rigid;
    const bool sameBark = m_motion.branches && m_smooth == smooth && m_motion.mesh == tree.branches;
    m_motion.method = method;
    if (sameBark && m_leavesOf == tree.foliage && m_motion.leavesMesh == tree.leaves &&
        m_motion.applesMesh == tree.apples)
        return {};
    const Skeleton& skeleton = tree.simplified->skeleton;
    if (!sameBark) {
        auto branches = bindBranches(*tree.branches, skeleton, smooth);
        RAMURE_TRY(branches);
        m_motion.branches = std::make_shared<const Skin>(std::move(*branches));
        m_motion.mesh = tree.branches;
        m_smooth = smooth;
        m_swing.reset();
    }
    m_motion.leaves = m_motion.apples = nullptr;
    if (auto leaves = setLeaves(tree, smooth); !leaves)
        return leaves;
    if (tree.foliage && tree.apples) {
        auto apples = bindLoose(tree.apples.vertexCount(), tree.foliage->apples.size(), skeleton.size());
        RAMURE_TRY(apples);
        m_motion.apples = std::make_shared<const Skin>(std::move(*apples));
    }
    m_leavesOf = tree.foliage;
    m_motion.leavesMesh = tree.leaves;
    m_motion.applesMesh = tree.apples;
    return {};
}

Expected<bool> TreeRun::setTree(const TreeResult& rest, const NodeParams& params)
{
    const bool isOther = setBody(rest, params);
    m_leaf = params.leaf;
    RAMURE_TRY(setSkins(rest, params.skin.method));
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
static Box movedBox(const TreeBody& body, const Foliage* foliage, const std::vector<RigidTransform>& bones)
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
    for (std::size_t apple = 0; foliage && apple < foliage->apples.size(); ++apple)
        box.add(bones[branches + apple].point(foliage->apples[apple].position));
    return box.grown(thickest + leafReach * body.appleRadius);
}

Expected<void> TreeRun::seek(std::int64_t step, Stand& stand, const Progress& progress)
{
    auto there = m_cache->seek(step, progress);
    if (there) {
        const TreeBody& body = m_cache->physics().body();
        m_cache->pose(stand.pose);
        stand.fruit = m_fruit.carried(body, m_cache->state());
        if (m_swing)
            m_swing->swing(body, m_cache->state(), m_cache->params(), m_leaf, stand.bends);
    }
    return there;
}

Index TreeRun::fruitOfPhysics(Index apple) const
{
    if (!m_foliage || m_foliage->fruitOf.empty())
        return apple;
    return apple < m_foliage->fruitOf.size() ? m_foliage->fruitOf[apple] : noIndex;
}

std::vector<RigidTransform> TreeRun::bones()
{
    const PhysicsState& state = m_cache->state();
    const Pose& pose = m_now.pose;
    const std::size_t branches = pose.bones.size(), apples = m_foliage ? m_foliage->apples.size() : 0;
    std::vector<RigidTransform> bones(branches + apples + (m_swing ? m_hanging.size() : 0));
    std::ranges::copy(pose.bones, bones.begin());
    for (std::size_t apple = 0; apple < apples; ++apple)
        bones[branches + apple] = pose.bones[m_foliage->apples[apple].branch];
    if (m_cache->step() != 0) // the beginning is the rest, to the last bit
        m_fruit.pose(m_now.fruit, std::span(bones).subspan(branches, apples));
    const std::vector<RigidTransform> loose = m_cache->physics().loosePoses(state);
    for (Index apple = 0; apple < apples && !loose.empty(); ++apple) {
        const auto off = std::ranges::find(state.loose, fruitOfPhysics(apple), &LooseApple::apple);
        if (off != state.loose.end())
            bones[branches + apple] = loose[std::size_t(off - state.loose.begin())];
    }
    if (!m_swing || m_cache->step() == 0)
        return bones;
    m_leafBones.resize(m_swing->size());
    m_swing->pose(pose.bones, m_motion.method, m_now.bends, m_leafBones);
    for (std::size_t i = 0; i < m_hanging.size(); ++i)
        bones[branches + apples + i] = m_leafBones[m_hanging[i]];
    return bones;
}

Expected<NodeMotion> TreeRun::motionAt(double seconds, const TimelineSettings& timeline,
                                       const Progress& progress)
{
    using Clock = std::chrono::steady_clock;
    const LoopBlend blend = loopBlend(timeline, seconds);
    if (blend.weight > 0.0) // the run goes back for the pose of the round before
        RAMURE_TRY(seek(m_cache->stepAt(blend.earlierSeconds), m_earlier, progress.part(0.0, 0.5)));
    const std::int64_t step = m_cache->stepAt(seconds), from = m_cache->step();
    const Clock::time_point start = Clock::now();
    RAMURE_TRY(seek(step, m_now, progress.part(blend.weight > 0.0 ? 0.5 : 0.0, 1.0)));
    NodeMotion motion = m_motion;
    if (step > from)
        motion.stepSeconds =
            std::chrono::duration<double>(Clock::now() - start).count() / double(step - from);
    if (blend.weight > 0.0) {
        blendPose(m_cache->physics().body(), m_earlier.pose, blend.weight, m_now.pose);
        m_now.bends.blend(m_earlier.bends, static_cast<float>(blend.weight));
        for (std::size_t i = 0; i < m_now.fruit.size(); ++i)
            m_now.fruit[i] = glm::mix(m_now.fruit[i], m_earlier.fruit[i], blend.weight);
    }
    const TreeBody& body = m_cache->physics().body();
    motion.bones = std::make_shared<const std::vector<RigidTransform>>(bones());
    motion.box = movedBox(body, m_foliage.get(), *motion.bones).grown(m_fruit.reach());
    if (m_swing)
        motion.box = motion.box.grown(m_swing->reach());
    motion.figures = m_cache->physics().figures(m_cache->state());
    motion.step = step;
    return motion;
}

} // namespace ramure
