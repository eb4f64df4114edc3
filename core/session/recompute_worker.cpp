#include "core/session/recompute_worker.h"

#include <algorithm>
#include <new>

namespace ramure {

using Clock = std::chrono::steady_clock;

static constexpr std::size_t confirmedKept = 32;

RecomputeWorker::RecomputeWorker(Evaluation evaluation, Listener listener)
    : m_evaluation(std::move(evaluation))
    , m_listener(std::move(listener))
    , m_thread([this](const std::stop_token& quit) { loop(quit); })
{
}

RecomputeWorker::~RecomputeWorker()
{
    m_thread.request_stop(); // before the job: the thread must not take another one
    stop({JobKind::Draft, JobKind::Full, JobKind::Confirm});
    m_thread.join();
}

void RecomputeWorker::post(JobKind kind, std::vector<TreeJob> trees, std::size_t treesInScene)
{
    const std::scoped_lock lock(m_mutex);
    std::optional<Job>& slot = m_waiting[static_cast<std::size_t>(kind)];
    slot.reset();
    if (trees.empty())
        return;
    slot = Job{kind, std::move(trees), treesInScene, std::stop_source()};
    m_wake.notify_one();
}

bool RecomputeWorker::stop(std::initializer_list<JobKind> kinds, std::chrono::milliseconds grace)
{
    const std::scoped_lock lock(m_mutex);
    bool stopped = false;
    for (const JobKind kind : kinds) {
        m_waiting[static_cast<std::size_t>(kind)].reset();
        if (m_running != kind || (kind == JobKind::Full && Clock::now() - m_runningStart < grace))
            continue;
        stopped = m_runningStop.request_stop() || stopped;
    }
    return stopped;
}

bool RecomputeWorker::isBusy() const
{
    const std::scoped_lock lock(m_mutex);
    const auto waits = [this](JobKind kind) { return m_waiting[static_cast<std::size_t>(kind)].has_value(); };
    const bool runs = m_running && *m_running != JobKind::Confirm;
    return runs || m_ended > 0 || waits(JobKind::Draft) || waits(JobKind::Full);
}

void RecomputeWorker::acknowledge()
{
    const std::scoped_lock lock(m_mutex);
    --m_ended;
}

void RecomputeWorker::loop(const std::stop_token& quit)
{
    const auto waits = [](const std::optional<Job>& job) { return job.has_value(); };
    for (;;) {
        Job job;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, quit, [&] { return std::any_of(m_waiting.begin(), m_waiting.end(), waits); });
            if (quit.stop_requested())
                return;
            const auto next = std::find_if(m_waiting.begin(), m_waiting.end(), waits);
            job = std::move(**next);
            next->reset();
            m_running = job.kind;
            m_runningStop = job.stop;
            m_runningStart = Clock::now();
        }
        run(job);
        {
            const std::scoped_lock lock(m_mutex);
            m_running.reset();
            m_ended += job.kind == JobKind::Confirm ? 0 : 1;
            if (job.kind == JobKind::Full && !m_toConfirm.empty() && m_evaluation.confirm) {
                Job second;
                second.kind = JobKind::Confirm;
                m_waiting[static_cast<std::size_t>(JobKind::Confirm)] = std::move(second);
            }
        }
        if (job.kind != JobKind::Confirm)
            m_listener.ended();
    }
}

void RecomputeWorker::run(const Job& job)
{
    if (job.kind == JobKind::Confirm)
        return confirmAll({job.stop.get_token(), {}});
    if (m_evaluation.prepare)
        m_evaluation.prepare(job.treesInScene);
    const Progress whole = progressOf(job);
    const auto count = static_cast<double>(job.trees.size());
    for (std::size_t i = 0; i < job.trees.size() && !whole.cancelled(); ++i) {
        const double from = static_cast<double>(i) / count;
        evaluate(job.kind, job.trees[i], whole.part(from, from + 1.0 / count));
    }
}

/// Of full jobs only, and so rarely that the interface has time to draw it.
Progress RecomputeWorker::progressOf(const Job& job) const
{
    Progress progress{job.stop.get_token(), {}};
    if (job.kind == JobKind::Full)
        progress.onFraction = [this, last = Clock::time_point{}](double fraction) mutable {
            const Clock::time_point now = Clock::now();
            if (now - last < std::chrono::milliseconds(16))
                return;
            last = now;
            m_listener.progress(fraction);
        };
    return progress;
}

/// Running out of memory is an error as any other; the trees there are stay.
static Expected<TreeResult> evaluated(const Evaluation& evaluation, JobKind kind, const NodeParams& params,
                                      const Progress& progress)
{
    try {
        return kind == JobKind::Draft ? evaluation.draft(params, progress)
                                      : evaluation.evaluate(params, progress);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::Limit, RAMURE_NOOP("there is not enough memory for this tree"));
    }
}

void RecomputeWorker::evaluate(JobKind kind, const TreeJob& tree, const Progress& progress)
{
    TreeOutcome outcome;
    outcome.kind = kind;
    outcome.node = tree.node;
    outcome.revision = tree.revision;
    const Clock::time_point start = Clock::now();
    outcome.result = evaluated(m_evaluation, kind, tree.params, progress);
    outcome.isFull = kind == JobKind::Full || (outcome.result && outcome.result->report);
    outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (!outcome.result && outcome.result.error().code == ErrorCode::Cancelled)
        return;
    m_toConfirm.erase(tree.node); // whatever waited there is of older parameters
    if (outcome.result)
        lookAtReport(*outcome.result, outcome);
    m_listener.outcome(std::move(outcome));
}

/// Takes the second opinion where there is one already; otherwise it is asked for when the thread has time.
void RecomputeWorker::lookAtReport(TreeResult& tree, const TreeOutcome& outcome)
{
    const auto known = std::find_if(m_confirmed.begin(), m_confirmed.end(), [&tree](const Confirmed& entry) {
        return tree.branches && entry.mesh.lock() == tree.branches;
    });
    if (known != m_confirmed.end())
        tree.report = known->report;
    else if (outcome.isFull && tree.branches && tree.report && !tree.report->openMeshChecked)
        m_toConfirm[outcome.node] = {outcome.revision, tree};
}

void RecomputeWorker::confirmAll(const Progress& progress)
{
    while (!m_toConfirm.empty() && !progress.cancelled()) {
        const auto next = m_toConfirm.begin();
        Unconfirmed& waiting = next->second;
        auto report = std::make_shared<MeshReport>(*waiting.tree.report);
        const auto done = m_evaluation.confirm(waiting.tree.branches->mesh, *report, progress);
        if (!done && done.error().code == ErrorCode::Cancelled)
            return;
        if (done) {
            waiting.tree.report = report;
            if (m_confirmed.size() >= confirmedKept)
                m_confirmed.erase(m_confirmed.begin());
            m_confirmed.push_back({waiting.tree.branches, report});
            TreeOutcome outcome;
            outcome.kind = JobKind::Confirm;
            outcome.node = next->first;
            outcome.revision = waiting.revision;
            outcome.result = waiting.tree;
            m_listener.outcome(std::move(outcome));
        }
        m_toConfirm.erase(next);
    }
}

} // namespace ramure
