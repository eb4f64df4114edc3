#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"

#include <QElapsedTimer>

namespace tst_recompute_trees {

using namespace ramure;

/// The background thread with the real pipeline and OpenMesh.
class TestRecomputeTrees : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongGrammarsNameTheirPlace();
    void equalsTheDirectEvaluation_data();
    void equalsTheDirectEvaluation();
    void undoFindsTheCache();
    void openMeshAgrees();
    void dragsEndWithTheFullTree();
};

static Scene oneTree(const NodeParams& params)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params = params;
    return *Scene::fromNodes({node});
}
static NodeParams smallTree(std::int64_t iterations)
{
    NodeParams params = *presetParams("SmallTree");
    params.grammar.iterations = iterations;
    return params;
}

void TestRecomputeTrees::wrongGrammarsNameTheirPlace()
{
    Document document;
    document.reset(oneTree(smallTree(4)), {});
    Recompute recompute(&document);
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    const auto good = document.result(1)->tree.branches;
    QVERIFY(edit::setParam(document, {1}, *findParam("grammar.rules"), std::string("A -> [[A\n")));
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    QVERIFY(document.result(1)->error);
    QCOMPARE(document.result(1)->error->path, std::string("grammar.rules"));
    QVERIFY(document.result(1)->tree.branches == good);
}

void TestRecomputeTrees::equalsTheDirectEvaluation_data()
{
    QTest::addColumn<int>("preset");
    for (std::size_t i = 0; i < courseworkPresets().size(); ++i)
        QTest::newRow(courseworkPresets()[i].name) << int(i);
}

void TestRecomputeTrees::equalsTheDirectEvaluation()
{
    QFETCH(int, preset);
    NodeParams params = courseworkPresets()[static_cast<std::size_t>(preset)].params;
    params.grammar.iterations = std::min<std::int64_t>(params.grammar.iterations, 5);
    Document document;
    document.reset(oneTree(params), {});
    Recompute recompute(&document);
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    QVERIFY(edit::setParam(document, {1}, *findParam("turtle.theta"), 0.35));
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    TreePipeline pipeline;
    const auto direct = pipeline.evaluate(document.scene().find(1)->params);
    QVERIFY2(direct, test::why(direct));
    const TreeResult& tree = document.result(1)->tree;
    QVERIFY(*tree.symbols == *direct->symbols);
    QVERIFY(tree.simplified->skeleton == direct->simplified->skeleton);
    QVERIFY(tree.branches->mesh == direct->branches->mesh);
    QVERIFY(*tree.leaves == *direct->leaves);
    QVERIFY(*tree.apples == *direct->apples);
    QVERIFY(tree.report->valid);
}

void TestRecomputeTrees::undoFindsTheCache()
{
    Document document;
    document.reset(oneTree(smallTree(5)), {});
    Recompute recompute(&document);
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    const TreeResult before = document.result(1)->tree;
    QVERIFY(edit::setParam(document, {1}, *findParam("turtle.alpha"), 0.3));
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    const TreeResult after = document.result(1)->tree;
    QVERIFY(after.branches != before.branches);
    document.undo();
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    QVERIFY(document.result(1)->tree.branches == before.branches);
    QVERIFY(document.result(1)->tree.leaves == before.leaves);
    document.redo();
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    QVERIFY(document.result(1)->tree.branches == after.branches);
}

void TestRecomputeTrees::openMeshAgrees()
{
    Document document;
    document.reset(oneTree(smallTree(5)), {});
    Recompute recompute(&document);
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    QTRY_VERIFY_WITH_TIMEOUT(document.result(1)->tree.report->openMeshChecked, test::patience(60000));
    QVERIFY(document.result(1)->tree.report->openMeshAgrees);
}

void TestRecomputeTrees::dragsEndWithTheFullTree()
{
    Document document;
    document.reset(oneTree(smallTree(8)), {});
    Recompute recompute(&document);
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    const ParamDef& theta = *findParam("turtle.theta");
    const GestureId drag = newGesture();
    int shown = 0;
    qint64 longestNs = 0;
    connect(&document, &Document::changed, &document,
            [&](const Change& change) { shown += change.has(changeResults); });
    for (int i = 0; i < 30; ++i) {
        QElapsedTimer timer;
        timer.start();
        QVERIFY(edit::setParam(document, {1}, theta, 0.3 + 0.002 * i, drag));
        longestNs = std::max(longestNs, timer.nsecsElapsed());
        const int before = shown;
        (void)QTest::qWaitFor([&] { return shown > before; }, 16);
    }
    QVERIFY(recompute.waitForFull(test::patience(60000)));
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(!document.result(1)->draft);
    QVERIFY(shown > 1);
    qInfo("30 edits, one each 16 ms or result: %d results shown; the longest edit took %lld us", shown,
          longestNs / 1000);
}

RAMURE_SUITE(TestRecomputeTrees)

} // namespace tst_recompute_trees

#include "tst_recompute_trees.moc"
