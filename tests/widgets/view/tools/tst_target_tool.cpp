#include "core/document/commands.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"

namespace tst_target_tool {

using namespace ramure;

/// Ctrl and a click or drag on a surface: the arm reaches for it.
class TestTargetTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutAnArmASurfaceIsSelected();
    void aDragMovesTheTargetInOneStep();
    void escapeTakesItBack();
    void surfacesAreMetBeforeTheyAreReady();
    void theHintSaysWhereAnArmCanBeSent();
};

namespace {

/// A box beside an arm.
struct Bench : test::ToolBench
{
    explicit Bench(bool withArm = true)
    {
        std::vector<Node> nodes(1);
        nodes[0].id = 2;
        nodes[0].kind = NodeKind::Primitive;
        nodes[0].name = "box";
        nodes[0].params.primitive.shape = PrimitiveShape::Box;
        nodes[0].params.tree.translation = {2.0, 0.0, 0.0};
        if (withArm) {
            Node arm;
            arm.id = 1;
            arm.kind = NodeKind::Arm;
            arm.name = "arm";
            arm.params.joints.resize(3);
            nodes.push_back(arm);
        }
        open(Scene::fromNodes(nodes).value_or(Scene()));
    }
    [[nodiscard]] QPointF onBox() const { return pixelOf({2.0, 0.1, 0.1}); }
    [[nodiscard]] glm::dvec3 target() const { return document.scene().find(1)->params.arm.target; }
};

} // namespace

void TestTargetTool::withoutAnArmASurfaceIsSelected()
{
    Bench bench(false);
    bench.drag(bench.onBox(), bench.onBox(), Qt::LeftButton, Qt::ControlModifier);
    QCOMPARE(bench.document.selection().nodes, std::vector<NodeId>{2});
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestTargetTool::aDragMovesTheTargetInOneStep()
{
    Bench bench;
    const glm::dvec3 before = bench.target();
    bench.press(bench.onBox(), Qt::LeftButton, Qt::ControlModifier);
    const glm::dvec3 first = bench.target();
    QVERIFY(first != before && bench.reach.progress());
    QVERIFY(bench.says("The arm reaches"));
    bench.move(bench.onBox() + QPointF(8.0, 0.0), Qt::ControlModifier);
    QVERIFY(bench.target() != first);
    bench.release(bench.onBox(), Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(bench.document.selection().nodes.empty());
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.reach.finish();
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.document.undoStack()->undo();
    QCOMPARE(bench.target(), before);
}

void TestTargetTool::escapeTakesItBack()
{
    Bench bench;
    const Scene before = bench.document.scene();
    bench.press(bench.onBox(), Qt::LeftButton, Qt::ControlModifier);
    bench.reach.step();
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.document.scene() == before);
    QVERIFY(!bench.reach.progress() || !bench.reach.progress()->moves);
    bench.release(bench.onBox(), Qt::LeftButton, Qt::ControlModifier);
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestTargetTool::surfacesAreMetBeforeTheyAreReady()
{
    Bench bench;
    const glm::dvec3 before = bench.target();
    bench.ready = false;
    bench.press(bench.onBox(), Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(bench.target() != before);
}

void TestTargetTool::theHintSaysWhereAnArmCanBeSent()
{
    Bench bench;
    QVERIFY(!bench.says("target"));
    bench.context.hoverNode = 2;
    QVERIFY(bench.says("Ctrl + click: target of the arm"));
    QVERIFY(bench.says("sets the target", {}, Qt::ControlModifier));
    bench.context.hoverNode = 1;
    QVERIFY(!bench.says("target"));
}

RAMURE_SUITE(TestTargetTool)

} // namespace tst_target_tool

#include "tst_target_tool.moc"
