#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_select_tool {

using namespace ramure;

/// Clicks and boxes with the left button.
class TestSelectTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void otherButtonsSelectNothing();
    void aClickSelectsWithShiftItAdds();
    void aDragSelectsByABox();
    void escapeGivesTheBoxUp();
    void theHintSaysWhatIsUnderTheCursor();
    void ofABranchEscapeLeavesTheTree();
};

namespace {

/// Two boxes side by side.
struct Bench : test::ToolBench
{
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
    void click(QPointF at, Qt::KeyboardModifiers held = {})
    {
        press(at, Qt::LeftButton, held);
        move(at + QPointF(1.0, 0.0), held); // a hand is never still
        release(at, Qt::LeftButton, held);
    }
};

} // namespace

void TestSelectTool::otherButtonsSelectNothing()
{
    Bench bench;
    bench.style = NavigationStyle::Maya;
    bench.drag(bench.on(1), bench.on(1), Qt::MiddleButton);
    QVERIFY(bench.selected().empty());
}

void TestSelectTool::aClickSelectsWithShiftItAdds()
{
    Bench bench;
    bench.click(bench.on(1));
    QCOMPARE(bench.selected(), std::vector<NodeId>{1});
    bench.click(bench.on(2), Qt::ShiftModifier);
    QCOMPARE(bench.selected(), (std::vector<NodeId>{1, 2}));
    bench.press(bench.on(1));
    QVERIFY(bench.tools.current() && !bench.tools.goesOn()); // it may become a click
    QVERIFY(!bench.key(Qt::Key_Escape));
}

void TestSelectTool::aDragSelectsByABox()
{
    Bench bench;
    const Camera before = bench.camera;
    bench.drag({1.0, 1.0}, {700.0, 599.0});
    QVERIFY(bench.selected().empty());
    bench.answerBox({{1, {0}}});
    QCOMPARE(bench.selected(), std::vector<NodeId>{1});
    QCOMPARE(bench.camera, before);
    bench.press({1.0, 1.0});
    bench.move({300.0, 300.0});
    QVERIFY(bench.tools.goesOn());
    QVERIFY(bench.says("in the box"));
    QImage image(800, 600, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    bench.tools.paint(painter, bench.view());
    painter.end();
    QVERIFY(image.pixelColor(150, 150).alpha() > 0);
    QCOMPARE(image.pixelColor(400, 400).alpha(), 0);
}

void TestSelectTool::escapeGivesTheBoxUp()
{
    Bench bench;
    bench.click(bench.on(1));
    bench.press({1.0, 1.0});
    bench.move({799.0, 599.0});
    QVERIFY(bench.key(Qt::Key_Escape));
    bench.release({799.0, 599.0});
    QVERIFY(!bench.answerBox && !bench.tools.picks().isPending());
    QCOMPARE(bench.selected(), std::vector<NodeId>{1}); // Esc cleared no selection
}

void TestSelectTool::theHintSaysWhatIsUnderTheCursor()
{
    Bench bench;
    QVERIFY(bench.says("select nothing"));
    QVERIFY(bench.says("Shift: drag adds a box", {}, Qt::ShiftModifier));
    bench.context.hoverNode = 1;
    QVERIFY(bench.says("Click: select") && !bench.says("nothing"));
    QVERIFY(bench.says("adds or takes away", {}, Qt::ShiftModifier));
    bench.context.hoverBranch = 0;
    QVERIFY(bench.hint().startsWith(
        QStringLiteral("Click: limb · again: this branch of it · Ctrl + drag: bend the limb")));
    const QString rest = bench.hint();
    bench.press({1.0, 1.0});
    QCOMPARE(bench.hint(), rest); // a press is no box yet
}

void TestSelectTool::ofABranchEscapeLeavesTheTree()
{
    test::HandBench bench(HandTool::None);
    QVERIFY(!bench.says("Esc"));
    const Index twig = bench.twig();
    bench.click(bench.on(twig));
    QCOMPARE(bench.document.selection().branches, LimbFinder().limbOf(bench.document, 1, twig));
    QVERIFY(bench.says("Esc: only the tree"));
}

RAMURE_SUITE(TestSelectTool)

} // namespace tst_select_tool

#include "tst_select_tool.moc"
