#include "core/recipe/edit_report.h"
#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include <QTest>

namespace tst_bend_tool {

using namespace ramure;
using test::HandBench;

/// A drag on a branch with the Bend tool: the limb bows.
class TestBendTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideTheTreeNothingBends();
    void whatFollowsIsShownBefore();
    void aFewPixelsBesideATwigTakeIt();
    void aDragBowsTheLimb();
    void theWheelReachesFarther();
    void escapeTakesItBack();
    void aClickSelects();
    void bendsStayAfterACut();

private:
    static void pull(HandBench& bench, QPointF from, QPointF by)
    {
        bench.press(from);
        bench.move(from + 0.5 * by);
        bench.move(from + by);
    }
};

void TestBendTool::besideTheTreeNothingBends()
{
    HandBench bench(HandTool::Bend);
    bench.drag({2.0, 2.0}, {60.0, 60.0});
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestBendTool::whatFollowsIsShownBefore()
{
    HandBench bench(HandTool::Bend);
    bench.tools.hover(bench.at(bench.on(bench.twig())));
    QVERIFY(!bench.marked.empty() && !bench.markedGo);
    QVERIFY(bench.says("bows along its green part"));
    bench.tools.hover(bench.at({2.0, 2.0}));
    QVERIFY(bench.marked.empty());
}

void TestBendTool::aFewPixelsBesideATwigTakeIt()
{
    HandBench bench(HandTool::Bend);
    const auto isHit = [&](QPointF place) {
        return bench.latestPickScene()->pick(bench.view(), {place.x(), place.y()}).has_value();
    };
    QPointF at = bench.on(bench.twig());
    QVERIFY(isHit(at));
    while (isHit(at))
        at += QPointF(1.0, 0.0);
    at += QPointF(2.0, 0.0);
    QVERIFY(!isHit(at));
    bench.tools.hover(bench.at(at));
    QVERIFY(!bench.marked.empty());
    bench.drag(at, at + QPointF(25.0, 10.0));
    QCOMPARE(bench.edits().size(), std::size_t(1));
}

void TestBendTool::aDragBowsTheLimb()
{
    HandBench bench(HandTool::Bend);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    const QPointF at = bench.on(twig);
    pull(bench, at, {25.0, 10.0});
    QVERIFY(bench.says("wheel"));
    bench.release(at + QPointF(25.0, 10.0));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    const TreeEdit& bend = bench.edits().front();
    QCOMPARE(bend.operation, EditOperation::Bend);
    QCOMPARE(bend.target.address, limb.address);
    QVERIFY(bend.from == 0.0 && bend.to > 0.2 && glm::length(bend.rotation) > 0.05);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    const std::size_t before = bench.context.limbs.limb(bench.document, 1, limb.address).size();
    bench.grow();
    QVERIFY(bench.context.limbs.limb(bench.document, 1, limb.address).size() > before); // a curve
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestBendTool::theWheelReachesFarther()
{
    HandBench bench(HandTool::Bend);
    const Index twig = bench.twig();
    const QPointF at = bench.on(twig);
    pull(bench, at, {25.0, 10.0});
    for (int i = 0; i < 12; ++i)
        QVERIFY(bench.tools.wheel(bench.at(at), 120.0));
    QVERIFY(bench.hand.options().bendReach > 0.0);
    QVERIFY(bench.edits().size() > 1); // also what the limb grows on
    for (int i = 0; i < 30; ++i)
        QVERIFY(bench.tools.wheel(bench.at(at), -120.0));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.edits().front().from > 0.0);
    bench.release(at + QPointF(25.0, 10.0));
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

void TestBendTool::escapeTakesItBack()
{
    HandBench bench(HandTool::Bend);
    pull(bench, bench.on(bench.twig()), {25.0, 10.0});
    QVERIFY(!bench.edits().empty());
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestBendTool::aClickSelects()
{
    HandBench bench(HandTool::Bend);
    const Index twig = bench.twig();
    bench.click(bench.on(twig));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.selection().branches, std::vector<Index>{twig});
}

/// Of three bends and a cut none is without a place; the limb that is gone takes its bend along.
void TestBendTool::bendsStayAfterACut()
{
    HandBench bench(HandTool::Bend);
    std::vector<std::uint64_t> bent;
    for (int i = 0; i < 3; ++i) {
        const Index twig = bench.twig();
        const QPointF at = bench.on(twig);
        bent.push_back(bench.limb(twig).address);
        bench.drag(at, at + QPointF(12.0 + 6.0 * i, 8.0));
        bench.grow();
    }
    QCOMPARE(bench.edits().size(), std::size_t(3));
    bench.hand.setTool(HandTool::Cut);
    const Index twig = bench.twig();
    bench.click(bench.on(twig, 0.9));
    bench.grow();
    QCOMPARE(bench.edits().size(), std::size_t(4));
    for (const EditOutcome& outcome : *bench.document.result(1)->tree.edits)
        QCOMPARE(outcome.state, EditState::ByAddress);
}

RAMURE_SUITE(TestBendTool)

} // namespace tst_bend_tool

#include "tst_bend_tool.moc"
