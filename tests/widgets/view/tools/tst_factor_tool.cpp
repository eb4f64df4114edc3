#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_factor_tool {

using namespace ramure;
using test::HandBench;

/// Length and thickness: by a drag, the wheel, or a number.
class TestFactorTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideTheTreeNothingHappens();
    void aDragAlongTheBranchMakesItLonger();
    void aDragToTheSideMakesItThicker();
    void aTipGetsThicker();
    void aLimbRollsUpWhereItIsDragged();
    void whatGrowsOnALimbTurnsAboutIt();
    void anglesAreTyped();
    void whereNothingGrowsNothingTurns();
    void escapeTakesItBack();
    void theWheelChangesWhatIsHeld();
    void numbersAreTyped();
    void aClickWithoutANumberChangesNothing();
    void theSameLimbGoesOn();
    void severalAtOnce();
    void handlesTakeThinLimbs();
    void anotherDocumentEndsIt();
};

void TestFactorTool::besideTheTreeNothingHappens()
{
    HandBench bench(HandTool::Length);
    bench.drag({2.0, 2.0}, {60.0, 2.0});
    QVERIFY(bench.edits().empty());
}

void TestFactorTool::aDragAlongTheBranchMakesItLonger()
{
    HandBench bench(HandTool::Length);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    const double before = bench.context.limbs.axes(bench.document, 1)->axes[limb.axis].length;
    const QPointF foot = bench.on(twig, 0.0), at = bench.on(twig);
    bench.press(at);
    bench.move(at + 0.8 * (at - foot));
    bench.tools.hover(bench.at(at)); // the picture is ready, and the view looks again
    QVERIFY(bench.marked.empty());
    QVERIFY(bench.says("Release"));
    QCOMPARE(bench.edits().size(), std::size_t(1)); // while it is dragged
    bench.release(at + 0.8 * (at - foot));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    QCOMPARE(bench.edits().front().operation, EditOperation::Length);
    QVERIFY(bench.edits().front().factor > 1.05);
    const double factor = bench.edits().front().factor;
    bench.grow();
    const TreeAxes& axes = *bench.context.limbs.axes(bench.document, 1);
    const auto after = std::ranges::find(axes.axes, limb.address, &Axis::address);
    QVERIFY(after != axes.axes.end());
    QVERIFY(std::abs(after->length / before - factor) < 0.02 * factor);
}

void TestFactorTool::aDragToTheSideMakesItThicker()
{
    HandBench bench(HandTool::Thickness);
    const QPointF at = bench.on(bench.twig());
    bench.drag(at, at + QPointF(140.0, 0.0));
    QVERIFY(std::abs(bench.edits().front().factor - 2.0) < 0.05);
    QVERIFY(bench.edits().front().below);
    bench.document.undo();
    bench.grow();
    HandOptions options = bench.hand.options();
    options.withBelow = false;
    bench.hand.setOptions(options);
    bench.drag(at, at - QPointF(140.0, 0.0));
    QVERIFY(std::abs(bench.edits().front().factor - 0.5) < 0.05);
    QVERIFY(!bench.edits().front().below);
}

void TestFactorTool::aTipGetsThicker()
{
    HandBench bench(HandTool::Taper);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    const QPointF at = bench.on(twig);
    const double before =
        bench.skeleton().a1[bench.context.limbs.limb(bench.document, 1, limb.address).back()];
    bench.drag(at, at + QPointF(140.0, 0.0));
    QCOMPARE(bench.edits().front().operation, EditOperation::Taper);
    QVERIFY(std::abs(bench.edits().front().factor - 2.0) < 0.05);
    bench.grow();
    const double after =
        bench.skeleton().a1[bench.context.limbs.limb(bench.document, 1, limb.address).back()];
    QVERIFY(after > 1.9 * before);
}

void TestFactorTool::aLimbRollsUpWhereItIsDragged()
{
    for (const double side : {-1.0, 1.0}) {
        HandBench bench(HandTool::Curl);
        const Index twig = bench.twig();
        const LimbHit limb = bench.limb(twig);
        const auto tip = [&] {
            return bench.on(bench.context.limbs.limb(bench.document, 1, limb.address).back(), 1.0);
        };
        const QPointF along = bench.on(twig, 1.0) - bench.on(twig, 0.0), before = tip();
        const QPointF across = QPointF(-along.y(), along.x()) / std::hypot(along.x(), along.y());
        bench.drag(bench.on(twig), bench.on(twig) + 160.0 * side * across);
        QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
        QCOMPARE(bench.edits().front().operation, EditOperation::Curl);
        QVERIFY(std::abs(glm::length(bench.edits().front().rotation) - 1.396) < 0.05);
        bench.grow();
        QVERIFY(side * QPointF::dotProduct(tip() - before, across) > 1.0);
    }
}

void TestFactorTool::whatGrowsOnALimbTurnsAboutIt()
{
    HandBench bench(HandTool::Twist);
    const QPointF trunk = bench.on(0, 0.5);
    const Index twig = bench.twig();
    const glm::dvec3 before = bench.skeleton().p1[twig];
    bench.drag(trunk, trunk + QPointF(180.0, 0.0));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Twist);
    QVERIFY(std::abs(bench.edits().front().angleRad - 1.5708) < 0.02);
    bench.grow();
    QVERIFY(glm::length(bench.skeleton().p1[twig] - before) > 1e-3);
}

void TestFactorTool::anglesAreTyped()
{
    HandBench bench(HandTool::Curl);
    HandOptions options = bench.hand.options();
    options.curlFrom = 0.4;
    bench.hand.setOptions(options);
    bench.click(bench.on(bench.twig()));
    QVERIFY(bench.says("degrees"));
    for (const char digit : {'-', '9', '0'})
        QVERIFY(bench.key(Qt::Key_unknown, QString(QLatin1Char(digit))));
    bench.key(Qt::Key_Return);
    QCOMPARE(bench.edits().front().from, 0.4);
    QVERIFY(std::abs(glm::length(bench.edits().front().rotation) - 1.5708) < 1e-4);
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestFactorTool::whereNothingGrowsNothingTurns()
{
    HandBench bench(HandTool::Twist);
    const QPointF at = bench.on(bench.twig());
    bench.drag(at, at + QPointF(100.0, 0.0));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.messages.size(), 1);
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestFactorTool::escapeTakesItBack()
{
    HandBench bench(HandTool::Thickness);
    const QPointF at = bench.on(bench.twig());
    bench.press(at);
    bench.move(at + QPointF(100.0, 0.0));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
    bench.release(at);
    QVERIFY(!bench.tools.current());
}

void TestFactorTool::theWheelChangesWhatIsHeld()
{
    HandBench bench(HandTool::Length);
    const QPointF at = bench.on(bench.twig());
    bench.press(at);
    QVERIFY(bench.tools.wheel(bench.at(at), 240.0));
    bench.release(at);
    QVERIFY(std::abs(bench.edits().front().factor - 1.1025) < 1e-9);
    const Camera before = bench.camera;
    QVERIFY(bench.tools.wheel(bench.at(at), 240.0)); // nothing is held: the view
    QVERIFY(bench.camera != before);
}

void TestFactorTool::numbersAreTyped()
{
    HandBench bench(HandTool::Length);
    const QPointF at = bench.on(bench.twig());
    bench.click(at);
    QVERIFY(bench.tools.goesOn());
    for (const char digit : {'1', '.', '7', '5'})
        QVERIFY(bench.key(Qt::Key_unknown, QString(QLatin1Char(digit))));
    QVERIFY(bench.key(Qt::Key_Backspace));
    QVERIFY(bench.key(Qt::Key_Return));
    QVERIFY(!bench.tools.current());
    QCOMPARE(bench.edits().front().factor, 1.7);
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

void TestFactorTool::aClickWithoutANumberChangesNothing()
{
    HandBench bench(HandTool::Thickness);
    const QPointF at = bench.on(bench.twig());
    bench.click(at);
    bench.click(at); // done
    QVERIFY(!bench.tools.current());
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestFactorTool::theSameLimbGoesOn()
{
    HandBench bench(HandTool::Thickness);
    const QPointF at = bench.on(bench.twig());
    bench.drag(at, at + QPointF(140.0, 0.0));
    bench.grow();
    bench.drag(at, at + QPointF(140.0, 0.0));
    QCOMPARE(bench.edits().size(), std::size_t(1)); // no row for each drag
    QVERIFY(std::abs(bench.edits().front().factor - 4.0) < 0.2);
    QCOMPARE(bench.document.undoStack()->count(), 2);
    bench.document.undo();
    QVERIFY(std::abs(bench.edits().front().factor - 2.0) < 0.1);
    bench.grow();
    bench.press(at);
    bench.move(at + QPointF(100.0, 0.0));
    bench.key(Qt::Key_Escape);
    QVERIFY(std::abs(bench.edits().front().factor - 2.0) < 0.1);
}

void TestFactorTool::handlesTakeThinLimbs()
{
    HandBench bench(HandTool::Length);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    const auto branches = bench.context.limbs.limb(bench.document, 1, limb.address);
    const QPointF tip = bench.on(branches.back(), 1.0), foot = bench.on(branches.front(), 0.0);
    const QPointF beyond = tip + 7.0 * (tip - foot) / std::hypot((tip - foot).x(), (tip - foot).y());
    const double before = bench.context.limbs.axes(bench.document, 1)->axes[limb.axis].length;
    bench.tools.hover(bench.at(bench.on(twig)));
    QVERIFY(bench.tools.hover(bench.at(beyond)));
    QVERIFY(!bench.marked.empty());
    // The tip follows the hand.
    bench.drag(beyond, beyond + 0.5 * (tip - foot));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().target.address, limb.address);
    bench.grow();
    const TreeAxes& axes = *bench.context.limbs.axes(bench.document, 1);
    const double after = std::ranges::find(axes.axes, limb.address, &Axis::address)->length;
    QVERIFY(after > 1.2 * before && after < 2.0 * before);
    // Far from the limb its handles are no more.
    bench.tools.leave();
    bench.document.undo();
    bench.grow();
    bench.drag(beyond, beyond + QPointF(30.0, 0.0)); // at most another one behind is hit
    QVERIFY(std::ranges::none_of(bench.edits(),
                                 [&](const TreeEdit& edit) { return edit.target.address == limb.address; }));
}

void TestFactorTool::severalAtOnce()
{
    HandBench bench(HandTool::Length);
    std::vector<Index> all = bench.all();
    all.erase(all.begin());
    bench.select(1, all);
    const QPointF at = bench.on(bench.twig());
    bench.click(at);
    bench.key(Qt::Key_2, QStringLiteral("2"));
    bench.key(Qt::Key_Enter);
    QVERIFY(bench.edits().size() > 1);
    for (const TreeEdit& edit : bench.edits())
        QCOMPARE(edit.factor, 2.0);
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

void TestFactorTool::anotherDocumentEndsIt()
{
    HandBench bench(HandTool::Length);
    bench.press(bench.on(bench.twig()));
    bench.document.reset(Scene(), {});
    QVERIFY(!bench.tools.current());
    bench.move({5.0, 5.0});
    bench.release({5.0, 5.0});
}

RAMURE_SUITE(TestFactorTool)

} // namespace tst_factor_tool

#include "tst_factor_tool.moc"
