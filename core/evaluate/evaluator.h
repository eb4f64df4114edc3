/// \file
/// The one answer to "what does the scene look like at a time": where its nodes stand, with which parameters
/// and in which shape. Player, viewport, files, pictures, checks and the command line all ask it.
#pragma once

#include "core/evaluate/arm_run.h"
#include "core/evaluate/tree_run.h"
#include "core/scene/world_transforms.h"
#include <functional>
#include <map>
#include <vector>

namespace ramure {

/// Gives the result of a tree node at rest, with all stages up to \p last.
using TreeSource =
    std::function<Expected<TreeResult>(const Node& node, Stage last, const Progress& progress)>;
/// Returns a source that runs the pipeline on request; \p pipeline must outlive the source.
TreeSource pipelineSource(TreePipeline& pipeline);

/// Puts the node's name in front of the error's subject.
Error named(const Node& node, Error error);

/// A tree as it rests, and the motion that it is in; without bones it rests.
struct PosedTree
{
    TreeResult rest;
    NodeMotion motion;
};

class Evaluator;

/// A scene at a time. Each part is made when it is asked for, so that transforms alone are cheap. Valid as
/// long as the scene and the evaluator.
class EvaluatedScene
{
public:
    /// Evaluates the tracks alone: arms stand as their joints say, and no tree is needed. A view begins with
    /// this, then the player moves it on.
    explicit EvaluatedScene(const Scene& scene, double seconds = 0.0);

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    [[nodiscard]] double seconds() const { return m_seconds; }
    /// One per node, in the order of Scene::nodes().
    const std::vector<NodeTransforms>& transforms();
    /// One node alone; an unknown id gives the identity.
    [[nodiscard]] NodeTransforms transforms(NodeId node) const;
    /// With the values of tracks, and the joints of an arm that was posed; valid as long as this object.
    const NodeParams& params(const Node& node);

    /// Turns an arm towards its target. Errors: those of Evaluator::joints, named.
    Expected<void> pose(const Node& arm, const Progress& progress = {});
    Expected<void> poseArms(const Progress& progress = {}); ///< all of them, hidden ones too
    /// Returns the shape of any node but a tree, arms posed, in the node's own space; null if it has none.
    /// Errors: those of pose() and objectSolid, named.
    Expected<std::shared_ptr<const TriangleMesh>> solid(const Node& node, const Progress& progress = {});
    /// Errors: those of Evaluator::tree. \pre an evaluator with a source made this; likewise of the next two.
    Expected<TreeResult> tree(const Node& node, Stage last, const Progress& progress = {});
    /// \param bones also where it rests.
    Expected<PosedTree> posedTree(const Node& node, Stage last, bool bones, const Progress& progress = {});
    /// The same scene at another time.
    [[nodiscard]] EvaluatedScene at(double seconds) const;

private:
    friend class Evaluator;
    const Scene* m_scene;
    double m_seconds;
    Evaluator* m_evaluator = nullptr;
    std::vector<NodeTransforms> m_transforms;
    std::map<NodeId, NodeParams> m_params; ///< for nodes whose tracks change their parameters
};

/// Keeps one run per tree and arm, so that the frames of a sequence cost one run together. Not thread-safe.
class Evaluator
{
public:
    /// \param rest gives the trees at rest.
    /// \param timeline says whether, and where, the end of a loop blends into its beginning.
    /// \param memoryBytes for the states that the runs of all trees keep together.
    explicit Evaluator(TreeSource rest = {}, const TimelineSettings& timeline = {},
                       std::size_t memoryBytes = std::size_t(512) << 20);
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    EvaluatedScene at(const Scene& scene, double seconds = 0.0);
    /// The joints of an arm at a time: those it has, as their tracks have them, turned towards its target
    /// where it follows one; at 0 s they stand as they are. Errors: Invalid (checkArm; a time that is no
    /// number or beyond a day), Cancelled.
    Expected<std::vector<ArmJoint>> joints(const Node& arm, double seconds, const Progress& progress = {});
    /// A tree at a time (the step round(T / stepSeconds), SPEC A7): see movedTree. Times up to 0 give it at
    /// rest. Errors: those of the rest; Invalid for a time that is no number or beyond maxPhysicsSteps;
    /// Cancelled.
    Expected<TreeResult> tree(const Node& node, Stage last, double seconds, const Progress& progress = {});
    /// The same, not deformed yet. \param bones also where it rests.
    Expected<PosedTree> posedTree(const Node& node, Stage last, double seconds, bool bones,
                                  const Progress& progress = {});
    [[nodiscard]] std::size_t bytes() const; ///< memory of the kept states

private:
    Expected<PosedTree> posed(const Node& now, const PhysicsParams& physics, Stage last, double seconds,
                              bool bones, const Progress& progress);

    TreeSource m_rest;
    TimelineSettings m_timeline;
    std::size_t m_memoryBytes;
    std::map<NodeId, TreeRun> m_trees;
    std::map<NodeId, ArmRun> m_arms;
};

} // namespace ramure
