/// \file
/// The background thread of the player: keeps one run of physics per tree, binds skins, makes frames. Knows
/// no document.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/session/tree_actor.h"
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace ramure {

class MotionWorker
{
public:
    /// All are called on the worker's thread.
    struct Listener
    {
        std::function<void(std::shared_ptr<const MotionFrame>)> frame;
        /// Of the timeline's range of a request's document; seldom.
        std::function<void(int document, std::vector<FrameRange>)> band;
        std::function<void(double)> progress;   ///< of a frame that takes long, 0..1
        std::function<void(Error)> failed;      ///< no frame comes for this request
        std::function<void(Error)> bakeRefused; ///< a file of baked motion is not used, and why
        std::function<void(BakeState)> bakes;
        /// Nothing runs or waits. By the request that ran last and not by isBusy(), the receiver knows that
        /// what came before is all there is: a later request may be through already, its frame on the way.
        std::function<void(std::int64_t ticket)> idle;
    };

    explicit MotionWorker(Listener listener);
    ~MotionWorker(); ///< stops what runs and joins
    MotionWorker(const MotionWorker&) = delete;
    MotionWorker& operator=(const MotionWorker&) = delete;

    /// Replaces the request that waits. \p interrupt stops the one that runs; what it computed is kept.
    void post(MotionRequest request, bool interrupt);
    /// Takes back what waits and stops what runs.
    void stop();
    [[nodiscard]] bool isBusy() const;

private:
    void loop(const std::stop_token& quit);
    Expected<void> reshape(MotionTree& tree, EvaluatedScene& now, MotionFrame& frame,
                           const Progress& progress);
    Expected<void> moveTree(const MotionTree& tree, const MotionRequest& request, MotionFrame& frame,
                            const Progress& progress);
    Expected<void> moveArm(const MotionArm& arm, const MotionRequest& request, MotionFrame& frame,
                           const Progress& progress);
    void run(const MotionRequest& request, const Progress& progress);
    [[nodiscard]] BakeState bakeState() const;
    void sendBand(const MotionRequest& request);

    Listener m_listener;
    mutable std::mutex m_mutex; ///< guards the next three
    std::condition_variable_any m_wake;
    std::optional<MotionRequest> m_waiting;
    std::optional<std::stop_source> m_running;
    TreePipeline m_pipeline;              ///< of trees whose shape has tracks; only the thread looks
    std::map<NodeId, TreeActor> m_actors; ///< only the thread looks
    std::map<NodeId, ArmRun> m_arms;      ///< likewise
    std::chrono::steady_clock::time_point m_bandSent; ///< only the thread looks
    std::jthread m_thread;                            ///< last: it needs all of the above
};

} // namespace ramure
