#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/jobs/recompute_worker.h"
#include "tests/document/recorder.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QThread>
#include <atomic>

namespace tst_recompute {

using namespace ramure;

/// Stands for the pipeline: as slow as asked, counts, and stops when told to. A result's symbols name the
/// tree's alpha.
struct Fake
{
    std::atomic<int> draftMs{0}, fullMs{0}, confirmMs{0};
    std::atomic<int> drafts{0}, fulls{0}, confirms{0}; ///< that ran to their end
    std::atomic<int> started{0}, confirmsStarted{0};   ///< full results and second opinions
    std::atomic<int> cancelled{0};
    std::atomic<bool> offMainThread{true};
    std::shared_ptr<const BranchMesh> kept; ///< as out of a cache, where set

    /// False where it was told to stop.
    bool work(int milliseconds, const Progress& progress)
    {
        offMainThread = offMainThread && QThread::currentThread() != QCoreApplication::instance()->thread();
        for (int i = 0; i < milliseconds; ++i) {
            if (progress.cancelled())
                return false;
            progress.report(double(i) / milliseconds);
            test::work(1);
        }
        return !progress.cancelled();
    }
    static std::string nameOf(const NodeParams& params) { return std::to_string(params.turtle.alpha); }

    Expected<TreeResult> evaluate(const NodeParams& params, const Progress& progress, bool draft)
    {
        started += draft ? 0 : 1;
        if (!work(draft ? draftMs : fullMs, progress)) {
            ++cancelled;
            return fail(ErrorCode::Cancelled, "cancelled");
        }
        ++(draft ? drafts : fulls);
        if (params.grammar.axiom == "[")
            return fail(ErrorCode::Syntax, "unbalanced");
        if (params.grammar.axiom == "memory")
            throw std::bad_alloc();
        TreeResult result;
        result.symbols = std::make_shared<std::string>(nameOf(params));
        if (draft) {
            result.draftTubes = std::make_shared<TriangleMesh>();
            return result;
        }
        result.branches = kept ? kept : std::make_shared<BranchMesh>();
        result.report = std::make_shared<MeshReport>();
        return result;
    }
    Evaluation evaluation()
    {
        Evaluation functions;
        functions.evaluate = [this](const NodeParams& p, const Progress& progress) {
            return evaluate(p, progress, false);
        };
        functions.draft = [this](const NodeParams& p, const Progress& progress) {
            return evaluate(p, progress, true);
        };
        functions.confirm = [this](const TriangleMesh&, MeshReport& report,
                                   const Progress& progress) -> Expected<void> {
            ++confirmsStarted;
            if (!work(confirmMs, progress)) {
                ++cancelled;
                return fail(ErrorCode::Cancelled, "cancelled");
            }
            ++confirms;
            report.openMeshChecked = true;
            return {};
        };
        return functions;
    }
};

static Scene trees(int count, double alpha = 0.2)
{
    std::vector<Node> nodes(static_cast<std::size_t>(count));
    NodeId id = 0;
    for (Node& node : nodes) {
        node.id = ++id;
        node.kind = NodeKind::Tree;
        node.params.turtle.alpha = alpha;
    }
    return *Scene::fromNodes(nodes);
}

struct Fixture
{
    explicit Fixture(int count = 1, int fullMs = 0)
    {
        fake.fullMs = fullMs;
        document.reset(trees(count), {});
        recompute.emplace(&document, fake.evaluation());
    }
    void setAlpha(double alpha, NodeId id = 1)
    {
        QVERIFY(edit::setParam(document, {id}, *findParam("turtle.alpha"), alpha));
    }
    void setAxiom(const std::string& axiom, NodeId id = 1)
    {
        QVERIFY(edit::setParam(document, {id}, *findParam("grammar.axiom"), axiom));
    }
    std::string shown(NodeId id = 1) const
    {
        const NodeResult* result = document.result(id);
        return result && result->tree.symbols ? *result->tree.symbols : std::string();
    }
    /// Everything is computed, and from now on there are drafts.
    void settleWithDrafts()
    {
        recompute->setDirectLimit(0);
        QVERIFY(recompute->waitForFull(test::patience(20000)));
        QTRY_VERIFY(!recompute->isBusy());
        fake.drafts = fake.fulls = fake.started = fake.cancelled = 0;
    }
    /// Everything is computed, and from now on there are none.
    void settleWithoutDrafts()
    {
        settleWithDrafts();
        recompute->setDirectLimit(1000000);
    }
    Document document;
    Fake fake;
    std::optional<Recompute> recompute;
};

class TestRecompute : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void errorsKeepTheLastGoodTree();
    void memoryOutIsAnError();
    void diesWhileBusy();
    void documentMayDieFirst();
    void nothingToDo();

    void firstResultNeedsNoEdit();
    void burstsShowEveryDraft();
    void floodsEndWithTheLastValue();
    void newerEditsCancelTheFullOne();
    void cancelKeepsTheDraft();
    void cheapTreesHaveNoDrafts();
    void treesThatBecomeSlowGetDraftsAgain();
    void noRestMeansNoDrafts();
    void draftsThatAreFull();
    void draftsAreNoMeshes();
    void oldErrorsAreNoProblemsOfNewParameters();
    void onlyStaleTreesAreComputed();
    void placementComputesNothing();
    void removedTreesAreForgotten();
    void resetDropsTheOldResults();
    void secondOpinionsFollow();
    void secondOpinionsAreInterruptedAndResumed();
    void lateDraftsKeepTheSecondOpinionComing();
    void knownMeshesAreNotAskedTwice();
    void progressAndBusy();
    void snapshotsAreSmall();
};

void TestRecompute::errorsKeepTheLastGoodTree()
{
    Fixture f;
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    const auto good = f.document.result(1)->tree.branches;
    f.setAxiom("[");
    QVERIFY(f.recompute->waitForFull(test::patience(20000))); // the answer is there: it is an error
    const NodeResult* result = f.document.result(1);
    QVERIFY(result->error);
    QCOMPARE(result->error->code, ErrorCode::Syntax);
    QVERIFY(result->tree.branches == good);
    QVERIFY(f.document.isCurrent(1));
    f.setAxiom("A");
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QVERIFY(!f.document.result(1)->error);
    // From the start: an error without any tree.
    Fixture g;
    g.setAxiom("[");
    QVERIFY(g.recompute->waitForFull(test::patience(20000)));
    QVERIFY(g.document.result(1)->error);
}

void TestRecompute::memoryOutIsAnError()
{
    Fixture f;
    f.setAxiom("memory");
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QCOMPARE(f.document.result(1)->error->code, ErrorCode::Limit);
}

void TestRecompute::diesWhileBusy()
{
    for (int delay = 0; delay < 12; ++delay) {
        Fixture f(2, 1000000);
        f.fake.draftMs = delay % 2 == 0 ? 0 : 1000000;
        f.fake.confirmMs = 1000000;
        if (delay % 3 == 0)
            f.recompute->setRest(0);
        f.setAlpha(0.3);
        test::anyMoment(delay);
        f.setAlpha(0.4, 2);
        f.recompute.reset();
    }
}

void TestRecompute::documentMayDieFirst()
{
    Fake fake;
    fake.fullMs = 20;
    auto document = std::make_unique<Document>();
    document->reset(trees(2), {});
    Recompute recompute(document.get(), fake.evaluation());
    document.reset();
    QTRY_VERIFY(!recompute.isBusy());
    QVERIFY(recompute.waitForFull(1000));
    recompute.cancel();
}

void TestRecompute::nothingToDo()
{
    Fixture f(0);
    QVERIFY(!f.recompute->isBusy());
    QVERIFY(f.recompute->waitForFull(1000));
    QCOMPARE(f.fake.started, 0);
}

void TestRecompute::firstResultNeedsNoEdit()
{
    Fixture f(2);
    QVERIFY(f.recompute->isBusy());
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QVERIFY(!f.recompute->isBusy());
    QVERIFY(f.document.isCurrent(1) && f.document.isCurrent(2));
    QVERIFY(f.fake.offMainThread);
    Fixture g(0);
    QVERIFY(edit::insertNodes(g.document, trees(1).nodes(), noNode, 0)); // nor has one that is added to rest
    QVERIFY(g.recompute->waitForFull(test::patience(20000)));
}

void TestRecompute::burstsShowEveryDraft()
{
    Fixture f;
    f.recompute->setRest(100000);
    f.settleWithDrafts();
    f.fake.draftMs = 2;
    for (int i = 1; i <= 20; ++i) {
        const double alpha = 0.3 + 0.01 * i;
        f.setAlpha(alpha);
        QTRY_COMPARE(f.shown(), std::to_string(alpha));
        QVERIFY(f.document.result(1)->draft);
    }
    QCOMPARE(f.fake.drafts, 20);
    QCOMPARE(f.fake.started, 0);
    QVERIFY(f.recompute->waitForFull(test::patience(20000))); // does not wait for the rest to be over
    QVERIFY(!f.document.result(1)->draft);
    QCOMPARE(f.shown(), std::to_string(0.5));
}

void TestRecompute::floodsEndWithTheLastValue()
{
    Fixture f(3);
    f.recompute->setRest(5);
    f.settleWithDrafts();
    f.fake.draftMs = 3;
    test::Recorder recorder(f.document);
    std::vector<quint64> revisions;
    connect(&f.document, &Document::changed, &f.document, [&](const Change& change) {
        if (change.has(changeResults))
            revisions.push_back(f.document.result(change.nodes.front())->revision);
    });
    for (int i = 0; i < 200; ++i) {
        f.setAlpha(0.1 + 0.001 * i, static_cast<NodeId>(1 + i % 3));
        if (i % 3 == 0)
            QCoreApplication::processEvents();
        if (i % 10 == 0)
            test::work(2);
    }
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    for (const NodeId id : {1u, 2u, 3u})
        QCOMPARE(f.shown(id), Fake::nameOf(f.document.scene().find(id)->params));
    QVERIFY(std::is_sorted(revisions.begin(), revisions.end())); // nothing goes back
    QVERIFY(recorder.paired());
}

void TestRecompute::newerEditsCancelTheFullOne()
{
    Fixture f;
    f.settleWithDrafts();
    f.recompute->setRest(1);
    f.fake.fullMs = 1000000;
    f.setAlpha(0.3);
    QTRY_COMPARE(f.fake.started, 1);
    QTRY_COMPARE(f.shown(), std::to_string(0.3));
    f.setAlpha(0.4);
    QTRY_COMPARE(f.fake.cancelled, 1);
    QTRY_COMPARE(f.shown(), std::to_string(0.4));
    QVERIFY(f.document.result(1)->draft);
    QTRY_COMPARE(f.fake.started, 2);
    f.fake.fullMs = 0;
    f.setAlpha(0.5);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QCOMPARE(f.shown(), std::to_string(0.5));
}

void TestRecompute::cancelKeepsTheDraft()
{
    Fixture f;
    f.settleWithDrafts();
    f.recompute->setRest(1);
    f.fake.fullMs = 1000000;
    f.setAlpha(0.3);
    QTRY_COMPARE(f.fake.started, 1);
    f.recompute->cancel();
    QTRY_VERIFY(!f.recompute->isBusy());
    QVERIFY(f.document.result(1)->draft);
    QCOMPARE(f.shown(), std::to_string(0.3));
    QVERIFY(!f.recompute->waitForFull(1000));
    f.recompute->cancel(); // nothing runs: nothing happens
    f.fake.fullMs = 0;
    f.setAlpha(0.4);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
}

void TestRecompute::cheapTreesHaveNoDrafts()
{
    Fixture f;
    f.settleWithoutDrafts();
    for (int i = 0; i < 10; ++i) {
        f.setAlpha(0.3 + 0.01 * i);
        QTRY_VERIFY(f.document.isCurrent(1) && f.document.result(1)->tree.report->openMeshChecked);
    }
    QCOMPARE(f.fake.drafts, 0);
}

void TestRecompute::treesThatBecomeSlowGetDraftsAgain()
{
    Fixture f;
    f.settleWithoutDrafts();
    f.fake.fullMs = 1000000;
    f.setAlpha(0.3); // starts the full one at once, as the last was cheap
    QTRY_COMPARE(f.fake.started, 1);
    test::letHappen(150); // longer than a cheap one is waited for
    f.setAlpha(0.4);
    QTRY_COMPARE(f.fake.cancelled, 1);
    QTRY_COMPARE(f.shown(), std::to_string(0.4));
    QVERIFY(f.document.result(1)->draft);
}

void TestRecompute::noRestMeansNoDrafts()
{
    Fixture f;
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(!f.recompute->isBusy());
    f.fake.drafts = 0;
    f.fake.fullMs = 50;
    f.recompute->setRest(0);
    for (int i = 0; i < 5; ++i) {
        const int started = f.fake.started;
        f.setAlpha(0.3 + 0.01 * i);
        QTRY_VERIFY(f.fake.started > started);
    }
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QCOMPARE(f.fake.drafts, 0);
    QCOMPARE(f.shown(), std::to_string(0.34));
}

void TestRecompute::draftsThatAreFull()
{
    Document document;
    document.reset(trees(1), {});
    Fake fake;
    Evaluation functions = fake.evaluation();
    functions.draft = functions.evaluate; // as out of a cache
    Recompute recompute(&document, functions);
    recompute.setRest(100000);
    recompute.setDirectLimit(0);
    QVERIFY(recompute.waitForFull(test::patience(20000)));
    QVERIFY(edit::setParam(document, {1}, *findParam("turtle.alpha"), 0.3));
    QTRY_VERIFY(document.isCurrent(1)); // although the rest is not over
}

void TestRecompute::draftsAreNoMeshes()
{
    Document document;
    document.reset(trees(1), {});
    Recompute recompute(&document);
    recompute.setRest(100000);
    recompute.setDirectLimit(0);
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    const auto mesh = document.result(1)->tree.branches;
    QVERIFY(mesh && !document.result(1)->tree.draftTubes);
    QVERIFY(edit::setParam(document, {1}, *findParam("turtle.theta"), 0.6));
    QTRY_VERIFY(document.result(1)->draft);
    const TreeResult draft = document.result(1)->tree;
    QVERIFY(!draft.branches && !draft.report); // nothing to export or to check
    QVERIFY(draft.draftTubes && !draft.draftTubes->empty());
    QVERIFY(draft.leaves && draft.sections);
    document.undo(); // its mesh is still there: no draft is shown
    QTRY_VERIFY(document.isCurrent(1));
    QVERIFY(document.result(1)->tree.branches == mesh);
    document.redo();
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    const TreeResult full = document.result(1)->tree;
    QVERIFY(full.branches && full.report->valid && !full.draftTubes);
    QVERIFY(full.simplified == draft.simplified && full.leaves == draft.leaves); // not made twice
}

void TestRecompute::oldErrorsAreNoProblemsOfNewParameters()
{
    Fixture f;
    f.settleWithDrafts();
    QVERIFY(!f.document.problem(1) && !f.document.problem(77));
    f.setAxiom("[");
    QVERIFY(!f.document.problem(1)); // nobody knows yet
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QVERIFY(f.document.problem(1));
    f.fake.draftMs = f.fake.fullMs = 1000000;
    f.setAxiom("A");
    QVERIFY(f.document.result(1)->error);
    QVERIFY(!f.document.problem(1));
    f.fake.draftMs = f.fake.fullMs = 0;
}

void TestRecompute::onlyStaleTreesAreComputed()
{
    Fixture f(5);
    f.settleWithDrafts();
    f.setAlpha(0.3, 4);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(!f.recompute->isBusy());
    QCOMPARE(f.fake.fulls, 1);
    QCOMPARE(f.fake.drafts, 1);
}

void TestRecompute::placementComputesNothing()
{
    Fixture f(2);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(!f.recompute->isBusy());
    const int before = f.fake.started;
    QVERIFY(edit::setParam(f.document, {1}, *findParam("tree.rotation"), glm::dvec3(0.5)));
    QVERIFY(edit::setNodeName(f.document, 1, "x"));
    QVERIFY(edit::moveNode(f.document, 1, 2, 0, true));
    QVERIFY(!f.recompute->isBusy());
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QCOMPARE(f.fake.started, before);
    QVERIFY(f.document.isCurrent(1));
}

void TestRecompute::removedTreesAreForgotten()
{
    Fixture f(2);
    f.settleWithDrafts();
    f.setAlpha(0.3, 2);
    QVERIFY(edit::removeNodes(f.document, {2}));
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(!f.recompute->isBusy());
    QVERIFY(!f.document.result(2));
    f.document.undo();
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QCOMPARE(f.shown(2), std::to_string(0.3));
}

void TestRecompute::resetDropsTheOldResults()
{
    Fixture f;
    f.settleWithDrafts();
    f.fake.draftMs = 30;
    test::Recorder recorder(f.document);
    f.setAlpha(0.3);
    f.document.reset(trees(1, 0.7), {}); // the same id, another tree
    QVERIFY(!f.document.result(1));
    std::vector<std::string> seen;
    connect(&f.document, &Document::changed, &f.document, [&](const Change&) { seen.push_back(f.shown()); });
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    for (const std::string& name : seen)
        QCOMPARE(name, std::to_string(0.7));
    QVERIFY(recorder.paired());
}

void TestRecompute::secondOpinionsFollow()
{
    Fixture f(2);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    for (const NodeId id : {1u, 2u})
        QTRY_VERIFY(f.document.result(id)->tree.report->openMeshChecked);
    QCOMPARE(f.fake.confirms, 2);
    f.setAlpha(0.3);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(f.document.result(1)->tree.report->openMeshChecked);
    QCOMPARE(f.fake.confirms, 3);
}

void TestRecompute::secondOpinionsAreInterruptedAndResumed()
{
    Fixture f(2);
    f.fake.confirmMs = 1000000;
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(!f.recompute->isBusy()); // the second opinion does not count
    QTRY_COMPARE(f.fake.confirmsStarted, 1);
    f.fake.confirmMs = 0;
    f.setAlpha(0.3, 2);
    QTRY_COMPARE(f.fake.cancelled, 1);
    for (const NodeId id : {1u, 2u}) // the first tree was not changed, its opinion was interrupted
        QTRY_VERIFY(f.document.result(id)->tree.report->openMeshChecked);
}

void TestRecompute::lateDraftsKeepTheSecondOpinionComing()
{
    Fake fake;
    std::vector<JobKind> seen;
    RecomputeWorker worker(fake.evaluation(),
                           [&seen](const TreeOutcome& outcome) { seen.push_back(outcome.kind); });
    const TreeJob job{1, {}, 3};
    worker.run(JobKind::Full, {job}, 1, {});
    worker.run(JobKind::Draft, {job}, 1, {}); // asked for at the same time, but the full one was there first
    worker.confirmAll({});
    QCOMPARE(seen, (std::vector{JobKind::Full, JobKind::Draft, JobKind::Confirm}));

    worker.run(JobKind::Full, {{1, {}, 4}}, 1, {});
    worker.run(JobKind::Draft, {{1, {}, 5}}, 1, {}); // now the full one is of older parameters
    worker.confirmAll({});
    QCOMPARE(seen.size(), std::size_t{5});
}

void TestRecompute::knownMeshesAreNotAskedTwice()
{
    Document document;
    document.reset(trees(1), {});
    Fake fake;
    fake.kept = std::make_shared<BranchMesh>();
    Recompute recompute(&document, fake.evaluation());
    QVERIFY(recompute.waitForFull(test::patience(20000)));
    QTRY_VERIFY(document.result(1)->tree.report->openMeshChecked);
    QVERIFY(edit::setParam(document, {1}, *findParam("foliage.leavesDensity"), std::int64_t{3}));
    QVERIFY(recompute.waitForFull(test::patience(20000)));
    QVERIFY(document.result(1)->tree.report->openMeshChecked);
    QCOMPARE(fake.confirms, 1);
}

void TestRecompute::progressAndBusy()
{
    Fixture f(2, 100);
    QSignalSpy busy(&*f.recompute, &Recompute::busyChanged);
    QSignalSpy progress(&*f.recompute, &Recompute::progress);
    QVERIFY(f.recompute->waitForFull(test::patience(20000)));
    QTRY_VERIFY(!f.recompute->isBusy());
    QCOMPARE(busy.count(), 1); // it was busy when we came
    double last = 0.0;
    for (const QList<QVariant>& call : progress) {
        QVERIFY(call.front().toDouble() >= last && call.front().toDouble() <= 1.0);
        last = call.front().toDouble();
    }
    QVERIFY(progress.count() >= 2);
    f.setAlpha(0.4);
    QVERIFY(f.recompute->isBusy());
    QTRY_VERIFY(!f.recompute->isBusy());
    QCOMPARE(busy.count(), 3);
}

void TestRecompute::snapshotsAreSmall()
{
    Document document;
    document.reset(trees(1), {});
    std::vector<TreeEdit> steps(10000, {.operation = EditOperation::Roll, .target = {.address = 1}});
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i].id = i + 1;
    QVERIFY(edit::setTreeEdits(document, 1, steps, {}));
    QElapsedTimer timer;
    timer.start();
    const NodeParams copy = document.scene().find(1)->params;
    const qint64 ns = timer.nsecsElapsed();
    QCOMPARE(copy.edits.size(), std::size_t{10000});
    qInfo("snapshot of a tree with 10,000 steps: %lld us", ns / 1000);
}

RAMURE_SUITE(TestRecompute)

} // namespace tst_recompute

#include "tst_recompute.moc"
