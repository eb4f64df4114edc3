/// \file
/// The background thread of the player: keeps one run of physics per tree, binds skins, makes frames. Knows
/// no document.
#pragma once

#include "core/evaluate/arm_run.h"
#include "core/params/node_params.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/session/motion.h"
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace ramure {

/// What the thread needs to know of one tree.
struct MotionTree
{
    NodeId node = noNode;
    TreeResult tree;
    NodeParams params;
    NodeAnimation animation;
    std::optional<Pull> pull;
    std::vector<Index> shaken; ///< apples let go at the frame before this one
    std::string bakeFile;      ///< of this tree; empty: there is none
    int bakeVersion = 0;       ///< another number: the file is another
};

/// And of one arm.
struct MotionArm
{
    NodeId node = noNode;
    NodeParams params;
    NodeAnimation animation;
};

struct MotionRequest
{
    std::int64_t frame = 0;
    int document = 0;        ///< counted by the player: what comes late from one that was left is of no use
    std::int64_t ticket = 0; ///< likewise, growing: told again when the request is through
    TimelineSettings timeline;
    std::vector<MotionTree> trees;
    std::vector<MotionArm> arms;
    std::shared_ptr<const Scene> scene;             ///< null where nothing in it has a track
    std::size_t memoryBytes = std::size_t(1) << 30; ///< for the runs of all trees together
    /// Playing: changed parameters and the hand act from the present step on. Otherwise the whole run is that
    /// of the present parameters.
    bool live = false;
    bool forgetHand = false; ///< the hand's pulls and the shaken apples of the run are forgotten first
};

class TreeActor;

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
    Expected<void> reshape(MotionTree& tree, MotionFrame& frame, const Progress& progress);
    Expected<void> moveTree(const MotionTree& tree, const MotionRequest& request, MotionFrame& frame,
                            const Progress& progress);
    void run(const MotionRequest& request, const Progress& progress);
    [[nodiscard]] BakeState bakeState() const;
    std::optional<Error> runArms(const MotionRequest& request, MotionFrame& frame, const Progress& progress);
    void sendBand(const MotionRequest& request);

    Listener m_listener;
    mutable std::mutex m_mutex; ///< guards the next three
    std::condition_variable_any m_wake;
    std::optional<MotionRequest> m_waiting;
    std::optional<std::stop_source> m_running;
    TreePipeline m_pipeline; ///< of trees whose shape has tracks; only the thread looks
    std::map<NodeId, std::unique_ptr<TreeActor>> m_actors; ///< only the thread looks
    std::map<NodeId, ArmRun> m_arms;                       ///< likewise
    std::chrono::steady_clock::time_point m_bandSent;      ///< only the thread looks
    std::jthread m_thread;                                 ///< last: it needs all of the above
};

} // namespace ramure
