/// \file
/// What works on the player's thread: keeps one run of physics per tree, binds skins, makes frames. Knows no
/// document.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/qt/session/motion/tree_actor.h"
#include <chrono>
#include <functional>
#include <optional>

namespace ramure {

/// What the hand did in a request that was never begun is done in the next one: an apple let go must not be
/// forgotten with the frame that nobody saw.
void takeOverHand(MotionRequest& next, const MotionRequest& skipped);

class MotionWorker
{
public:
    /// All are called on the worker's thread.
    struct Listener
    {
        std::function<void(std::shared_ptr<const MotionFrame>)> frame;
        /// Of the timeline's range of a request's document; seldom.
        std::function<void(int document, std::vector<FrameRange>)> band;
        std::function<void(Error)> failed;      ///< no frame comes for this request
        std::function<void(Error)> bakeRefused; ///< a file of baked motion is not used, and why
        std::function<void(BakeState)> bakes;
    };

    explicit MotionWorker(Listener listener);

    void run(const MotionRequest& request, const Progress& progress);

private:
    Expected<TreeResult> shapeOf(const MotionTree& tree, EvaluatedScene& now, MotionFrame& frame,
                                 const Progress& progress);
    Expected<void> moveTree(const MotionTree& tree, EvaluatedScene& now, const MotionRequest& request,
                            MotionFrame& frame, const Progress& progress);
    void sketch(const MotionRequest& request, EvaluatedScene& now, const MotionFrame& soFar,
                const Progress& progress);
    Expected<void> moveArm(const Node& arm, const MotionRequest& request, MotionFrame& frame,
                           const Progress& progress);
    [[nodiscard]] BakeState bakeState() const;
    void sendBand(const MotionRequest& request);

    Listener m_listener;
    TreePipeline m_pipeline;                 ///< of trees whose shape has tracks
    std::map<NodeId, double> m_shapeSeconds; ///< of those: what one takes
    std::map<NodeId, TreeActor> m_actors;
    std::map<NodeId, ArmRun> m_arms;
    std::chrono::steady_clock::time_point m_bandSent;
};

} // namespace ramure
