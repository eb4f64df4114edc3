#include "core/presets/presets.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include "widgets/view/tools/motion_tools.h"

namespace tst_wind_tool {

using namespace ramure;

/// The arrow of the wind is dragged by its head.
class TestWindTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void whatIsNotShownCannotBeTaken();
    void aDragSetsTheWindInOneStep();
    void escapeTakesItBack();
    void aTreeThatIsDeletedUnderTheHandComesBackAsItWas();
};

namespace {

struct Bench : test::ToolBench
{
    Recompute recompute{&document};

    Bench()
    {
        recompute.setRest(0);
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = "tree";
        node.params = presetParams("TinyTree").value_or(NodeParams{});
        node.params.physics.windStrength = 4.0;
        open(Scene::fromNodes({node}).value_or(Scene()));
        if (!recompute.waitForFull(test::patience(20'000)))
            qWarning("no result");
        show();
        document.setSelection({{1}, noNode, {}, noIndex});
        windVisible = true;
        camera.pitchRad = 0.6;
    }
    [[nodiscard]] QPointF head() const
    {
        Box box;
        for (const MeshItem& item : scene->meshes)
            box.add(item.box);
        for (const LineItem& item : scene->lines)
            box.add(item.lines->box);
        const auto arrow = windArrowOver(EvaluatedScene(document.scene()), 1, box, view(), true);
        return arrow ? pixelOf(arrow->head) : QPointF(-99.0, -99.0);
    }
    [[nodiscard]] double strength() const { return document.scene().find(1)->params.physics.windStrength; }
};

} // namespace

void TestWindTool::whatIsNotShownCannotBeTaken()
{
    Bench bench;
    bench.windVisible = false;
    bench.drag(bench.head(), bench.head() + QPointF(30.0, 0.0));
    QCOMPARE(bench.strength(), 4.0);
}

void TestWindTool::aDragSetsTheWindInOneStep()
{
    Bench bench;
    bench.press(bench.head());
    QVERIFY(bench.says("strength of the wind"));
    const QPointF from = bench.head();
    bench.move(from + QPointF(20.0, 5.0));
    bench.move(from + QPointF(30.0, 5.0));
    bench.release(from);
    QVERIFY(bench.strength() != 4.0);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.document.undo();
    QCOMPARE(bench.strength(), 4.0);
}

void TestWindTool::escapeTakesItBack()
{
    Bench bench;
    bench.press(bench.head());
    bench.move(bench.head() + QPointF(30.0, 5.0));
    QVERIFY(bench.strength() != 4.0);
    QVERIFY(bench.key(Qt::Key_Escape));
    QCOMPARE(bench.strength(), 4.0);
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestWindTool::aTreeThatIsDeletedUnderTheHandComesBackAsItWas()
{
    Bench bench;
    const QPointF from = bench.head();
    bench.press(from);
    bench.move(from + QPointF(30.0, 5.0));
    const double dragged = bench.strength();
    QVERIFY(dragged != 4.0);
    QVERIFY(edit::removeNodes(bench.document, {1}));
    bench.release(from);
    bench.document.undo();
    QCOMPARE(bench.strength(), dragged);
    bench.document.undo();
    QCOMPARE(bench.strength(), 4.0);
    QVERIFY(!bench.document.isModified());
}

RAMURE_SUITE(TestWindTool)

} // namespace tst_wind_tool

#include "tst_wind_tool.moc"
