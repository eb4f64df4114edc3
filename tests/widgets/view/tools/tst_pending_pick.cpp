#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include <QSignalSpy>

namespace tst_pending_pick {

using namespace ramure;

/// Clicks and boxes wait for what is picked in.
class TestPendingPick : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideEverythingNothingIsSelected();
    void aClickWaitsForWhatIsPickedIn();
    void aBoxIsAnsweredLater();
    void aMenuIsOfWhatIsClicked();
};

namespace {

/// Two boxes side by side.
struct Bench : test::ToolBench
{
    PendingPick& picks = tools.picks();

    Bench()
    {
        std::vector<Node> nodes(2);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i].id = NodeId(i + 1);
            nodes[i].kind = NodeKind::Primitive;
            nodes[i].name = i == 0 ? "left" : "right";
            nodes[i].params.primitive.shape = PrimitiveShape::Box;
            nodes[i].params.tree.translation = {4.0 * double(i), 0.0, 0.0};
        }
        open(Scene::fromNodes(nodes).value_or(Scene()));
    }
    [[nodiscard]] QPointF on(NodeId node) const { return pixelOf({4.0 * double(node - 1), 0.0, 0.0}); }
    [[nodiscard]] const std::vector<NodeId>& selected() const { return document.selection().nodes; }
};

} // namespace

void TestPendingPick::besideEverythingNothingIsSelected()
{
    Bench bench;
    QSignalSpy missed(&bench.picks, &PendingPick::missed);
    bench.picks.click({2.0, 2.0}, false);
    QVERIFY(!bench.picks.isPending());
    QVERIFY(bench.selected().empty());
    QCOMPARE(missed.count(), 1);
}

void TestPendingPick::aClickWaitsForWhatIsPickedIn()
{
    Bench bench;
    bench.stale = true;
    bench.picks.click(bench.on(2), false);
    QVERIFY(bench.picks.isPending() && bench.selected().empty());
    bench.stale = false;
    bench.ready = false;
    bench.picks.tryAgain();
    QVERIFY(bench.picks.isPending());
    bench.ready = true;
    bench.picks.tryAgain();
    QVERIFY(!bench.picks.isPending());
    QCOMPARE(bench.selected(), std::vector<NodeId>{2});
    bench.ready = false;
    bench.picks.click(bench.on(1), false);
    bench.press({2.0, 2.0}); // the hand wants something else now
    bench.ready = true;
    bench.picks.tryAgain();
    QCOMPARE(bench.selected(), std::vector<NodeId>{2});
}

void TestPendingPick::aBoxIsAnsweredLater()
{
    Bench bench;
    bench.picks.box({0.0, 0.0}, {800.0, 600.0}, false);
    QVERIFY(bench.picks.isPending() && bench.selected().empty());
    const auto answer = bench.answerBox;
    bench.picks.forget();
    answer({{2, {0}}}); // nobody asks any more
    QVERIFY(bench.selected().empty());
    bench.picks.box({0.0, 0.0}, {800.0, 600.0}, false);
    bench.answerBox({{1, {0}}, {2, {0}}});
    QVERIFY(!bench.picks.isPending());
    QCOMPARE(bench.selected().size(), std::size_t(2));
}

void TestPendingPick::aMenuIsOfWhatIsClicked()
{
    Bench bench;
    QSignalSpy menu(&bench.picks, &PendingPick::menuWanted);
    bench.picks.menu(bench.on(2));
    QCOMPARE(menu.count(), 1);
    QCOMPARE(menu.last()[1].value<NodeId>(), NodeId(2));
    QCOMPARE(bench.selected(), std::vector<NodeId>{2});
    bench.picks.menu({2.0, 2.0});
    QCOMPARE(menu.last()[1].value<NodeId>(), noNode);
    QCOMPARE(bench.selected(), std::vector<NodeId>{2}); // beside it nothing changes
}

RAMURE_SUITE(TestPendingPick)

} // namespace tst_pending_pick

#include "tst_pending_pick.moc"
