#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include <QImage>
#include <QPainter>

namespace tst_click_tools {

using namespace ramure;
using test::HandBench;

/// Cut, remove, keep only, leaves: by a click on a branch.
class TestClickTools : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutAToolNothingIsCut();
    void besideTheTreeTheyLeaveThePress();
    void lockedTreesStay();
    void modifiersAreOfOthers();
    void theTrunkCannotBeRemoved();
    void aClickCuts();
    void whatIsCutMayFall();
    void theHandSeesWhatGoes();
    void escapeBeforeTheReleaseCutsNothing();
    void aClickThatFindsNothingIsKeptUntilTheTreeIsThere();
    void aLimbIsRemoved();
    void ofSeveralSelectedAllGo();
    void aGrowingTreeAnswers();
    void onlyTheLimbIsKept();
    void leavesGoAndComeBack();
    void theWheelTakesTheLimbThatATwigGrowsOn();
    void stepsAreUndone();
    void limbsThatWereChangedAreMarked();
};

void TestClickTools::withoutAToolNothingIsCut()
{
    HandBench bench(HandTool::None);
    bench.click(bench.on(bench.twig()));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.selection().branches.size(), std::size_t(1));
    QCOMPARE(bench.tools.cursor().shape(), Qt::ArrowCursor);
}

void TestClickTools::besideTheTreeTheyLeaveThePress()
{
    HandBench bench(HandTool::Cut);
    bench.select(1, {0});
    bench.click({2.0, 2.0});
    QVERIFY(bench.edits().empty());
    QVERIFY(bench.document.selection().branches.empty()); // as without a tool
    QCOMPARE(bench.messages.size(), 1);
    QVERIFY(bench.messages.front().contains(QStringLiteral("No limb is there")));
}

void TestClickTools::lockedTreesStay()
{
    HandBench bench(HandTool::Remove);
    const QPointF at = bench.on(bench.twig());
    QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
    bench.click(at);
    QVERIFY(bench.edits().empty());
}

void TestClickTools::modifiersAreOfOthers()
{
    HandBench bench(HandTool::Cut);
    const QPointF at = bench.on(bench.twig());
    bench.click(at, Qt::ShiftModifier);
    QCOMPARE(bench.document.selection().branches.size(), std::size_t(1));
    const Camera before = bench.camera;
    bench.drag(at, at + QPointF(60.0, 10.0), Qt::LeftButton, Qt::AltModifier);
    QVERIFY(bench.camera != before);
    QVERIFY(bench.edits().empty());
}

void TestClickTools::theTrunkCannotBeRemoved()
{
    HandBench bench(HandTool::Remove);
    const QPointF foot = bench.on(0, 0.3);
    bench.click(foot);
    if (bench.edits().empty())
        QVERIFY(!bench.messages.empty() && !bench.messages.back().isEmpty());
    else // then there is nothing left, and undo brings it back
        bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestClickTools::aClickCuts()
{
    HandBench bench(HandTool::Cut);
    const Index twig = bench.twig();
    QVERIFY(twig != noIndex);
    const LimbHit limb = bench.limb(twig);
    const Index before = bench.skeleton().size();
    bench.click(bench.on(twig, 0.5));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().operation, EditOperation::Cut);
    QCOMPARE(bench.edits().front().target.address, limb.address);
    QVERIFY(bench.edits().front().at > limb.share && bench.edits().front().at < 1.0);
    QVERIFY(!bench.edits().front().target.place.way.empty());
    bench.grow();
    QVERIFY(bench.skeleton().size() <= before);
    QVERIFY(bench.messages.empty());
}

void TestClickTools::whatIsCutMayFall()
{
    HandBench bench(HandTool::Cut);
    HandOptions options = bench.hand.options();
    options.falls = true;
    options.fallsAfter = 1.5;
    bench.hand.setOptions(options);
    bench.click(bench.on(bench.twig(), 0.5));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().operation, EditOperation::Cut);
    QVERIFY(bench.edits().front().falls);
    QCOMPARE(bench.edits().front().seconds, 1.5);
    QVERIFY(bench.messages.join(QString()).contains(QLatin1String("falls")));
}

void TestClickTools::theHandSeesWhatGoes()
{
    HandBench bench(HandTool::Cut);
    bench.tools.hover(bench.at(bench.on(0, 0.5)));
    QCOMPARE(bench.marked, bench.all());
    QVERIFY(bench.says("cut here", bench.on(0, 0.5)));
    QVERIFY(bench.tools.cursor().shape() != Qt::ArrowCursor);
    bench.tools.hover(bench.at({2.0, 2.0}));
    QVERIFY(bench.marked.empty());
    bench.tools.hover(bench.at(bench.on(0, 0.5)));
    bench.hand.setTool(HandTool::None);
    QVERIFY(bench.marked.empty());
}

void TestClickTools::escapeBeforeTheReleaseCutsNothing()
{
    HandBench bench(HandTool::Cut);
    const QPointF at = bench.on(bench.twig());
    bench.press(at);
    QVERIFY(bench.says("Esc"));
    QVERIFY(bench.key(Qt::Key_Escape));
    bench.release(at);
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestClickTools::aClickThatFindsNothingIsKeptUntilTheTreeIsThere()
{
    HandBench bench(HandTool::Cut);
    const QPointF at = bench.on(bench.twig(), 0.5);
    bench.ready = false;
    bench.click({2.0, 2.0}); // a leaf may be there, for all that skeletons say
    QVERIFY(bench.tools.current() == nullptr && bench.document.selection().nodes.empty());
    bench.ready = true;
    bench.tools.sceneReady();
    QVERIFY(bench.edits().empty());
    bench.ready = false;
    bench.click(at);
    QCOMPARE(bench.edits().size(), std::size_t(1)); // a branch is found without it
    bench.ready = true;
    bench.tools.sceneReady();
    QCOMPARE(bench.edits().size(), std::size_t(1));
}

void TestClickTools::aLimbIsRemoved()
{
    HandBench bench(HandTool::Remove);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    bench.tools.hover(bench.at(bench.on(twig)));
    const Index before = bench.skeleton().size();
    const std::size_t goes = bench.marked.size();
    bench.click(bench.on(twig));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().operation, EditOperation::Remove);
    bench.grow();
    QVERIFY(LimbFinder().limb(bench.document, 1, limb.address).empty());
    QVERIFY(bench.skeleton().size() <= before - Index(goes));
}

void TestClickTools::ofSeveralSelectedAllGo()
{
    HandBench bench(HandTool::Remove);
    const ChildLists children = childLists(bench.skeleton());
    std::vector<Index> tips;
    for (Index b = 1; b < bench.skeleton().size(); ++b)
        if (children.count(b) == 0 && bench.skeleton().level[b] > 0)
            tips.push_back(b);
    QVERIFY(tips.size() > 1);
    bench.select(1, tips);
    bench.click(bench.on(bench.twig()));
    QVERIFY(bench.edits().size() > 1);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    for (std::size_t i = 0; i < bench.edits().size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(bench.edits()[i].target.address != bench.edits()[j].target.address);
}

void TestClickTools::aGrowingTreeAnswers()
{
    HandBench bench(HandTool::Remove, 1, "OrchardApple");
    QVERIFY(edit::setParam(bench.document, {1}, *findParam("growth.age"), 9.5));
    QVERIFY(edit::setParam(bench.document, {1}, *findParam("foliage.leavesDensity"), std::int64_t(0)));
    bench.grow();
    const int steps = bench.document.undoStack()->count();
    const Index twig = bench.twig();
    QVERIFY(twig != noIndex);
    bench.click(bench.on(twig));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().year, 9.0);
    QCOMPARE(bench.document.undoStack()->count(), steps + 1);
    bench.grow();
    QCOMPARE(bench.document.result(1)->tree.edits->front().state, EditState::ByAddress);
    // What falls hangs on its stump until then.
    bench.hand.setTool(HandTool::Cut);
    HandOptions options = bench.hand.options();
    options.falls = true;
    bench.hand.setOptions(options);
    bench.click(bench.on(bench.twig()));
    QCOMPARE(bench.edits().size(), std::size_t(2));
    QCOMPARE(bench.edits().back().year, 0.0);
}

void TestClickTools::onlyTheLimbIsKept()
{
    HandBench bench(HandTool::Keep);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    bench.click(bench.on(twig));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().operation, EditOperation::Keep);
    const Index before = bench.skeleton().size();
    bench.grow();
    QVERIFY(bench.skeleton().size() < before);
    QVERIFY(!LimbFinder().limb(bench.document, 1, limb.address).empty());
}

void TestClickTools::leavesGoAndComeBack()
{
    HandBench bench(HandTool::Leaves);
    const Index twig = bench.twig();
    bench.click(bench.on(twig));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(!bench.edits().back().shown);
    bench.grow();
    bench.click(bench.on(twig));
    QVERIFY(bench.edits().back().shown);
    bench.grow();
    bench.click(bench.on(twig));
    QVERIFY(!bench.edits().back().shown);
}

/// Of a leafy crown the smallest twig is under the cursor, and the limb is meant.
void TestClickTools::theWheelTakesTheLimbThatATwigGrowsOn()
{
    HandBench bench(HandTool::Leaves, 1, "SmallTree");
    const TreeAxes& axes = *bench.context.limbs.axes(bench.document, 1);
    const Index twig = bench.twig(1, 2);
    QVERIFY(twig != noIndex);
    const LimbHit own = bench.limb(twig);
    Index limb = own.axis;
    while (axes.axes[limb].order > 1)
        limb = axes.axes[limb].parent;
    const QPointF at = bench.on(twig);
    bench.tools.hover(bench.at(at));
    const std::size_t small = bench.marked.size();
    QVERIFY(bench.says("Shift + wheel: the limb", at));
    const ToolPoint shifted = bench.at(at, Qt::NoButton, Qt::ShiftModifier);
    for (Index order = axes.axes[own.axis].order; order > 0; --order)
        QVERIFY(bench.tools.wheel(shifted, 120.0)); // the last: no further than the limbs of the trunk
    QCOMPARE(bench.hand.options().limbOrder, 1);
    QVERIFY(bench.marked.size() > small);
    bench.click(at);
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().target.address, axes.axes[limb].address);
    bench.document.undo();
    bench.grow();
    for (Index order = axes.axes[own.axis].order; order > 1; --order)
        QVERIFY(bench.tools.wheel(shifted, -120.0));
    QCOMPARE(bench.hand.options().limbOrder, 0);
    bench.click(at);
    QCOMPARE(bench.edits().front().target.address, own.address);
}

void TestClickTools::stepsAreUndone()
{
    HandBench bench(HandTool::Cut);
    const NodeParams before = bench.document.scene().find(1)->params;
    const Skeleton skeleton = bench.skeleton();
    for (int i = 0; i < 3; ++i) {
        const Index twig = bench.twig();
        if (twig == noIndex)
            break;
        bench.click(bench.on(twig, 0.6));
        bench.grow();
    }
    QCOMPARE(bench.document.undoStack()->count(), 3);
    while (bench.document.undoStack()->canUndo())
        bench.document.undo();
    QVERIFY(bench.document.scene().find(1)->params == before);
    bench.grow();
    QVERIFY(bench.skeleton() == skeleton);
}

void TestClickTools::limbsThatWereChangedAreMarked()
{
    HandBench bench(HandTool::Cut);
    const auto painted = [&bench] {
        QImage picture(800, 600, QImage::Format_RGB32);
        picture.fill(Qt::black);
        QPainter painter(&picture);
        bench.tools.paint(painter, bench.view());
        painter.end();
        return picture;
    };
    const QImage before = painted();
    bench.click(bench.on(bench.twig()));
    bench.grow();
    QVERIFY(painted() != before);
    bench.hand.setTool(HandTool::None);
    QVERIFY(painted() == before);
}

RAMURE_SUITE(TestClickTools)

} // namespace tst_click_tools

#include "tst_click_tools.moc"
