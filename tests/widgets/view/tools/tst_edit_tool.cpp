#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include "widgets/view/tools/hand/hand_edit.h"

namespace tst_edit_tool {

using namespace ramure;
using test::HandBench;

/// What the tools that shape trees have in common: they act on what the last picture shows.
class TestEditTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideTheTreeNothingIsAimedAt();
    void thinLimbsAreHitFromBeside();
    void everyToolAimsWhileNothingIsReadyToPickIn();
    void aStrokeBeginsOnTheBranchThatIsSeen();
    void whatIsGoneByNowIsRefused();
};

namespace {

/// A branch grows low on the trunk: branches above it get other numbers. The picture stays that of before.
void growUnseen(HandBench& bench)
{
    auto gesture = HandEdit::begin(bench.document, 1);
    TreeEdit drawn;
    drawn.operation = EditOperation::Draw;
    drawn.target.address = bench.limb(0).address;
    drawn.at = 0.3;
    drawn.points = {{{0.2, 0.0, 0.0}, 0.0}, {{0.4, 0.1, 0.0}, 0.0}};
    QVERIFY((*gesture)->add(drawn, false));
    QVERIFY((*gesture)->show());
    (*gesture)->keep();
    QVERIFY(bench.recompute.waitForFull(HandBench::patienceMs));
    bench.stale = true;
}

} // namespace

void TestEditTool::besideTheTreeNothingIsAimedAt()
{
    for (const bool ready : {true, false}) {
        HandBench bench(HandTool::Remove);
        bench.ready = ready;
        bench.tools.hover(bench.at({2.0, 2.0}));
        QVERIFY(bench.marked.empty());
    }
}

/// Much thinner on the screen than a pixel: from any side, but not from afar.
void TestEditTool::thinLimbsAreHitFromBeside()
{
    HandBench bench(HandTool::Remove);
    const Index twig = bench.twig();
    bench.camera.distance *= 3.0;
    const double mostRadius = bench.camera.metresPerPixel(bench.skeleton().p0[twig], bench.size.y);
    QVERIFY2(bench.skeleton().a0[twig] < mostRadius, qPrintable(QString::number(mostRadius)));
    const QPointF middle = bench.on(twig, 0.6), way = bench.on(twig, 1.0) - middle;
    const QPointF across = QPointF(-way.y(), way.x()) / std::hypot(way.x(), way.y());
    for (const double aside : {-5.0, -3.7, -2.2, 0.0, 1.6, 2.9, 4.4, 5.5}) {
        bench.tools.hover(bench.at(middle + aside * across));
        QVERIFY2(!bench.marked.empty(), qPrintable(QString::number(aside)));
    }
    bench.tools.hover(bench.at(middle));
    QVERIFY(std::ranges::count(bench.marked, twig) == 1);
    bench.tools.hover(bench.at({2.0, 2.0}));
    QVERIFY(bench.marked.empty());
}

void TestEditTool::everyToolAimsWhileNothingIsReadyToPickIn()
{
    for (const HandToolRow& row : handTools()) {
        std::vector<std::vector<Index>> marked;
        for (const bool ready : {true, false}) {
            HandBench bench(row.tool);
            const QPointF twig = bench.on(bench.twig(), 0.5);
            bench.ready = ready;
            bench.stale = !ready;
            bench.tools.hover(bench.at(twig));
            marked.push_back(bench.marked);
        }
        QVERIFY2(marked[0] == marked[1], row.id);
    }
}

void TestEditTool::aStrokeBeginsOnTheBranchThatIsSeen()
{
    for (const bool ready : {true, false}) {
        HandBench bench(HandTool::Draw);
        const Index twig = bench.twig();
        const auto seen = LimbFinder().onBranch(bench.document, 1, twig, 0.5);
        const QPointF from = bench.on(twig, 0.5);
        growUnseen(bench);
        bench.ready = ready;
        bench.press(from);
        for (int i = 1; i <= 10; ++i)
            bench.move(from + i * QPointF(6.0, -9.0));
        bench.release(from + QPointF(60.0, -90.0));
        QVERIFY2(bench.edits().size() == 2, qPrintable(bench.messages.join(u'\n')));
        const TreeEdit& drawn = bench.edits().back();
        QCOMPARE(drawn.operation, EditOperation::Draw);
        QVERIFY(seen);
        QCOMPARE(drawn.target.address, seen->address);
        QVERIFY(std::abs(drawn.at - seen->share) < 0.1);
    }
}

void TestEditTool::whatIsGoneByNowIsRefused()
{
    HandBench bench(HandTool::Cut);
    const Index twig = bench.twig();
    const QPointF at = bench.on(twig, 0.5);
    QVERIFY(removeLimbs(bench.document, {bench.limb(twig)}, true));
    QVERIFY(bench.recompute.waitForFull(HandBench::patienceMs));
    bench.stale = true;
    bench.click(at);
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(!bench.messages.isEmpty());
    QCOMPARE(bench.document.undoStack()->count(), 1);
}

RAMURE_SUITE(TestEditTool)

} // namespace tst_edit_tool

#include "tst_edit_tool.moc"
