#include "core/presets/presets.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"

namespace tst_pull_tool {

using namespace ramure;

/// The hand on a branch of a tree that moves.
class TestPullTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void atRestNothingIsPulled();
    void aBranchIsPulledUntilPlayingStops();
};

namespace {

struct Bench : test::ToolBench
{
    Recompute recompute{&document};
    Player player{&document};

    Bench()
    {
        recompute.setRest(0);
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = "tree";
        node.params = presetParams("TinyTree").value_or(NodeParams{});
        open(Scene::fromNodes({node}).value_or(Scene()));
        if (!recompute.waitForFull(test::patience(20'000)))
            qWarning("no result");
        show();
        context.player = &player;
        player.setPace(PlayPace::EveryFrame);
        QObject::connect(&player, &Player::playingChanged, &document, [this](bool playing) {
            if (!playing)
                tools.playingStopped();
        });
    }
    ~Bench() { player.pause(); }
    [[nodiscard]] QPointF onTrunk() const
    {
        const Skeleton& skeleton = document.result(1)->tree.simplified->skeleton;
        return pixelOf(0.5 * (skeleton.p0[0] + skeleton.p1[0]));
    }
};

} // namespace

void TestPullTool::atRestNothingIsPulled()
{
    Bench bench;
    QVERIFY(!bench.says("pull"));
    bench.press(bench.onTrunk());
    QVERIFY(!bench.tools.goesOn());
    QVERIFY(!bench.tools.doubleClick(bench.at(bench.onTrunk(), Qt::LeftButton)));
}

void TestPullTool::aBranchIsPulledUntilPlayingStops()
{
    Bench bench;
    bench.player.play();
    QTRY_VERIFY_WITH_TIMEOUT(bench.player.motion()->of(1), test::patience(20'000));
    QVERIFY(bench.says("pull the branch") && !bench.says("bend"));
    for (const Qt::KeyboardModifiers held : {Qt::NoModifier, Qt::ControlModifier}) {
        bench.press(bench.onTrunk(), Qt::LeftButton, held);
        QVERIFY(bench.tools.goesOn() && bench.says("swings back"));
        bench.move(bench.onTrunk() + QPointF(40.0, 0.0), held);
        bench.release(bench.onTrunk(), Qt::LeftButton, held);
        QVERIFY(!bench.tools.current());
    }
    bench.press(bench.onTrunk());
    QVERIFY(bench.key(Qt::Key_Escape));
    bench.press(bench.onTrunk());
    QVERIFY(bench.tools.goesOn());
    bench.player.pause();
    QVERIFY(!bench.tools.current());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

RAMURE_SUITE(TestPullTool)

} // namespace tst_pull_tool

#include "tst_pull_tool.moc"
