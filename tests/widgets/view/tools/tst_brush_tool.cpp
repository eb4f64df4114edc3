#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_brush_tool {

using namespace ramure;
using test::HandBench;

/// Branches are attracted, repelled and combed; leaves are painted off and on.
class TestBrushTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void whichTreeIsMeant();
    void whereNothingIsItSaysSo();
    void aMagnetIsOneEdit();
    void itRepels();
    void aStrokeCombs();
    void aClickDoesNotComb();
    void leavesGoAndComeBack();
    void theWheelIsTheRadius();
    void digitsAreTheStrength();
    void escapeTakesItBack();
    void anotherDocumentEndsIt();

private:
    static void choose(HandBench& bench, BrushKind kind)
    {
        HandOptions options = bench.hand.options();
        options.brush = kind;
        bench.hand.setOptions(options);
    }
};

void TestBrushTool::whichTreeIsMeant()
{
    HandBench bench(HandTool::Brush, 2);
    bench.drag({2.0, 2.0}, {60.0, 2.0});
    QVERIFY(bench.edits(1).empty() && bench.edits(2).empty());
    QCOMPARE(bench.messages.size(), 1);
}

void TestBrushTool::whereNothingIsItSaysSo()
{
    for (const BrushKind kind : {BrushKind::Attract, BrushKind::Bare}) {
        HandBench bench(HandTool::Brush);
        choose(bench, kind);
        HandOptions options = bench.hand.options();
        options.brushRadius = 0.01;
        bench.hand.setOptions(options);
        bench.click({2.0, 2.0});
        QVERIFY(bench.edits().empty());
        QCOMPARE(bench.messages.size(), 1);
        QCOMPARE(bench.document.undoStack()->count(), 0);
        QVERIFY(!bench.tools.current());
    }
}

void TestBrushTool::aMagnetIsOneEdit()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Attract);
    const Index twig = bench.twig();
    const QPointF at = bench.on(twig);
    bench.drag(at, at + QPointF(30.0, -20.0));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Attract);
    QVERIFY(bench.edits().front().strength > 0.0);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestBrushTool::itRepels()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Repel);
    bench.click(bench.on(bench.twig()));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QVERIFY(bench.edits().front().strength < 0.0);
}

void TestBrushTool::aStrokeCombs()
{
    HandBench bench(HandTool::Brush);
    HandOptions options = bench.hand.options();
    options.brush = BrushKind::Comb;
    options.brushStrength = 1.0;
    bench.hand.setOptions(options);
    const Index twig = bench.twig();
    const QPointF at = bench.on(twig), before = bench.on(twig, 1.0) - bench.on(twig, 0.0);
    const QPointF down(0.0, 200.0);
    bench.drag(at - 0.3 * down, at + 0.7 * down);
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    const TreeEdit& stroke = bench.edits().front();
    QCOMPARE(stroke.operation, EditOperation::Comb);
    QVERIFY(stroke.direction.y < 0.0);
    QVERIFY(!stroke.points.empty() && stroke.points.front().position.y < stroke.centre.y);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    const QPointF after = bench.on(twig, 1.0) - bench.on(twig, 0.0);
    const auto steepness = [](QPointF way) { return way.y() / std::hypot(way.x(), way.y()); };
    QVERIFY(steepness(after) > steepness(before));
}

void TestBrushTool::aClickDoesNotComb()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Comb);
    bench.click(bench.on(bench.twig()));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.messages.size(), 1);
    QVERIFY(!bench.tools.current());
}

void TestBrushTool::leavesGoAndComeBack()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Bare);
    const QPointF at = bench.on(bench.twig());
    bench.click(at);
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Leaves);
    QCOMPARE(bench.edits().front().target.address, std::uint64_t(0));
    QVERIFY(!bench.edits().front().shown);
    bench.grow();
    bench.click(at); // they are gone already
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.messages.size(), 1);
    choose(bench, BrushKind::Leafy);
    bench.click(at);
    QCOMPARE(bench.edits().size(), std::size_t(2));
    QVERIFY(bench.edits().back().shown);
}

void TestBrushTool::theWheelIsTheRadius()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Attract);
    const QPointF at = bench.on(bench.twig());
    const Camera before = bench.camera;
    bench.tools.hover(bench.at(at));
    QVERIFY(bench.tools.wheel(bench.at(at, Qt::NoButton, Qt::ShiftModifier), 120.0));
    const double once = bench.hand.options().brushRadius;
    QVERIFY(once > 0.0);
    QCOMPARE(bench.camera, before);
    bench.press(at);
    QVERIFY(bench.tools.wheel(bench.at(at), 120.0));
    bench.release(at);
    QVERIFY(std::abs(bench.hand.options().brushRadius / once - 1.1) < 1e-9);
    QCOMPARE(bench.edits().front().radius, bench.hand.options().brushRadius);
    QVERIFY(bench.tools.wheel(bench.at(at), 120.0)); // without Shift: the view
    QVERIFY(bench.camera != before);
}

void TestBrushTool::digitsAreTheStrength()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Repel);
    const QPointF at = bench.on(bench.twig());
    bench.press(at);
    QVERIFY(bench.says("strength"));
    bench.key(Qt::Key_8, QStringLiteral("8"));
    bench.key(Qt::Key_0, QStringLiteral("0"));
    bench.release(at);
    QCOMPARE(bench.edits().front().strength, -0.8);
}

void TestBrushTool::escapeTakesItBack()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Attract);
    bench.press(bench.on(bench.twig()));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestBrushTool::anotherDocumentEndsIt()
{
    HandBench bench(HandTool::Brush);
    choose(bench, BrushKind::Attract);
    bench.press(bench.on(bench.twig()));
    bench.document.reset(Scene(), {});
    QVERIFY(!bench.tools.current());
    bench.move({5.0, 5.0});
    bench.release({5.0, 5.0});
    bench.tools.hover(bench.at({5.0, 5.0}));
}

RAMURE_SUITE(TestBrushTool)

} // namespace tst_brush_tool

#include "tst_brush_tool.moc"
