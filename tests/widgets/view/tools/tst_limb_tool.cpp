#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"

namespace tst_limb_tool {

using namespace ramure;

/// Ctrl and a drag on a branch of a tree at rest.
class TestLimbTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideTheTreeNothingBends();
    void aDragIsSeenThenMade();
    void aClickSelects();
    void escapeTakesItBack();
    void theWheelSetsHowManyFollow();
    void anotherDocumentEndsIt();
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
        open(Scene::fromNodes({node}).value_or(Scene()));
        if (!recompute.waitForFull(test::patience(20'000)))
            qWarning("no result");
        show();
    }
    [[nodiscard]] const Skeleton& skeleton() const { return document.result(1)->tree.simplified->skeleton; }
    [[nodiscard]] QPointF onTwig() const
    {
        const Index twig = skeleton().size() - 1;
        return pixelOf(glm::mix(skeleton().p0[twig], skeleton().p1[twig], 0.8));
    }
    [[nodiscard]] bool isBent() const { return !document.scene().find(1)->params.edits.empty(); }
    /// The button stays down.
    void bend()
    {
        press(onTwig(), Qt::LeftButton, Qt::ControlModifier);
        move(onTwig() + QPointF(40.0, -15.0), Qt::ControlModifier);
    }
};

} // namespace

void TestLimbTool::besideTheTreeNothingBends()
{
    Bench bench;
    bench.press({2.0, 2.0}, Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(!bench.context.limbPose);
    bench.release({2.0, 2.0}, Qt::LeftButton, Qt::ControlModifier);
    bench.ready = false;
    bench.bend();
    QVERIFY(!bench.context.limbPose);
}

void TestLimbTool::aDragIsSeenThenMade()
{
    Bench bench;
    bench.context.hoverNode = 1;
    bench.context.hoverBranch = 0;
    QVERIFY(bench.says("Ctrl: drag bends the limb", {}, Qt::ControlModifier));
    bench.bend();
    QVERIFY(bench.context.limbPose && bench.context.limbPose->isHeld());
    QVERIFY(bench.context.limbPose->motion(nullptr));
    QVERIFY(!bench.isBent()); // nothing is computed
    QVERIFY(bench.says("The limb follows") && bench.says("thick", {}, Qt::ShiftModifier));
    bench.release({500.0, 300.0}, Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(bench.isBent());
    QCOMPARE(bench.document.undoStack()->count(), 1);
    QVERIFY(!bench.context.limbPose->isHeld() && !bench.context.limbPose->isRest()); // its mesh is to come
}

void TestLimbTool::aClickSelects()
{
    Bench bench;
    const QPointF at = bench.onTwig();
    bench.press(at, Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(bench.tools.goesOn());
    bench.release(at, Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(!bench.isBent() && !bench.context.limbPose);
    const Selection& selection = bench.document.selection();
    QCOMPARE(selection.branches, LimbFinder().limbOf(bench.document, 1, selection.activeBranch));
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestLimbTool::escapeTakesItBack()
{
    Bench bench;
    bench.bend();
    QTRY_VERIFY(bench.isBent());   // the hand rests
    QVERIFY(bench.key(Qt::Key_Z)); // no shortcut meanwhile
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(!bench.isBent() && !bench.tools.current());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestLimbTool::theWheelSetsHowManyFollow()
{
    Bench bench;
    const Camera before = bench.camera;
    bench.bend();
    const auto bends = bench.context.limbPose->latest();
    QVERIFY(bench.tools.wheel(bench.at(bench.onTwig()), -120.0));
    bench.release({500.0, 300.0}, Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(bench.context.limbPose->latest() != bends);
    QCOMPARE(bench.camera, before);
}

void TestLimbTool::anotherDocumentEndsIt()
{
    Bench bench;
    bench.bend();
    bench.document.reset(Scene(), {});
    QVERIFY(!bench.tools.current() && !bench.context.limbPose);
    bench.release({500.0, 300.0}, Qt::LeftButton, Qt::ControlModifier);
}

RAMURE_SUITE(TestLimbTool)

} // namespace tst_limb_tool

#include "tst_limb_tool.moc"
