#include "core/qt/session/jobs/analysis.h"

#include "core/qt/session/jobs/job.h"
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <map>
#include <utility>

namespace ramure {
namespace {

constexpr std::size_t findingsKept = 16; ///< of meshes gone by; the meshes themselves are not kept

using MeshPointer = std::shared_ptr<const BranchMesh>;
using FindingsPointer = std::shared_ptr<const MeshAnalysis>;

} // namespace

struct Analysis::Private
{
    /// What is known about the mesh of one tree.
    struct Entry
    {
        std::weak_ptr<const BranchMesh> mesh;
        Analysis::State state = Analysis::State::None;
        FindingsPointer findings;
        std::optional<Error> error;
        double fraction = 0.0;
    };

    struct Remembered
    {
        std::weak_ptr<const BranchMesh> mesh;
        FindingsPointer findings;
    };

    Private(Analysis* analysis, Document* doc, Function work)
        : q(analysis)
        , document(doc)
        , function(std::move(work))
    {
    }

    void documentChanged(const Change& change);
    void look(NodeId tree);
    void runNext();
    void launch(NodeId tree);
    void take(const MeshPointer& mesh, Expected<MeshAnalysis>&& outcome);
    void drop(NodeId tree);
    void stopRunning();
    void set(NodeId tree, State state);
    [[nodiscard]] MeshPointer fullMesh(NodeId tree) const;
    [[nodiscard]] FindingsPointer remembered(const MeshPointer& mesh) const;

    Analysis* q;
    Document* document;
    Function function;
    QTimer rest;
    std::map<NodeId, Entry> entries;
    std::vector<Remembered> memory; ///< the oldest first
    NodeId running = noNode;
    Job job{nullptr, Job::Manner::Polite};
};

Analysis::Analysis(Document* document, QObject* parent)
    : Analysis(
          document,
          [](const BranchMesh& branches, const Skeleton& skeleton, const Progress& progress) {
              return analyseMesh(branches, skeleton, 0, progress);
          },
          parent)
{
}

Analysis::Analysis(Document* document, Function function, QObject* parent)
    : QObject(parent)
    , m_private(std::make_unique<Private>(this, document, std::move(function)))
{
    m_private->rest.setSingleShot(true);
    m_private->rest.setInterval(250);
    connect(&m_private->rest, &QTimer::timeout, this, [this] { m_private->runNext(); });
    connect(&m_private->job, &Job::progress, this, [this](double fraction) {
        m_private->entries[m_private->running].fraction = fraction;
        emit progress(m_private->running, fraction);
    });
    connect(document, &Document::changed, this,
            [this](const Change& change) { m_private->documentChanged(change); });
    for (const Node& node : document->scene().nodes())
        m_private->look(node.id);
}

Analysis::~Analysis() = default;

Analysis::State Analysis::state(NodeId tree) const
{
    const auto entry = m_private->entries.find(tree);
    return entry == m_private->entries.end() ? State::None : entry->second.state;
}

FindingsPointer Analysis::findings(NodeId tree) const
{
    const auto entry = m_private->entries.find(tree);
    return entry == m_private->entries.end() ? nullptr : entry->second.findings;
}

std::optional<Error> Analysis::error(NodeId tree) const
{
    const auto entry = m_private->entries.find(tree);
    return entry == m_private->entries.end() ? std::nullopt : entry->second.error;
}

double Analysis::fraction(NodeId tree) const
{
    const auto entry = m_private->entries.find(tree);
    return entry == m_private->entries.end() ? 0.0 : entry->second.fraction;
}

void Analysis::setRest(int milliseconds)
{
    m_private->rest.setInterval(std::max(0, milliseconds));
}

bool Analysis::waitForAll(int timeoutMs)
{
    const auto isOver = [this] {
        return std::none_of(m_private->entries.begin(), m_private->entries.end(), [](const auto& entry) {
            return entry.second.state == State::Waiting || entry.second.state == State::Running;
        });
    };
    QEventLoop loop;
    bool inTime = true;
    QTimer::singleShot(timeoutMs, &loop, [&] {
        inTime = false;
        loop.quit();
    });
    connect(this, &Analysis::changed, &loop, &QEventLoop::quit);
    while (inTime && !isOver())
        loop.exec();
    return isOver();
}

void Analysis::cancel(NodeId tree)
{
    const State now = state(tree);
    if (now != State::Waiting && now != State::Running)
        return;
    if (now == State::Running)
        m_private->stopRunning();
    m_private->set(tree, State::Cancelled);
    m_private->runNext();
}

void Analysis::start(NodeId tree)
{
    const State now = state(tree);
    if (now == State::Cancelled || now == State::Failed)
        m_private->set(tree, State::Waiting);
    m_private->runNext();
}

void Analysis::Private::documentChanged(const Change& change)
{
    if (change.has(changeReset)) {
        stopRunning();
        const std::map<NodeId, Entry> gone = std::move(entries);
        entries.clear();
        for (const auto& [tree, entry] : gone)
            emit q->changed(tree);
    }
    if (change.has(changeStructure)) {
        std::vector<NodeId> gone;
        for (const auto& [tree, entry] : entries)
            if (!document->scene().find(tree))
                gone.push_back(tree);
        for (const NodeId tree : gone)
            drop(tree);
    }
    const bool reshapes = change.has(changeParams | changeBranches) && change.firstStale < Stage::Placement;
    if (reshapes || change.has(changeResults | changeReset | changeStructure))
        for (const NodeId tree : change.nodes)
            look(tree);
}

/// The mesh of the present parameters; null while there is none.
MeshPointer Analysis::Private::fullMesh(NodeId tree) const
{
    const NodeResult* result = document->result(tree);
    if (!result || result->draft || result->error || !document->isCurrent(tree) || !result->tree.simplified)
        return nullptr;
    return result->tree.branches;
}

FindingsPointer Analysis::Private::remembered(const MeshPointer& mesh) const
{
    for (const Remembered& known : memory)
        if (known.mesh.lock() == mesh)
            return known.findings;
    return nullptr;
}

/// Makes the entry fit what the document has now.
void Analysis::Private::look(NodeId tree)
{
    const MeshPointer mesh = fullMesh(tree);
    if (!mesh)
        return drop(tree);
    const auto known = entries.find(tree);
    if (known != entries.end() && known->second.mesh.lock() == mesh)
        return;
    if (running == tree)
        stopRunning();
    Entry& entry = entries[tree];
    entry = {};
    entry.mesh = mesh;
    entry.findings = remembered(mesh);
    set(tree, entry.findings ? State::Done : State::Waiting);
    if (!entry.findings)
        rest.start();
}

void Analysis::Private::drop(NodeId tree)
{
    if (running == tree)
        stopRunning();
    if (entries.erase(tree) > 0)
        emit q->changed(tree);
}

void Analysis::Private::stopRunning()
{
    if (running == noNode)
        return;
    job.forget();
    running = noNode;
    rest.start(); // for those that wait behind it
}

void Analysis::Private::set(NodeId tree, State state)
{
    entries[tree].state = state;
    entries[tree].fraction = 0.0;
    emit q->changed(tree);
}

void Analysis::Private::runNext()
{
    if (running != noNode)
        return;
    rest.stop();
    // The tree that is looked at has waited longest, to the eye.
    const NodeId active = document->selection().activeNode();
    const auto waits = [](const auto& entry) { return entry.second.state == State::Waiting; };
    auto next = entries.find(active);
    if (next == entries.end() || !waits(*next))
        next = std::find_if(entries.begin(), entries.end(), waits);
    if (next != entries.end())
        launch(next->first);
}

void Analysis::Private::launch(NodeId tree)
{
    const MeshPointer mesh = fullMesh(tree);
    if (!mesh)
        return drop(tree);
    running = tree;
    const auto simplified = document->result(tree)->tree.simplified;
    job.start([work = function, mesh,
               simplified](const Progress& progress) { return work(*mesh, simplified->skeleton, progress); },
              [this, mesh](Expected<MeshAnalysis>&& outcome) { take(mesh, std::move(outcome)); });
    set(tree, State::Running);
}

void Analysis::Private::take(const MeshPointer& mesh, Expected<MeshAnalysis>&& outcome)
{
    const NodeId tree = std::exchange(running, noNode);
    Entry& entry = entries[tree];
    if (outcome) {
        entry.findings = std::make_shared<const MeshAnalysis>(std::move(*outcome));
        std::erase_if(memory, [](const Remembered& known) { return known.mesh.expired(); });
        if (memory.size() >= findingsKept)
            memory.erase(memory.begin());
        memory.push_back({mesh, entry.findings});
        set(tree, State::Done);
    } else {
        entry.error = outcome.error();
        set(tree, State::Failed);
    }
    runNext();
}

} // namespace ramure

#include "moc_analysis.cpp"
