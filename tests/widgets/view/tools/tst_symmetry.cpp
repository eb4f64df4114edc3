#include "tests/support/hand_bench.h"
#include "tests/support/shaped_tree.h"
#include "tests/support/suite.h"
#include "widgets/view/tools/hand/symmetry.h"

namespace tst_symmetry {

using namespace ramure;
using test::HandBench;

namespace {

/// A trunk with four limbs of one kind around it, and one above them that has no other like it.
NodeParams evenTree()
{
    NodeParams params = test::plainTree();
    params.grammar.dialect = GrammarDialect::Parametric;
    params.grammar.axiom =
        "!(0.4)F(1)[&(60)!(0.2)F(1)F(1)]/(90)[&(60)!(0.2)F(1)F(1)]/(90)[&(60)!(0.2)F(1)F(1)]/"
        "(90)[&(60)!(0.2)F(1)F(1)]F(1)[&(80)!(0.1)F(0.5)]F(1)";
    params.foliage.leavesDensity = 0;
    params.foliage.applesProbability = 0.0;
    return params;
}

struct EvenBench : HandBench
{
    explicit EvenBench(HandTool tool, int copies, bool mirrored)
        : HandBench(tool)
    {
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = "even";
        node.params = evenTree();
        open(Scene::fromNodes({node}).value_or(Scene()));
        grow();
        HandOptions options;
        options.symmetryCopies = copies;
        options.symmetryMirrored = mirrored;
        options.drawSmooth = 0.0;
        hand.setOptions(options);
    }
    const TreeAxes& axes() { return *context.limbs.axes(document, 1); }
    /// The first branch of an axis, half way up.
    QPointF onAxis(Index axis)
    {
        const Index branch = context.limbs.limb(document, 1, axes().axes[axis].address).front();
        return on(branch, 0.5);
    }
    /// A limb of the even four that is hit where onAxis says.
    Index seenLimb()
    {
        for (Index axis = 1; axis <= 4; ++axis) {
            const QPointF at = onAxis(axis);
            const auto hit = latestPickScene()->pick(view(), {at.x(), at.y()});
            const auto limb = hit ? context.limbs.at(document, *hit) : std::nullopt;
            if (limb && limb->axis == axis)
                return axis;
        }
        return noIndex;
    }
};

} // namespace

/// What is done to a limb is done to those around the trunk.
class TestSymmetry : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutItNothingHasATwin();
    void turnedAndMirroredLimbsAreFound();
    void whereNoLimbIsLikeItNothingHappens();
    void everyToolActsOnAll_data();
    void everyToolActsOnAll();
    void bentLimbsStayEven();
};

void TestSymmetry::withoutItNothingHasATwin()
{
    Symmetry none;
    QVERIFY(!none.isOn() && none.twins(0).empty());
    EvenBench bench(HandTool::Cut, 1, false);
    const Skeleton& drawn = *bench.document.result(1)->tree.skeleton;
    Symmetry off(bench.axes(), drawn, bench.hand.options(), {0.0, 0.0, -1.0});
    QVERIFY(off.twins(1).empty());
    Symmetry on(bench.axes(), drawn, EvenBench(HandTool::Cut, 4, false).hand.options(), {0.0, 0.0, -1.0});
    QVERIFY(on.twins(noIndex).empty());
    QVERIFY(on.twins(0).empty()); // the trunk is its own
    QCOMPARE(on.missing(), 0);
}

void TestSymmetry::turnedAndMirroredLimbsAreFound()
{
    EvenBench bench(HandTool::Cut, 4, false);
    const Skeleton& drawn = *bench.document.result(1)->tree.skeleton;
    QCOMPARE(bench.axes().axes.size(), std::size_t{6});
    Symmetry around(bench.axes(), drawn, bench.hand.options(), {0.0, 0.0, -1.0});
    for (Index axis = 1; axis <= 4; ++axis) {
        const std::vector<LimbTwin> twins = around.twins(axis);
        QCOMPARE(twins.size(), std::size_t{3});
        for (const LimbTwin& twin : twins) {
            const glm::dvec3 tip = twin.map.point(drawn.p1[bench.axes().nodesOf(axis).back()]);
            QVERIFY(glm::length(tip - drawn.p1[bench.axes().nodesOf(twin.axis).back()]) < 0.5);
        }
    }
    HandOptions options;
    options.symmetryMirrored = true;
    // The mirror stands between two limbs, and across: each has one on the other side, or is its own.
    Symmetry mirrored(bench.axes(), drawn, options, {1.0, 0.0, -1.0});
    std::size_t all = 0;
    for (Index axis = 1; axis <= 4; ++axis)
        all += mirrored.twins(axis).size();
    QVERIFY(all == 4 || all == 2);
    QCOMPARE(mirrored.missing(), 0);
}

void TestSymmetry::whereNoLimbIsLikeItNothingHappens()
{
    EvenBench bench(HandTool::Remove, 4, false);
    const Skeleton& drawn = *bench.document.result(1)->tree.skeleton;
    Symmetry around(bench.axes(), drawn, bench.hand.options(), {0.0, 0.0, -1.0});
    QVERIFY(around.twins(5).empty());
    QVERIFY(around.missing() > 0);
    bench.click(bench.onAxis(5));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.messages.join(u' ').contains(QLatin1String("no limb is like it")));
}

void TestSymmetry::everyToolActsOnAll_data()
{
    QTest::addColumn<HandTool>("tool");
    QTest::newRow("cut") << HandTool::Cut;
    QTest::newRow("remove") << HandTool::Remove;
    QTest::newRow("length") << HandTool::Length;
    QTest::newRow("thickness") << HandTool::Thickness;
    QTest::newRow("taper") << HandTool::Taper;
    QTest::newRow("curl") << HandTool::Curl;
    QTest::newRow("move") << HandTool::Move;
    QTest::newRow("extend") << HandTool::Extend;
    QTest::newRow("redraw") << HandTool::Redraw;
}

void TestSymmetry::everyToolActsOnAll()
{
    QFETCH(HandTool, tool);
    EvenBench bench(tool, 4, false);
    const Index limb = bench.seenLimb();
    QVERIFY(limb != noIndex);
    const QPointF at = bench.onAxis(limb);
    const bool clicks = tool == HandTool::Cut || tool == HandTool::Remove;
    clicks ? bench.click(at) : bench.drag(at, at + QPointF(60.0, -50.0));
    QVERIFY2(bench.edits().size() == 4, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    for (const EditOutcome& outcome : *bench.document.result(1)->tree.edits)
        QCOMPARE(outcome.state, EditState::ByAddress);
    if (tool == HandTool::Remove)
        return;
    // As even as before: all four are as long, and their tips as high.
    const Skeleton& drawn = *bench.document.result(1)->tree.skeleton;
    std::vector<double> heights;
    for (const Axis& axis : bench.axes().axes)
        if (axis.order == 1 && axis.length > 0.6)
            heights.push_back(
                drawn.p1[bench.axes().nodesOf(Index(&axis - bench.axes().axes.data())).back()].y);
    QCOMPARE(heights.size(), std::size_t{4});
    const auto [least, most] = std::ranges::minmax(heights);
    QVERIFY2(most - least < 0.25, qPrintable(QString::number(most - least)));
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestSymmetry::bentLimbsStayEven()
{
    EvenBench bench(HandTool::Bend, 4, false);
    const Index limb = bench.seenLimb();
    const QPointF at = bench.onAxis(limb);
    bench.drag(at, at + QPointF(0.0, 60.0));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    QVERIFY(bench.edits().size() >= 4);
    bench.grow();
    std::vector<double> heights;
    for (Index axis = 1; axis <= 4; ++axis)
        heights.push_back(
            bench.skeleton()
                .p1[bench.context.limbs.limb(bench.document, 1, bench.axes().axes[axis].address).back()]
                .y);
    const auto [least, most] = std::ranges::minmax(heights);
    QVERIFY2(most - least < 0.25, qPrintable(QString::number(most - least)));
}

RAMURE_SUITE(TestSymmetry)

} // namespace tst_symmetry

#include "tst_symmetry.moc"
