#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include "widgets/view/tools/hand/hand_edit.h"
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
    void aClickIsOfThePictureThatIsSeen();
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
    bench.ready = false;
    bench.picks.click(bench.on(2), false);
    QVERIFY(bench.picks.isPending() && bench.selected().empty());
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

/// While another tree is on its way, branches are picked in the one that is shown, and found again in it.
void TestPendingPick::aClickIsOfThePictureThatIsSeen()
{
    test::HandBench bench(HandTool::None);
    const Index twig = bench.twig();
    const QPointF at = bench.on(twig, 0.5);
    const LimbHit clicked = bench.limb(twig);
    auto gesture = HandEdit::begin(bench.document, 1);
    TreeEdit drawn;
    drawn.operation = EditOperation::Draw;
    drawn.target.address = bench.limb(0).address;
    drawn.at = 0.3; // where it stands a piece is split: those above get other numbers
    drawn.points = {{{0.2, 0.0, 0.0}, 0.0}, {{0.4, 0.1, 0.0}, 0.0}};
    QVERIFY((*gesture)->add(drawn, false));
    QVERIFY((*gesture)->show());
    (*gesture)->keep();
    QVERIFY(bench.recompute.waitForFull(test::HandBench::patienceMs)); // and not shown
    bench.stale = true;
    bench.tools.picks().click(at, false);
    QVERIFY(!bench.tools.picks().isPending());
    const Selection& selection = bench.document.selection();
    QCOMPARE(selection.branchNode, NodeId(1));
    const auto now = LimbFinder().startOf(bench.document, 1, selection.activeBranch);
    QVERIFY(now);
    QCOMPARE(now->address, clicked.address);
    QVERIFY(glm::length(now->seen - clicked.seen) < 1e-9);
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
