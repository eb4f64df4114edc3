#include "core/qt/session/jobs/recompute_worker.h"

#include "core/qt/session/jobs/job.h"

#include <algorithm>
#include <chrono>

namespace ramure {

using Clock = std::chrono::steady_clock;

static constexpr std::size_t confirmedKept = 32;

RecomputeWorker::RecomputeWorker(Evaluation evaluation, std::function<void(TreeOutcome)> outcome)
    : m_evaluation(std::move(evaluation))
    , m_outcome(std::move(outcome))
{
}

void RecomputeWorker::run(JobKind kind, const std::vector<TreeJob>& trees, std::size_t treesInScene,
                          const Progress& progress)
{
    if (m_evaluation.prepare)
        m_evaluation.prepare(treesInScene);
    const Progress whole = kind == JobKind::Full ? progress : Progress{progress.stop, {}};
    const auto count = static_cast<double>(trees.size());
    for (std::size_t i = 0; i < trees.size() && !whole.cancelled(); ++i) {
        const double from = static_cast<double>(i) / count;
        evaluate(kind, trees[i], whole.part(from, from + 1.0 / count));
    }
}

/// Running out of memory is an error as any other; the trees there are stay.
static Expected<TreeResult> evaluated(const Evaluation& evaluation, JobKind kind, const NodeParams& params,
                                      const Progress& progress)
{
    try {
        return kind == JobKind::Draft ? evaluation.draft(params, progress)
                                      : evaluation.evaluate(params, progress);
    } catch (...) {
        return fail(caughtError());
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
    // What waited there is of older parameters, but for a draft that comes after its own full result.
    if (const auto waiting = m_toConfirm.find(tree.node);
        waiting != m_toConfirm.end() && waiting->second.revision < tree.revision)
        m_toConfirm.erase(waiting);
    if (outcome.result)
        lookAtReport(*outcome.result, outcome);
    m_outcome(std::move(outcome));
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
            m_outcome(std::move(outcome));
        }
        m_toConfirm.erase(next);
    }
}

} // namespace ramure
