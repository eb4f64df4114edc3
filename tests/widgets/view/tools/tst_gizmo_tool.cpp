#include "core/qt/document/commands.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include "widgets/view/tools/gizmo/gizmo_tool.h"

namespace tst_gizmo_tool {

using namespace ramure;

/// Moving, turning and scaling nodes with the mouse and with keys, without a window.
class TestGizmoTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutNodesNothingBegins();
    void aHandleMovesAndEscapeTakesItBack();
    void aClickThatMovesNothingLeavesNoStep();
    void keysAloneAreEnough();
    void aPressEndsWhatKeysBegan();
    void whoGoesOnElsewhereKeepsIt();
    void whoeverTakesTheNodeEndsIt();
    void theHintNamesWhatMoves();
};

namespace {

/// A box that is selected, with the tool Move.
struct Bench : test::ToolBench
{
    GizmoTool& tool = tools.tool<GizmoTool>();

    Bench()
    {
        Node node;
        node.id = 1;
        node.kind = NodeKind::Primitive;
        node.name = "box";
        node.params.primitive.shape = PrimitiveShape::Box;
        open(Scene::fromNodes({node}).value_or(Scene()));
        document.setSelection({{1}, noNode, {}, noIndex});
        gizmo.tool.set(TransformTool::Move);
        context.gestureKeys = [] { return QStringLiteral("G R S"); };
    }
    [[nodiscard]] glm::dvec3 place() const { return document.scene().find(1)->params.tree.translation; }
    /// Of the handle along x.
    [[nodiscard]] QPointF grip() const
    {
        const auto starts = transformStarts(document.scene(), {1}, 0.0, false);
        return gizmoGrip(view(), {shownPivot(document.scene(), starts), glm::dmat3(1.0)}, TransformTool::Move,
                         {GizmoPart::Axis, 0})
            .value_or(QPointF());
    }
    [[nodiscard]] int steps() const { return document.undoStack()->count(); }
};

constexpr QPointF middle(400.0, 300.0);

} // namespace

void TestGizmoTool::withoutNodesNothingBegins()
{
    Bench bench;
    bench.document.setSelection({});
    QVERIFY(!bench.tool.beginByKeys(TransformTool::Move, bench.at(middle)));
    QCOMPARE(bench.messages.size(), 1);
    QVERIFY(!bench.tools.current());
    QVERIFY(!bench.tools.hover(bench.at(middle)));
    bench.document.setSelection({{1}, noNode, {}, noIndex});
    bench.gizmo.tool.set(TransformTool::Select);
    QVERIFY(!bench.tools.hover(bench.at(bench.grip())));
}

void TestGizmoTool::aHandleMovesAndEscapeTakesItBack()
{
    Bench bench;
    QVERIFY(bench.tools.hover(bench.at(bench.grip())));
    QCOMPARE(bench.tools.cursor().shape(), Qt::SizeAllCursor);
    const QPointF from = bench.grip();
    bench.drag(from, from + QPointF(60.0, 0.0));
    QVERIFY(bench.place().x > 0.1);
    QCOMPARE(bench.place().y, 0.0);
    QCOMPARE(bench.steps(), 1);
    const glm::dvec3 before = bench.place();
    for (const bool byKey : {true, false}) {
        const QPointF again = bench.grip();
        bench.press(again);
        bench.move(again + QPointF(60.0, 0.0));
        QVERIFY(bench.place() != before);
        if (byKey)
            QVERIFY(bench.key(Qt::Key_Escape));
        else
            bench.press(again, Qt::RightButton);
        QVERIFY(!bench.tools.current());
        bench.release(again);
        QCOMPARE(bench.place(), before);
        QCOMPARE(bench.steps(), 1);
    }
}

void TestGizmoTool::aClickThatMovesNothingLeavesNoStep()
{
    Bench bench;
    const QPointF from = bench.grip();
    bench.drag(from, from + QPointF(2.0, 0.0));
    QCOMPARE(bench.steps(), 0);
    QCOMPARE(bench.place(), glm::dvec3(0.0));
}

void TestGizmoTool::keysAloneAreEnough()
{
    Bench bench;
    QVERIFY(bench.tool.beginByKeys(TransformTool::Move, bench.at(middle)));
    QVERIFY(bench.key(Qt::Key_Y, QStringLiteral("y")));
    QVERIFY(bench.key(Qt::Key_2, QStringLiteral("2")));
    QVERIFY(bench.tools.wheel(bench.at(middle), 120.0)); // the view stays
    QVERIFY(bench.key(Qt::Key_Return));
    QVERIFY(!bench.tools.current());
    QCOMPARE(bench.place(), glm::dvec3(0.0, 2.0, 0.0));
    QCOMPARE(bench.steps(), 1);
}

void TestGizmoTool::aPressEndsWhatKeysBegan()
{
    Bench bench;
    bench.tool.beginByKeys(TransformTool::Move, bench.at(middle));
    bench.move(middle + QPointF(50.0, 0.0));
    QVERIFY(bench.press(middle, Qt::LeftButton));
    QVERIFY(!bench.tools.current());
    QCOMPARE(bench.steps(), 1);
    const glm::dvec3 moved = bench.place();
    bench.tool.beginByKeys(TransformTool::Move, bench.at(middle));
    bench.move(middle + QPointF(50.0, 0.0));
    QVERIFY(bench.press(middle, Qt::RightButton));
    QCOMPARE(bench.place(), moved);
    QCOMPARE(bench.steps(), 1);
}

void TestGizmoTool::whoGoesOnElsewhereKeepsIt()
{
    Bench bench;
    bench.tool.beginByKeys(TransformTool::Move, bench.at(middle));
    bench.move(middle + QPointF(50.0, 0.0));
    bench.tools.focusLost();
    QVERIFY(!bench.tools.current());
    QCOMPARE(bench.steps(), 1);
}

void TestGizmoTool::whoeverTakesTheNodeEndsIt()
{
    Bench bench;
    bench.tool.beginByKeys(TransformTool::Move, bench.at(middle));
    QVERIFY(edit::removeNodes(bench.document, {1}));
    QVERIFY(!bench.tools.current());
    QVERIFY(!bench.key(Qt::Key_Escape));
}

void TestGizmoTool::theHintNamesWhatMoves()
{
    Bench bench;
    QVERIFY(bench.says("G R S: move, rotate, scale"));
    bench.tools.hover(bench.at(bench.grip()));
    QVERIFY(bench.hint().startsWith(QStringLiteral("Move ")));
    bench.tool.beginByKeys(TransformTool::Scale, bench.at(middle));
    QVERIFY(bench.hint().startsWith(QStringLiteral("Scale ")) && bench.says("Enter: done"));
    bench.key(Qt::Key_Escape);
    bench.gizmo.tool.set(TransformTool::Move);
    bench.press(bench.grip());
    QVERIFY(bench.says("release: done"));
}

RAMURE_SUITE(TestGizmoTool)

} // namespace tst_gizmo_tool

#include "tst_gizmo_tool.moc"
