#include "core/qt/document/commands.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include <QLineF>

namespace tst_target_tool {

using namespace ramure;

/// Ctrl and a click or drag on a surface: the arm reaches for it. So it does where its target is dragged by
/// the mark.
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
    void theMarkIsDraggedAcrossTheView();
    void theMarkOfALockedArmStays();
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
    /// Of the target: Z is up in the space of an arm.
    [[nodiscard]] QPointF onMark() const { return pixelOf({target().x, target().z, -target().y}); }
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
    bench.document.undo();
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

void TestTargetTool::theMarkIsDraggedAcrossTheView()
{
    Bench bench;
    const glm::dvec3 before = bench.target();
    const QPointF from = bench.onMark(), to = from + QPointF(-40.0, 30.0);
    QVERIFY(bench.says("Drag: the target of the arm", from));
    QVERIFY(!bench.says("Drag: the target of the arm", from, Qt::ControlModifier));
    QVERIFY(bench.tools.hover(bench.at(from)));
    QCOMPARE(bench.tools.cursor().shape(), Qt::SizeAllCursor);
    bench.press(from);
    bench.release(from); // a click changes nothing
    QCOMPARE(bench.target(), before);
    QCOMPARE(bench.document.undoStack()->count(), 0);
    bench.drag(from, to);
    QVERIFY(QLineF(bench.onMark(), to).length() < 0.01);
    QVERIFY(bench.document.selection().nodes.empty());
    bench.reach.finish();
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.document.undo();
    QCOMPARE(bench.target(), before);
    bench.press(from);
    bench.move(to);
    QVERIFY(bench.key(Qt::Key_Escape));
    bench.release(to);
    QCOMPARE(bench.target(), before);
}

void TestTargetTool::theMarkOfALockedArmStays()
{
    Bench bench;
    const glm::dvec3 before = bench.target();
    QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
    const int steps = bench.document.undoStack()->count();
    QVERIFY(!bench.tools.hover(bench.at(bench.onMark())));
    bench.drag(bench.onMark(), bench.onMark() + QPointF(30.0, 0.0));
    QCOMPARE(bench.target(), before);
    QCOMPARE(bench.document.undoStack()->count(), steps);
}

RAMURE_SUITE(TestTargetTool)

} // namespace tst_target_tool

#include "tst_target_tool.moc"
