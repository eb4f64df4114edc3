#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_rest_tool {

using namespace ramure;
using test::HandBench;

/// Tools that shape trees, where the timeline has moved them.
class TestRestTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void atRestPressesAreTheToolsOwn();
    void whatDoesNotShapeIsLeftAlone();
    void whatIsRefusedSelectsNothing_data();
    void whatIsRefusedSelectsNothing();
    void aPressGoesToRest_data();
    void aPressGoesToRest();
    void playingStops();
};

namespace {

struct Bench : HandBench
{
    static constexpr int frameAway = 40;
    Player player{&document};

    explicit Bench(HandTool tool)
        : HandBench(tool)
    {
        context.player = &player;
    }
    ~Bench() { player.pause(); }
    [[nodiscard]] bool isMoved() const
    {
        const NodeMotion* motion = player.motion()->of(1);
        return motion && motion->moves();
    }
    void away()
    {
        player.seek(frameAway);
        if (!player.waitForIdle(patienceMs) || !isMoved())
            qWarning("nothing moves");
    }
};

} // namespace

void TestRestTool::atRestPressesAreTheToolsOwn()
{
    Bench bench(HandTool::Remove);
    QVERIFY(!bench.says("Click: to frame"));
    bench.click(bench.on(bench.twig()));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.messages.isEmpty());
}

void TestRestTool::whatDoesNotShapeIsLeftAlone()
{
    Bench bench(HandTool::None);
    bench.away();
    bench.context.hoverNode = 1;
    bench.context.hoverBranch = 0;
    QVERIFY(!bench.says("Click: to frame"));
    bench.click(bench.on(0)); // selects
    QCOMPARE(bench.player.frame(), std::int64_t(Bench::frameAway));
    QVERIFY(bench.says("Click: to frame 0", {}, Qt::ControlModifier)); // that bends
    bench.hand.setTool(HandTool::Cut);
    bench.press(bench.on(0), Qt::LeftButton, Qt::AltModifier);
    bench.release(bench.on(0), Qt::LeftButton, Qt::AltModifier);
    QCOMPARE(bench.player.frame(), std::int64_t(Bench::frameAway));
}

void TestRestTool::whatIsRefusedSelectsNothing_data()
{
    QTest::addColumn<int>("tool");
    for (const HandToolRow& row : handTools())
        QTest::newRow(row.id) << int(row.tool);
}

/// Of a locked tree.
void TestRestTool::whatIsRefusedSelectsNothing()
{
    QFETCH(int, tool);
    Bench bench{HandTool(tool)};
    bench.select(1, {0});
    const QPointF at = bench.on(bench.twig());
    QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
    bench.drag(at, at + QPointF(60.0, 60.0));
    QVERIFY(!bench.answerBox);
    QVERIFY(bench.messages.size() == 1 && bench.messages.front().contains(QLatin1String("locked")));
    QVERIFY(bench.edits().empty() && !bench.tools.goesOn());
}

void TestRestTool::aPressGoesToRest_data()
{
    whatIsRefusedSelectsNothing_data();
}

void TestRestTool::aPressGoesToRest()
{
    QFETCH(int, tool);
    Bench bench{HandTool(tool)};
    bench.away();
    QVERIFY(bench.says("Click: to frame 0"));
    const QPointF at = bench.on(0);
    bench.drag(at, at + QPointF(60.0, 60.0));
    QCOMPARE(bench.player.frame(), std::int64_t(0));
    QCOMPARE(bench.messages.size(), 1);
    QVERIFY(bench.messages.front().contains(QLatin1String("frame 0")));
    QVERIFY(!bench.answerBox && bench.edits().empty());
    QVERIFY(bench.player.waitForIdle(Bench::patienceMs) && !bench.isMoved());
    QVERIFY(!bench.says("Click: to frame"));
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestRestTool::playingStops()
{
    Bench bench(HandTool::Cut);
    bench.player.play();
    QVERIFY(bench.says("Click: to frame 0"));
    bench.click(bench.on(0));
    QVERIFY(!bench.player.isPlaying());
    QCOMPARE(bench.player.frame(), std::int64_t(0));
    QVERIFY(bench.edits().empty());
}

RAMURE_SUITE(TestRestTool)

} // namespace tst_rest_tool

#include "tst_rest_tool.moc"
