/// \file
/// The background thread of the recompute object: takes jobs, gives results, knows no document.
#pragma once

#include "core/scene/scene.h"
#include "core/session/evaluation.h"

#include <QtGlobal>
#include <array>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace ramure {

/// In the order in which they are served.
enum class JobKind : std::uint8_t { Draft, Full, Confirm };

struct TreeJob
{
    NodeId node = noNode;
    NodeParams params;
    quint64 revision = 0; ///< of the document when the parameters were taken
};

struct TreeOutcome
{
    JobKind kind = JobKind::Draft;
    NodeId node = noNode;
    quint64 revision = 0;
    Expected<TreeResult> result;
    bool isFull = false;  ///< of a draft: it is as good as the full result
    double seconds = 0.0; ///< that the evaluation took
};

/// Owns the thread. post, stop and the questions may be called from any one thread.
class RecomputeWorker
{
public:
    /// Both are called on the worker's thread.
    struct Listener
    {
        std::function<void(TreeOutcome)> outcome;
        std::function<void(double)> progress; ///< of a full job
        std::function<void()> ended;          ///< a draft or full job is over (after its outcomes)
    };

    RecomputeWorker(Evaluation evaluation, Listener listener);
    ~RecomputeWorker(); ///< stops what runs and joins
    RecomputeWorker(const RecomputeWorker&) = delete;
    RecomputeWorker& operator=(const RecomputeWorker&) = delete;

    /// Replaces the waiting job of the same kind; one that runs goes on. No trees: nothing waits any more.
    void post(JobKind kind, std::vector<TreeJob> trees, std::size_t treesInScene);
    /// Takes back what waits and stops what runs, of these kinds. Full jobs younger than \p grace are let
    /// finish. True where something that ran was told to stop.
    bool stop(std::initializer_list<JobKind> kinds, std::chrono::milliseconds grace = {});
    /// A draft or full job runs or waits, or the news of its end have not been acknowledged.
    [[nodiscard]] bool isBusy() const;
    /// To be called once per Listener::ended: its outcomes have been taken.
    void acknowledge();

private:
    struct Job
    {
        JobKind kind = JobKind::Draft;
        std::vector<TreeJob> trees;
        std::size_t treesInScene = 0;
        std::stop_source stop;
    };
    struct Unconfirmed
    {
        quint64 revision = 0;
        TreeResult tree;
    };
    struct Confirmed
    {
        std::weak_ptr<const BranchMesh> mesh;
        std::shared_ptr<const MeshReport> report;
    };

    void loop(const std::stop_token& quit);
    void run(const Job& job);
    void evaluate(JobKind kind, const TreeJob& tree, const Progress& progress);
    void lookAtReport(TreeResult& tree, const TreeOutcome& outcome);
    void confirmAll(const Progress& progress);
    [[nodiscard]] Progress progressOf(const Job& job) const;

    Evaluation m_evaluation;
    Listener m_listener;
    mutable std::mutex m_mutex; ///< guards the next six
    std::condition_variable_any m_wake;
    std::array<std::optional<Job>, 3> m_waiting; ///< by JobKind
    std::optional<JobKind> m_running;
    int m_ended = 0; ///< jobs whose end was not acknowledged yet
    std::stop_source m_runningStop;
    std::chrono::steady_clock::time_point m_runningStart;
    std::map<NodeId, Unconfirmed>
        m_toConfirm;                    ///< full results without a second opinion; only the thread looks
    std::vector<Confirmed> m_confirmed; ///< the latest second opinions; only the thread looks
    std::jthread m_thread;              ///< last: it needs all of the above
};

} // namespace ramure
