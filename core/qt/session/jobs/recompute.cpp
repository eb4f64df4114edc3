#include "core/qt/session/jobs/recompute.h"

#include "core/qt/session/jobs/job.h"
#include "core/qt/session/jobs/recompute_worker.h"

#include <QEventLoop>
#include <QPointer>
#include <QTimer>
#include <algorithm>
#include <limits>

namespace ramure {

namespace {

/// How long such a direct one may still run when the next edit comes: it stands for a draft, which always
/// finishes.
constexpr std::chrono::milliseconds directGrace{100};

} // namespace

/// What full results of one tree took, by the first stage that had to be computed anew.
class FullTimes
{
public:
    /// Upper bound of what is known; infinity where nothing is.
    [[nodiscard]] double expected() const
    {
        const auto end = m_seconds.begin() + static_cast<std::ptrdiff_t>(m_stale) + 1;
        return *std::min_element(m_seconds.begin(), end);
    }
    void noteEdit(Stage stage) { m_stale = std::min(m_stale, stage); }
    /// \param complete no later edit waits for its result.
    void noteResult(double seconds, bool complete)
    {
        double& known = m_seconds[static_cast<std::size_t>(m_stale)];
        // A result out of the cache says little about the next one that is not.
        known = known == unknown ? seconds : std::max(seconds, 0.5 * known);
        if (complete)
            m_stale = Stage::Placement;
    }
    void noteTooSlow() { m_seconds.fill(unknown); }

private:
    static constexpr double unknown = std::numeric_limits<double>::infinity();
    static constexpr std::size_t count = static_cast<std::size_t>(Stage::Placement) + 1;
    static constexpr std::array<double, count> nothing()
    {
        std::array<double, count> seconds{};
        seconds.fill(unknown);
        return seconds;
    }

    std::array<double, count> m_seconds = nothing();
    Stage m_stale = Stage::Symbols;
};

struct Recompute::Private
{
    Private(Recompute* recompute, Document* doc, Evaluation evaluation)
        : q(recompute)
        , document(doc)
        , worker(std::make_shared<RecomputeWorker>(
              std::move(evaluation),
              [this, post = job.mailbox()](TreeOutcome outcome) { // from the thread to the interface's
                  post([this, kept = std::move(outcome)] { take(kept); });
              }))
    {
    }

    void post(JobKind kind, const std::vector<const Node*>& trees);
    void confirm();
    bool stop(JobKind kind, std::chrono::milliseconds grace = {});
    [[nodiscard]] bool isWorking() const
    {
        return job.isRunning(static_cast<int>(JobKind::Draft)) ||
               job.isRunning(static_cast<int>(JobKind::Full));
    }
    void documentChanged(const Change& change);
    void schedule(bool atOnce);
    void startFull();
    void take(const TreeOutcome& outcome);
    void store(const TreeOutcome& outcome);
    void confirmStored(const TreeOutcome& outcome);
    void updateBusy();
    [[nodiscard]] std::vector<const Node*> staleTrees() const;
    [[nodiscard]] bool isDirect(const std::vector<const Node*>& trees) const;
    [[nodiscard]] std::vector<TreeJob> jobs(const std::vector<const Node*>& trees) const;
    [[nodiscard]] std::size_t treeCount() const;

    Recompute* q;
    QPointer<Document> document;
    QTimer rest;
    int restMs = 120;
    double directSeconds = 0.012; // with the wait for the one before and the drawing: within two frames
    bool busy = false;
    bool runsDirect = false;   ///< the full job posted last stands for a draft
    quint64 resetRevision = 0; ///< results of the document before New or Open are nobody's
    std::map<NodeId, FullTimes> times;
    Job job;                                 ///< a lane for each kind
    std::shared_ptr<RecomputeWorker> worker; ///< only the thread uses it
};

/// Replaces what waits of this kind; what runs goes on. No trees: nothing waits any more.
void Recompute::Private::post(JobKind kind, const std::vector<const Node*>& trees)
{
    const int lane = static_cast<int>(kind);
    job.withdraw(lane);
    if (trees.empty())
        return;
    job.start(
        [with = worker, kind, list = jobs(trees), count = treeCount()](const Progress& progress) {
            with->run(kind, list, count, progress);
            return Expected<void>();
        },
        [this, kind](const Expected<void>& /*done*/) {
            if (kind == JobKind::Full && worker->confirms())
                confirm();
            updateBusy();
        },
        Job::Running::GoesOn, lane);
}

void Recompute::Private::confirm()
{
    job.start(
        [with = worker](const Progress& progress) {
            with->confirmAll({progress.stop, {}});
            return Expected<void>();
        },
        [](const Expected<void>& /*done*/) {}, Job::Running::GoesOn, static_cast<int>(JobKind::Confirm));
}

/// Takes back what waits and stops what runs, unless it is younger than \p grace. True where something that
/// ran was told to stop.
bool Recompute::Private::stop(JobKind kind, std::chrono::milliseconds grace)
{
    job.withdraw(static_cast<int>(kind));
    return job.cancel(static_cast<int>(kind), grace);
}

Recompute::Recompute(Document* document, QObject* parent)
    : Recompute(document, treeEvaluation(), parent)
{
}

Recompute::Recompute(Document* document, Evaluation evaluation, QObject* parent)
    : QObject(parent)
    , m_private(std::make_unique<Private>(this, document, std::move(evaluation)))
{
    connect(&m_private->job, &Job::progress, this, &Recompute::progress);
    m_private->rest.setSingleShot(true);
    connect(&m_private->rest, &QTimer::timeout, this, [this] {
        m_private->startFull();
        m_private->updateBusy();
    });
    connect(document, &Document::changed, this,
            [this](const Change& change) { m_private->documentChanged(change); });
    m_private->schedule(true);
}

Recompute::~Recompute() = default;

bool Recompute::isBusy() const
{
    return m_private->busy;
}

void Recompute::setRest(int milliseconds)
{
    m_private->restMs = std::max(0, milliseconds);
}

void Recompute::setDirectLimit(int milliseconds)
{
    m_private->directSeconds = std::max(0, milliseconds) / 1000.0;
}

void Recompute::cancel()
{
    m_private->rest.stop();
    m_private->stop(JobKind::Full);
    m_private->updateBusy();
}

bool Recompute::waitForFull(int timeoutMs)
{
    if (m_private->rest.isActive()) {
        m_private->rest.stop();
        m_private->startFull();
    }
    QEventLoop loop;
    bool inTime = true;
    QTimer::singleShot(timeoutMs, &loop, [&] {
        inTime = false;
        loop.quit();
    });
    connect(this, &Recompute::busyChanged, &loop, &QEventLoop::quit);
    while (inTime && isBusy())
        loop.exec();
    return m_private->staleTrees().empty();
}

void Recompute::Private::documentChanged(const Change& change)
{
    if (change.has(changeReset)) {
        resetRevision = change.revision;
        times.clear();
        rest.stop();
        for (const JobKind kind : {JobKind::Draft, JobKind::Full, JobKind::Confirm})
            stop(kind);
    }
    if (change.has(changeReset | changeStructure))
        return schedule(true);
    if (!change.has(changeParams | changeBranches) || change.firstStale >= Stage::Placement)
        return;
    for (const NodeId id : change.nodes)
        times[id].noteEdit(change.firstStale);
    schedule(false);
}

std::vector<const Node*> Recompute::Private::staleTrees() const
{
    std::vector<const Node*> trees;
    if (!document)
        return trees;
    for (const Node& node : document->scene().nodes())
        if (node.kind == NodeKind::Tree && !document->isCurrent(node.id))
            trees.push_back(&node);
    return trees;
}

std::size_t Recompute::Private::treeCount() const
{
    const NodeList nodes = document->scene().nodes();
    return static_cast<std::size_t>(std::count_if(
        nodes.begin(), nodes.end(), [](const Node& node) { return node.kind == NodeKind::Tree; }));
}

bool Recompute::Private::isDirect(const std::vector<const Node*>& trees) const
{
    double sum = 0.0;
    for (const Node* tree : trees) {
        const auto known = times.find(tree->id);
        sum += known == times.end() ? directSeconds : known->second.expected();
    }
    return restMs == 0 || sum < directSeconds;
}

std::vector<TreeJob> Recompute::Private::jobs(const std::vector<const Node*>& trees) const
{
    std::vector<TreeJob> list;
    for (const Node* tree : trees)
        list.push_back({tree->id, tree->params, document->revision()});
    return list;
}

/// \param atOnce no further edit of a drag is to be expected: the full result need not wait.
void Recompute::Private::schedule(bool atOnce)
{
    std::vector<const Node*> trees = staleTrees();
    if (trees.empty())
        return updateBusy();
    const bool fullStopped =
        stop(JobKind::Full, runsDirect && restMs > 0 ? directGrace : std::chrono::milliseconds{});
    const bool confirmStopped = stop(JobKind::Confirm);
    if ((fullStopped || confirmStopped) && runsDirect)
        for (const Node* tree : trees)
            times[tree->id].noteTooSlow();
    runsDirect = isDirect(trees);
    if (runsDirect) {
        rest.stop();
        post(JobKind::Draft, {});
        startFull();
    } else {
        if (atOnce)
            startFull();
        else
            rest.start(restMs);
        std::erase_if(trees, [this](const Node* tree) {
            const NodeResult* have = document->result(tree->id);
            return have && have->revision >= document->shapeRevision(tree->id); // its draft is there
        });
        post(JobKind::Draft, trees);
    }
    updateBusy();
}

void Recompute::Private::startFull()
{
    if (document)
        post(JobKind::Full, staleTrees());
}

void Recompute::Private::updateBusy()
{
    const bool now = rest.isActive() || isWorking();
    if (now == busy)
        return;
    busy = now;
    emit q->busyChanged(busy);
}

void Recompute::Private::take(const TreeOutcome& outcome)
{
    if (!document || outcome.revision < resetRevision || !document->scene().find(outcome.node))
        return;
    if (outcome.kind == JobKind::Confirm)
        confirmStored(outcome);
    else
        store(outcome);
}

void Recompute::Private::store(const TreeOutcome& outcome)
{
    const NodeResult* have = document->result(outcome.node);
    const bool draft = !outcome.isFull;
    if (have &&
        (have->revision > outcome.revision || (have->revision == outcome.revision && !have->draft && draft)))
        return;
    if (outcome.kind == JobKind::Full)
        times[outcome.node].noteResult(outcome.seconds,
                                       outcome.revision >= document->shapeRevision(outcome.node));
    NodeResult result;
    if (outcome.result)
        result.tree = *outcome.result;
    else {
        result.error = outcome.result.error();
        if (have)
            result.tree = have->tree;
    }
    result.draft = draft;
    result.revision = outcome.revision;
    document->setResult(outcome.node, std::move(result));
}

/// Only where the document still shows the mesh that was looked at.
void Recompute::Private::confirmStored(const TreeOutcome& outcome)
{
    const NodeResult* have = document->result(outcome.node);
    if (!have || have->error || have->tree.branches != outcome.result->branches)
        return;
    NodeResult result = *have;
    result.tree.report = outcome.result->report;
    document->setResult(outcome.node, std::move(result));
}

} // namespace ramure

#include "moc_recompute.cpp"
