#include "core/evaluate/evaluator.h"

#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {

TreeSource pipelineSource(TreePipeline& pipeline)
{
    return [&pipeline](const Node& node, Stage last, const Progress& progress) {
        return pipeline.evaluate(node.params, last, progress);
    };
}

Error named(const Node& node, Error error)
{
    error.path = node.name + (error.path.empty() ? "" : ": " + error.path);
    return error;
}

EvaluatedScene::EvaluatedScene(const Scene& scene, double seconds)
    : m_scene(&scene)
    , m_seconds(seconds)
{
}

const std::vector<NodeTransforms>& EvaluatedScene::transforms()
{
    if (m_transforms.size() != m_scene->nodes().size())
        m_transforms = worldTransformsAt(*m_scene, m_seconds);
    return m_transforms;
}

NodeTransforms EvaluatedScene::transforms(NodeId node) const
{
    return worldTransformAt(*m_scene, node, m_seconds);
}

const NodeParams& EvaluatedScene::params(const Node& node)
{
    const auto known = m_params.find(node.id);
    if (known != m_params.end())
        return known->second;
    if (!node.animation.movesParams())
        return node.params;
    return m_params.emplace(node.id, paramsAt(node.params, node.animation, m_seconds)).first->second;
}

Expected<void> EvaluatedScene::pose(const Node& arm, const Progress& progress)
{
    if (!m_evaluator || arm.kind != NodeKind::Arm)
        return {};
    auto joints = m_evaluator->joints(arm, m_seconds, progress);
    if (!joints)
        return fail(named(arm, std::move(joints.error())));
    if (const NodeParams& now = params(arm); now.joints != *joints)
        m_params.insert_or_assign(arm.id, now).first->second.joints = std::move(*joints);
    return {};
}

Expected<void> EvaluatedScene::poseArms(const Progress& progress)
{
    for (const Node& node : m_scene->nodes())
        if (auto posed = pose(node, progress); !posed)
            return posed;
    return {};
}

Expected<std::shared_ptr<const TriangleMesh>> EvaluatedScene::solid(const Node& node,
                                                                    const Progress& progress)
{
    RAMURE_TRY(pose(node, progress));
    auto mesh = objectSolid(node, params(node));
    if (!mesh)
        return fail(named(node, std::move(mesh.error())));
    return mesh;
}

Expected<TreeResult> EvaluatedScene::tree(const Node& node, Stage last, const Progress& progress)
{
    return m_evaluator->tree(node, last, m_seconds, progress);
}

Expected<PosedTree> EvaluatedScene::posedTree(const Node& node, Stage last, bool bones,
                                              const Progress& progress)
{
    return m_evaluator->posedTree(node, last, m_seconds, bones, progress);
}

EvaluatedScene EvaluatedScene::at(double seconds) const
{
    return m_evaluator->at(*m_scene, seconds);
}

Evaluator::Evaluator(TreeSource rest, const TimelineSettings& timeline, std::size_t memoryBytes)
    : m_rest(std::move(rest))
    , m_timeline(timeline)
    , m_memoryBytes(memoryBytes)
{
}

std::size_t Evaluator::bytes() const
{
    std::size_t sum = 0;
    for (const auto& [id, run] : m_trees)
        sum += run.bytes();
    return sum;
}

EvaluatedScene Evaluator::at(const Scene& scene, double seconds)
{
    EvaluatedScene now(scene, seconds);
    now.m_evaluator = this;
    return now;
}

Expected<std::vector<ArmJoint>> Evaluator::joints(const Node& arm, double seconds, const Progress& progress)
{
    RAMURE_TRY(checkArm(arm.params.joints));
    const bool turns = seconds > 0.0 && arm.params.arm.follows;
    if (!turns && !arm.animation.movesParams() && !std::isnan(seconds))
        return arm.params.joints;
    ArmRun& run = m_arms[arm.id];
    run.set(arm.params, arm.animation);
    auto moment = run.momentAt(seconds, m_timeline, progress);
    RAMURE_TRY(moment);
    return std::move(moment->joints);
}

Expected<TreeResult> Evaluator::tree(const Node& node, Stage last, double seconds, const Progress& progress)
{
    const bool rests = seconds <= 0.0;
    auto posed = posedTree(node, last, seconds, false, rests ? progress : progress.part(0.0, 0.9));
    RAMURE_TRY(posed);
    if (rests)
        return std::move(posed->rest);
    return movedTree(std::move(posed->rest), posed->motion, progress.part(0.9, 1.0));
}

Expected<PosedTree> Evaluator::posedTree(const Node& node, Stage last, double seconds, bool bones,
                                         const Progress& progress)
{
    const PhysicsParams& physics = node.params.physics;
    if (!node.animation.movesParams())
        return posed(node, physics, last, seconds, bones, progress);
    Node now = node;
    now.params = paramsAt(node.params, node.animation, seconds);
    return posed(now, physics, last, seconds, bones, progress);
}

/// \p now has the parameters of the time; \p physics is without, since each step has its own.
Expected<PosedTree> Evaluator::posed(const Node& now, const PhysicsParams& physics, Stage last,
                                     double seconds, bool bones, const Progress& progress)
{
    if (seconds <= 0.0 && !bones)
        return m_rest(now, last, progress).map([](TreeResult&& rest) {
            return PosedTree{std::move(rest), {}};
        });
    // Apples weigh: they must be known even where nobody asked for them.
    auto tree = m_rest(now, std::max(last, Stage::Foliage), progress.part(0.0, 0.45));
    RAMURE_TRY(tree);
    TreeRun& run = m_trees[now.id];
    RAMURE_TRY(run.setTree(*tree, now.params));
    for (auto& [id, each] : m_trees) // one more tree leaves less to each of the others
        each.setMemoryLimit(m_memoryBytes / m_trees.size());
    if (!std::isfinite(seconds) || seconds > run.cache().timeAt(maxPhysicsSteps))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the time is too late for the physics"));
    run.setPhysics(physics, now.animation, seconds);
    auto motion = run.motionAt(seconds, m_timeline, progress.part(0.45, 1.0));
    RAMURE_TRY(motion);
    return PosedTree{std::move(*tree), std::move(*motion)};
}

} // namespace ramure
