#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_root_tool {

using namespace ramure;
using test::HandBench;

/// The foot of a tree goes over the ground, and flares.
class TestRootTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideTheTreeNothingHappens();
    void theFootFollowsTheHand();
    void theFootFlares();
    void theFlareIsTyped();
    void theSameFootGoesOn();
    void escapeTakesItBack();
};

void TestRootTool::besideTheTreeNothingHappens()
{
    HandBench bench(HandTool::Root);
    bench.drag({2.0, 2.0}, {60.0, 2.0});
    QVERIFY(bench.edits().empty());
}

void TestRootTool::theFootFollowsTheHand()
{
    HandBench bench(HandTool::Root);
    bench.camera.pitchRad = 0.4;
    const Index twig = bench.twig(); // any part of the tree
    const glm::dvec3 foot = bench.skeleton().p0[0], tip = bench.skeleton().p1[twig];
    const glm::dvec3 wanted = foot + glm::dvec3(0.3, 0.0, -0.4);
    const QPointF at = bench.on(twig), way = bench.pixelOf(wanted) - bench.pixelOf(foot);
    bench.press(at);
    bench.move(at + way);
    QVERIFY(bench.says("flare"));
    bench.release(at + way);
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Root);
    QVERIFY(glm::length(bench.edits().front().offset - (wanted - foot)) < 1e-6);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    QVERIFY(glm::length(bench.skeleton().p0[0] - wanted) < 1e-6);
    QVERIFY(glm::length(bench.skeleton().p1[twig] - tip - (wanted - foot)) < 1e-6);
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestRootTool::theFootFlares()
{
    HandBench bench(HandTool::Root);
    const QPointF at = bench.on(0);
    const double before = bench.skeleton().a0[0];
    bench.press(at);
    bench.move(at + QPointF(140.0, 0.0), Qt::ControlModifier);
    QVERIFY(bench.tools.wheel(bench.at(at), 120.0));
    bench.release(at + QPointF(140.0, 0.0));
    QVERIFY(std::abs(bench.edits().front().factor - 2.1) < 1e-6);
    QCOMPARE(bench.edits().front().offset, glm::dvec3(0.0));
    bench.grow();
    QVERIFY(std::abs(bench.skeleton().a0[0] / before - 2.1) < 1e-6);
}

void TestRootTool::theFlareIsTyped()
{
    HandBench bench(HandTool::Root);
    bench.click(bench.on(0));
    bench.key(Qt::Key_3, QStringLiteral("3"));
    bench.key(Qt::Key_Return);
    QCOMPARE(bench.edits().front().factor, 3.0);
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

void TestRootTool::theSameFootGoesOn()
{
    HandBench bench(HandTool::Root);
    bench.camera.pitchRad = 0.4;
    for (const double x : {0.2, 0.4}) {
        const glm::dvec3 foot = bench.skeleton().p0[0];
        const QPointF way = bench.pixelOf({x, 0.0, 0.0}) - bench.pixelOf(foot), at = bench.on(0);
        bench.drag(at, at + way);
        bench.grow();
        QCOMPARE(bench.edits().size(), std::size_t(1));
        QVERIFY(glm::length(bench.skeleton().p0[0] - glm::dvec3(x, 0.0, 0.0)) < 1e-6);
    }
}

void TestRootTool::escapeTakesItBack()
{
    HandBench bench(HandTool::Root);
    bench.camera.pitchRad = 0.4;
    const QPointF at = bench.on(0);
    bench.press(at);
    bench.move(at + QPointF(60.0, 10.0));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

RAMURE_SUITE(TestRootTool)

} // namespace tst_root_tool

#include "tst_root_tool.moc"
