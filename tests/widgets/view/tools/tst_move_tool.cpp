#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_move_tool {

using namespace ramure;
using test::HandBench;

/// A fork slides along its parent, turns about it, goes to another branch.
class TestMoveTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void whatStandsOnTheGroundStays();
    void itSlidesAlongItsParent();
    void itTurnsAboutIt();
    void itsPlaceIsTyped();
    void itGoesToAnotherBranch();
    void aLimbDoesNotGoOntoItself();
    void severalSlideTogether();
    void escapeTakesItBack();
    void theSameLimbGoesOn();

private:
    /// A limb of the trunk that is seen, and where on it.
    static Index limbOfTrunk(HandBench& bench)
    {
        const TreeAxes& axes = *bench.context.limbs.axes(bench.document, 1);
        for (Index b = 0; b < bench.skeleton().size(); ++b) {
            const LimbHit limb = bench.limb(b);
            const Index parent = axes.axes[limb.axis].parent;
            const QPointF at = bench.on(b);
            const auto hit = bench.latestPickScene()->pick(bench.view(), {at.x(), at.y()});
            if (parent != noIndex && axes.axes[parent].parent == noIndex && hit && hit->branch == b)
                return b;
        }
        return noIndex;
    }
    static const Axis& axisOf(HandBench& bench, std::uint64_t address)
    {
        const TreeAxes& axes = *bench.context.limbs.axes(bench.document, 1);
        return *std::ranges::find(axes.axes, address, &Axis::address);
    }
};

void TestMoveTool::whatStandsOnTheGroundStays()
{
    HandBench bench(HandTool::Move);
    bench.drag(bench.on(0, 0.5), bench.on(0, 0.5) + QPointF(0.0, -60.0));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.messages.size(), 1);
    bench.drag({2.0, 2.0}, {60.0, 2.0});
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestMoveTool::itSlidesAlongItsParent()
{
    HandBench bench(HandTool::Move);
    const Index branch = limbOfTrunk(bench);
    const LimbHit limb = bench.limb(branch);
    const double before = axisOf(bench, limb.address).share;
    const QPointF at = bench.on(branch), up = bench.on(0, 1.0) - bench.on(0, 0.0);
    bench.press(at);
    bench.move(at - 0.1 * up);
    bench.move(at - 0.2 * up);
    QVERIFY(bench.says("Release"));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    bench.release(at - 0.2 * up);
    QCOMPARE(bench.edits().front().operation, EditOperation::Move);
    QVERIFY(bench.edits().front().at < before - 0.01);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    const double wanted = bench.edits().front().at;
    bench.grow();
    QVERIFY(!LimbFinder().limb(bench.document, 1, limb.address).empty());
    const TreeAxes& axes = *bench.context.limbs.axes(bench.document, 1);
    const auto moved = std::ranges::find(axes.axes, limb.address, &Axis::address);
    QVERIFY(moved != axes.axes.end());
    QVERIFY(std::abs(moved->share - wanted) < 0.02);
}

void TestMoveTool::itTurnsAboutIt()
{
    HandBench bench(HandTool::Move);
    const Index branch = limbOfTrunk(bench);
    const LimbHit limb = bench.limb(branch);
    const Axis before = axisOf(bench, limb.address);
    const QPointF at = bench.on(branch);
    bench.press(at);
    bench.move(at + QPointF(60.0, 0.0), Qt::ShiftModifier);
    QVERIFY(bench.tools.wheel(bench.at(at), 240.0));
    bench.release(at + QPointF(60.0, 0.0));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().at, before.share);
    QVERIFY(std::abs(bench.edits().front().azimuthRad - before.azimuth - 40.0 * 0.0174533) < 1e-3);
}

void TestMoveTool::itsPlaceIsTyped()
{
    HandBench bench(HandTool::Move);
    bench.click(bench.on(limbOfTrunk(bench)));
    QVERIFY(bench.says("place in %"));
    bench.key(Qt::Key_3, QStringLiteral("3"));
    bench.key(Qt::Key_0, QStringLiteral("0"));
    bench.key(Qt::Key_Return);
    QVERIFY(!bench.tools.current());
    QCOMPARE(bench.edits().front().at, 0.3);
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

void TestMoveTool::itGoesToAnotherBranch()
{
    HandBench bench(HandTool::Move);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig), trunk = bench.limb(0);
    bench.press(bench.on(twig));
    bench.move(bench.on(0, 0.5), Qt::ControlModifier);
    bench.release(bench.on(0, 0.5), Qt::LeftButton, Qt::ControlModifier);
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().target.address, limb.address);
    QCOMPARE(bench.edits().front().other.address, trunk.address);
}

void TestMoveTool::aLimbDoesNotGoOntoItself()
{
    HandBench bench(HandTool::Move);
    const QPointF at = bench.on(bench.twig());
    bench.press(at);
    bench.move(at + QPointF(2.0, 0.0), Qt::ControlModifier);
    bench.key(Qt::Key_Escape);
    QVERIFY(bench.edits().empty());
}

void TestMoveTool::severalSlideTogether()
{
    HandBench bench(HandTool::Move);
    const Index branch = limbOfTrunk(bench);
    bench.select(1, bench.all());
    const QPointF at = bench.on(branch), up = bench.on(0, 1.0) - bench.on(0, 0.0);
    bench.drag(at, at - 0.2 * up);
    QVERIFY2(bench.edits().size() > 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestMoveTool::escapeTakesItBack()
{
    HandBench bench(HandTool::Move);
    const QPointF at = bench.on(limbOfTrunk(bench));
    bench.press(at);
    bench.move(at + QPointF(0.0, 40.0));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestMoveTool::theSameLimbGoesOn()
{
    HandBench bench(HandTool::Move);
    const std::uint64_t address = bench.limb(limbOfTrunk(bench)).address;
    for (const char* place : {"3", "4"}) {
        const Index first = LimbFinder().limb(bench.document, 1, address).front();
        const QPointF at = bench.on(first);
        bench.click(at);
        bench.key(Qt::Key_unknown, QString::fromLatin1(place));
        bench.key(Qt::Key_unknown, QStringLiteral("0"));
        bench.key(Qt::Key_Return);
        bench.grow();
        QCOMPARE(bench.edits().size(), std::size_t(1));
    }
    QCOMPARE(bench.edits().front().at, 0.4);
}

RAMURE_SUITE(TestMoveTool)

} // namespace tst_move_tool

#include "tst_move_tool.moc"
