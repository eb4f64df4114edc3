#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QThread>
#include <atomic>

namespace tst_analysis {

using namespace ramure;
using State = Analysis::State;

/// Stands for the analysis: as slow as asked; the hash names the mesh.
struct FakeAnalysis
{
    std::atomic<int> milliseconds{0};
    std::atomic<int> started{0}, finished{0}, stopped{0};
    std::atomic<bool> fails{false}, outOfMemory{false};

    Analysis::Function function()
    {
        return [this](const BranchMesh& branches, const Skeleton&,
                      const Progress& progress) -> Expected<MeshAnalysis> {
            ++started;
            for (int i = 0; i < milliseconds; ++i) {
                progress.report(double(i) / milliseconds);
                test::work(1);
                if (progress.cancelled()) {
                    ++stopped;
                    return fail(ErrorCode::Cancelled, "cancelled");
                }
            }
            ++finished;
            if (outOfMemory)
                throw std::bad_alloc();
            if (fails)
                return fail(ErrorCode::Invalid, "broken");
            MeshAnalysis analysis;
            analysis.hash.low = branches.roots;
            return analysis;
        };
    }
};

class TestAnalysis : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_fake.milliseconds = 0;
        m_fake.started = m_fake.finished = m_fake.stopped = 0;
        m_fake.fails = m_fake.outOfMemory = false;
    }
    void nothingToLookAt();
    void draftsAndErrorsAreNotLookedAt();
    void failuresAreTold();
    void findingsComeAndGoWithTheMesh();
    void meshesThatComeBackAreRemembered();
    void editsStopWhatRuns();
    void cancelAndStartAgain();
    void oneTreeAfterTheOther();
    void destroyedWhileItRuns();
    void theDocumentStaysAsItIs();
    void theInterfaceStaysAwake();

private:
    /// A document of so many trees, without results.
    static Scene trees(int count)
    {
        Scene scene;
        for (int i = 0; i < count; ++i) {
            Node node;
            node.id = scene.newId();
            node.kind = NodeKind::Tree;
            node.name = "Tree";
            scene.insert({node}, noNode, i);
        }
        return scene;
    }
    static void give(Document& document, NodeId tree, const std::shared_ptr<const BranchMesh>& mesh,
                     bool draft = false)
    {
        NodeResult result;
        result.tree.branches = mesh;
        result.tree.simplified = std::make_shared<SimplifiedSkeleton>();
        result.draft = draft;
        result.revision = document.revision();
        document.setResult(tree, std::move(result));
    }
    static std::shared_ptr<const BranchMesh> mesh(Index number)
    {
        BranchMesh branches;
        branches.roots = number;
        return std::make_shared<const BranchMesh>(std::move(branches));
    }
    static void setAlpha(Document& document, NodeId tree, double alpha)
    {
        QVERIFY(edit::setParam(document, {tree}, *findParam("turtle.alpha"), ParamValue(alpha)));
    }

    FakeAnalysis m_fake;
};

void TestAnalysis::nothingToLookAt()
{
    Document document;
    Analysis analysis(&document, m_fake.function());
    QCOMPARE(analysis.state(7), State::None);
    QVERIFY(!analysis.findings(7) && !analysis.error(7));
    analysis.cancel(7);
    analysis.start(7);
    QCOMPARE(analysis.state(7), State::None);
    QVERIFY(analysis.waitForAll(1000));
    QCOMPARE(m_fake.started.load(), 0);
}

void TestAnalysis::draftsAndErrorsAreNotLookedAt()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    give(document, tree, mesh(1), true);
    QCOMPARE(analysis.state(tree), State::None);
    NodeResult failed;
    failed.tree.branches = mesh(1);
    failed.tree.simplified = std::make_shared<SimplifiedSkeleton>();
    failed.error = Error{};
    failed.revision = document.revision();
    document.setResult(tree, failed);
    QCOMPARE(analysis.state(tree), State::None);
    QVERIFY(analysis.waitForAll(1000));
    QCOMPARE(m_fake.started.load(), 0);
}

void TestAnalysis::failuresAreTold()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    m_fake.fails = true;
    give(document, tree, mesh(1));
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.state(tree), State::Failed);
    QCOMPARE(analysis.error(tree)->plain(), std::string("broken"));
    m_fake.outOfMemory = true;
    analysis.start(tree);
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.error(tree)->code, ErrorCode::Limit);
    m_fake.fails = m_fake.outOfMemory = false;
    analysis.start(tree);
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.state(tree), State::Done);
}

void TestAnalysis::findingsComeAndGoWithTheMesh()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(5);
    QSignalSpy changed(&analysis, &Analysis::changed);
    give(document, tree, mesh(1));
    QCOMPARE(analysis.state(tree), State::Waiting);
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.state(tree), State::Done);
    QCOMPARE(analysis.findings(tree)->hash.low, std::uint64_t(1));
    QCOMPARE(changed.count(), 3); // waiting, running, done
    setAlpha(document, tree, 0.7);
    QCOMPARE(analysis.state(tree), State::None); // at once: what was found is of another tree
    QVERIFY(!analysis.findings(tree));
    give(document, tree, mesh(2));
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.findings(tree)->hash.low, std::uint64_t(2));
    QVERIFY(edit::removeNodes(document, {tree}));
    QCOMPARE(analysis.state(tree), State::None);
    document.reset(trees(1), {});
    QCOMPARE(analysis.state(document.scene().nodes().front().id), State::None);
}

void TestAnalysis::meshesThatComeBackAreRemembered()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    const auto first = mesh(1), second = mesh(2);
    for (const auto& branches : {first, second}) {
        give(document, tree, branches);
        QVERIFY(analysis.waitForAll(5000));
    }
    QCOMPARE(m_fake.started.load(), 2);
    give(document, tree, first);
    QCOMPARE(analysis.state(tree), State::Done);
    QCOMPARE(analysis.findings(tree)->hash.low, std::uint64_t(1));
    give(document, tree, first); // a second opinion in the same result
    QCOMPARE(analysis.state(tree), State::Done);
    QCOMPARE(m_fake.started.load(), 2);
}

void TestAnalysis::editsStopWhatRuns()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    m_fake.milliseconds = 60'000;
    give(document, tree, mesh(1));
    QTRY_COMPARE(analysis.state(tree), State::Running);
    QTRY_VERIFY(m_fake.started == 1);
    setAlpha(document, tree, 0.7);
    QCOMPARE(analysis.state(tree), State::None);
    QTRY_COMPARE(m_fake.stopped.load(), 1);
    QCOMPARE(m_fake.finished.load(), 0);
    m_fake.milliseconds = 0;
    give(document, tree, mesh(2));
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.findings(tree)->hash.low, std::uint64_t(2));
}

void TestAnalysis::cancelAndStartAgain()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    QSignalSpy progress(&analysis, &Analysis::progress);
    m_fake.milliseconds = 60'000;
    give(document, tree, mesh(1));
    QTRY_VERIFY(progress.count() >= 2);
    QVERIFY(analysis.fraction(tree) >= 0.0 && analysis.fraction(tree) < 1.0);
    analysis.cancel(tree);
    QCOMPARE(analysis.state(tree), State::Cancelled);
    QTRY_COMPARE(m_fake.stopped.load(), 1);
    QVERIFY(analysis.waitForAll(1000)); // does not come back by itself
    QCOMPARE(analysis.state(tree), State::Cancelled);
    m_fake.milliseconds = 0;
    analysis.start(tree);
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.state(tree), State::Done);
}

void TestAnalysis::oneTreeAfterTheOther()
{
    Document document;
    document.reset(trees(3), {});
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    m_fake.milliseconds = 5;
    Index number = 1;
    for (const Node& node : document.scene().nodes())
        give(document, node.id, mesh(number++));
    const auto running = [&] {
        int count = 0;
        for (const Node& node : document.scene().nodes())
            count += analysis.state(node.id) == State::Running ? 1 : 0;
        return count;
    };
    int most = 0;
    connect(&analysis, &Analysis::changed, this, [&] { most = std::max(most, running()); });
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(most, 1);
    number = 1;
    for (const Node& node : document.scene().nodes())
        QCOMPARE(analysis.findings(node.id)->hash.low, std::uint64_t(number++));
}

void TestAnalysis::destroyedWhileItRuns()
{
    Document document;
    document.reset(trees(1), {});
    {
        Analysis analysis(&document, m_fake.function());
        analysis.setRest(0);
        m_fake.milliseconds = 60'000;
        give(document, document.scene().nodes().front().id, mesh(1));
        QTRY_VERIFY(m_fake.started == 1);
    }
    QCOMPARE(m_fake.stopped.load(), 1);
}

void TestAnalysis::theDocumentStaysAsItIs()
{
    Document document;
    document.reset(trees(1), {});
    const NodeId tree = document.scene().nodes().front().id;
    Analysis analysis(&document, m_fake.function());
    analysis.setRest(0);
    give(document, tree, mesh(1));
    const quint64 revision = document.revision();
    QSignalSpy news(&document, &Document::changed);
    QVERIFY(analysis.waitForAll(5000));
    QCOMPARE(analysis.state(tree), State::Done);
    QCOMPARE(news.count(), 0);
    QCOMPARE(document.revision(), revision);
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(!document.isModified());
}

/// The real thing on a real tree, while the interface's thread goes on turning.
void TestAnalysis::theInterfaceStaysAwake()
{
    Document document;
    Scene scene = trees(1);
    const NodeId tree = scene.nodes().front().id;
    scene.find(tree)->params = *presetParams("TinyTree");
    document.reset(std::move(scene), {});
    Recompute recompute(&document);
    Analysis analysis(&document);
    analysis.setRest(0);
    QVERIFY(recompute.waitForFull(test::patience(60'000)));
    QVERIFY(analysis.waitForAll(60'000));
    QCOMPARE(analysis.state(tree), State::Done);
    const auto found = analysis.findings(tree);
    const TreeResult& result = document.result(tree)->tree;
    const auto again = analyseMesh(*result.branches, result.simplified->skeleton, 1);
    QVERIFY(again && found->sameFindings(*again));
    QVERIFY(found->crossings.kindsKnown);
    QCOMPARE(found->collisions.size(), found->crossings.branches.size());
}

RAMURE_SUITE(TestAnalysis)

} // namespace tst_analysis

#include "tst_analysis.moc"
