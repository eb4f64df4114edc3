#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"

namespace tst_place_tool {

using namespace ramure;
using test::HandBench;

/// One leaf or fruit where the hand clicks.
class TestPlaceTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideTheTreeNothingGrows();
    void aLeafGrowsWhereItIsClicked();
    void itGrowsOnTheSideThatIsClicked();
    void asManyAsAreWanted();
    void whatIsPlacedIsShown();
    void whatTheTreeBearsIsSaid();
};

void TestPlaceTool::besideTheTreeNothingGrows()
{
    HandBench bench(HandTool::Place);
    bench.click({2.0, 2.0});
    QVERIFY(bench.edits().empty());
    bench.press(bench.on(bench.twig()));
    bench.key(Qt::Key_Escape);
    QVERIFY(bench.edits().empty());
    QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
    bench.click(bench.on(0));
    QVERIFY(bench.edits().empty());
}

void TestPlaceTool::aLeafGrowsWhereItIsClicked()
{
    HandBench bench(HandTool::Place);
    const Index twig = bench.twig();
    const auto own = bench.document.result(1)->tree.foliage->leaves;
    const std::size_t before = own.size();
    bench.tools.hover(bench.at(bench.on(twig)));
    QVERIFY(bench.says("leaf"));
    bench.click(bench.on(twig));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    const TreeEdit made = bench.edits().front();
    QCOMPARE(made.operation, EditOperation::Place);
    QCOMPARE(made.organ, EditOrgan::Leaf);
    bench.grow();
    const auto& leaves = bench.document.result(1)->tree.foliage->leaves;
    QCOMPARE(leaves.size(), before + 1);
    const auto placed = std::ranges::find_if(leaves, [&own](const auto& leaf) {
        return std::ranges::find(own, leaf.position, &std::decay_t<decltype(leaf)>::position) == own.end();
    });
    QVERIFY(placed != leaves.end());
    const glm::dvec3 clicked = glm::mix(bench.skeleton().p0[twig], bench.skeleton().p1[twig], 0.6);
    const glm::dvec3 along = glm::normalize(bench.skeleton().p1[twig] - bench.skeleton().p0[twig]);
    QVERIFY(std::abs(glm::dot(placed->position - clicked, along)) < 0.01); // petioles hang
    bench.document.undo();
    bench.grow();
    QCOMPARE(bench.document.result(1)->tree.foliage->leaves.size(), before);
}

/// It stands on the bark where that was hit, from wherever the tree is looked at.
void TestPlaceTool::itGrowsOnTheSideThatIsClicked()
{
    int tried = 0;
    for (const double yaw : {0.0, 2.0, 4.0}) {
        HandBench bench(HandTool::Place);
        bench.mode = DisplayMode::Mesh;
        bench.show();
        bench.camera.orbit(yaw, 0.0);
        const auto scene = bench.latestPickScene();
        const Skeleton skeleton = bench.skeleton();
        const auto own = bench.document.result(1)->tree.foliage->leaves;
        const double pixel = bench.camera.metresPerPixel(skeleton.p0[0], bench.size.y);
        for (Index b = 0; b < skeleton.size() && tried < 9 + 9 * int(yaw); ++b)
            for (const double side : {-0.7, 0.1, 0.7}) {
                const QPointF middle = bench.on(b, 0.5), along = bench.on(b, 0.6) - middle;
                const double reach = side * skeleton.a1[b] / pixel / std::hypot(along.x(), along.y());
                const QPointF at = middle + reach * QPointF(-along.y(), along.x());
                const auto hit = scene->pick(bench.view(), {at.x(), at.y()});
                if (!hit || hit->branch != b || skeleton.a1[b] < 3.0 * pixel)
                    continue; // hidden, a leaf, or so thin that it has no sides
                bench.click(at);
                QVERIFY2(!bench.edits().empty(), qPrintable(bench.messages.join(u'\n')));
                if (!bench.recompute.waitForFull(HandBench::patienceMs))
                    QFAIL("no result");
                const auto& leaves = bench.document.result(1)->tree.foliage->leaves;
                const auto placed = std::ranges::find_if(leaves, [&own](const FoliageItem& leaf) {
                    return std::ranges::find(own, leaf.position, &FoliageItem::position) == own.end();
                });
                QVERIFY(placed != leaves.end());
                QVERIFY2(glm::distance(placed->position, hit->point) < 0.7 * skeleton.a0[b],
                         qPrintable(QStringLiteral("branch %1, side %2: %3 of %4 m")
                                        .arg(b)
                                        .arg(side)
                                        .arg(glm::distance(placed->position, hit->point))
                                        .arg(skeleton.a0[b])));
                bench.document.undo();
                ++tried;
            }
    }
    QVERIFY2(tried > 12, qPrintable(QString::number(tried)));
}

void TestPlaceTool::asManyAsAreWanted()
{
    HandBench bench(HandTool::Place);
    HandOptions options;
    options.organ = EditOrgan::Fruit;
    options.organSize = 1.5;
    options.copies = 3;
    bench.hand.setOptions(options);
    bench.click(bench.on(bench.twig()));
    QCOMPARE(bench.edits().size(), std::size_t(3));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    for (const TreeEdit& edit : bench.edits()) {
        QCOMPARE(edit.organ, EditOrgan::Fruit);
        QCOMPARE(edit.factor, 1.5);
    }
    const double apart = bench.edits()[1].azimuthRad - bench.edits()[0].azimuthRad;
    QVERIFY(std::abs(apart - 2.0943951) < 1e-6);
}

/// Also where leaves, or fruit, were hidden.
void TestPlaceTool::whatIsPlacedIsShown()
{
    HandBench bench(HandTool::Place);
    bench.click({2.0, 2.0}); // beside the tree
    QVERIFY(bench.organsShown.isEmpty());
    for (const EditOrgan organ : {EditOrgan::Leaf, EditOrgan::Flower}) {
        HandOptions options;
        options.organ = organ;
        bench.hand.setOptions(options);
        bench.click(bench.on(bench.twig()));
        QCOMPARE(bench.organsShown.back(), organ);
        bench.grow();
    }
    QCOMPARE(bench.organsShown.size(), 2);
}

void TestPlaceTool::whatTheTreeBearsIsSaid()
{
    HandBench bench(HandTool::Place);
    HandOptions options;
    options.organ = EditOrgan::Flower;
    bench.hand.setOptions(options);
    bench.click(bench.on(bench.twig()));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.messages.join(u' ').contains(QLatin1String("bears fruit")));
}

RAMURE_SUITE(TestPlaceTool)

} // namespace tst_place_tool

#include "tst_place_tool.moc"
