/// \file
/// What works on the thread of the recompute object: takes jobs, gives results, knows no document.
#pragma once

#include "core/qt/session/jobs/evaluation.h"
#include "core/scene/scene.h"

#include <QtGlobal>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace ramure {

/// In the order in which they are served: the lanes of the job.
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

class RecomputeWorker
{
public:
    /// \param outcome called on the worker's thread.
    RecomputeWorker(Evaluation evaluation, std::function<void(TreeOutcome)> outcome);

    [[nodiscard]] bool confirms() const { return m_evaluation.confirm != nullptr; }
    /// Drafts or full results. Progress is told of these only.
    void run(JobKind kind, const std::vector<TreeJob>& trees, std::size_t treesInScene,
             const Progress& progress);
    /// The second opinion of what has none yet.
    void confirmAll(const Progress& progress);

private:
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

    void evaluate(JobKind kind, const TreeJob& tree, const Progress& progress);
    void lookAtReport(TreeResult& tree, const TreeOutcome& outcome);

    Evaluation m_evaluation;
    std::function<void(TreeOutcome)> m_outcome;
    std::map<NodeId, Unconfirmed> m_toConfirm; ///< full results without a second opinion
    std::vector<Confirmed> m_confirmed;        ///< the latest second opinions
};

} // namespace ramure
