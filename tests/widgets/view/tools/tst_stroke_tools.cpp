#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include "widgets/view/tools/hand/stroke.h"

namespace tst_stroke_tools {

using namespace ramure;
using test::HandBench;

/// What is done by a stroke: saw, draw, graft, prune to a shape.
class TestStrokeTools : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void strokesThatGoNowhereAreNone();
    void strokesAreEvenSmoothAndThinOut();
    void theSawCutsWhatItCrosses();
    void theSawSparesWhatIsThick();
    void escapeTakesTheSawBack();
    void whatComesIntoAnAreaIsCut();
    void anAreaWithNothingInIt();
    void aBranchBeginsOnABranch();
    void aBranchGrowsAlongTheStroke();
    void aBranchIsSlender();
    void theBranchCanGrowManyTimes();
    void aBranchGrowsFromTheGround();
    void twigsGrowOnIt();
    void thePenSaysHowThick();
    void theSpeedSaysHowThick();
    void aTipGrowsOn();
    void aBranchGoesAnotherWay();
    void besideABranchNothingGoesOn();
    void theEraserSaws();
    void escapeTakesTheBranchBack();
    void aLimbIsCopiedAndGrows();
    void aLimbGrowsOnAnotherTree();
    void aShapePrunesTheTree();
    void aShortDragPrunesNothing();
    void whatAShapeWouldTakeIsShownFirst();
    void aStraightDragPrunesOneWay();
    void anOutlinePrunesTheTree();
    void aSolidPrunesTheTree();
    void escapeTakesTheShapeBack();

private:
    static void stroke(HandBench& bench, const std::vector<QPointF>& places)
    {
        bench.press(places.front());
        for (std::size_t i = 1; i < places.size(); ++i)
            bench.move(places[i]);
        bench.release(places.back());
    }
    static std::vector<QPointF> way(QPointF from, QPointF to)
    {
        std::vector<QPointF> places;
        for (int i = 0; i <= 10; ++i)
            places.push_back(from + (to - from) * i / 10.0);
        return places;
    }
};

void TestStrokeTools::strokesThatGoNowhereAreNone()
{
    QVERIFY(strokeBranch({}, {}).empty());
    QVERIFY(strokeBranch({{glm::dvec3(1.0), 1.0}}, {}).empty());
    QVERIFY(strokeBranch({{glm::dvec3(1.0), 1.0}, {glm::dvec3(1.0), 1.0}}, {}).empty());
    QVERIFY(
        strokeBranch({{glm::dvec3(0.0), 1.0}, {glm::dvec3(0.05, 0.0, 0.0), 1.0}}, {0.5, 0.1, 0.05}).empty());
}

void TestStrokeTools::strokesAreEvenSmoothAndThinOut()
{
    std::vector<StrokePoint> drawn;
    for (int i = 0; i <= 200; ++i)
        drawn.push_back({{0.01 * i, i % 2 ? 0.02 : -0.02, 0.0}, 1.0});
    const StrokeShape shape{1.0, 0.05, 0.01};
    const std::vector<StrokePoint> branch = strokeBranch(drawn, shape);
    QVERIFY(branch.size() >= 4 && branch.size() <= 40);
    QCOMPARE(branch.front().position, drawn.front().position);
    QCOMPARE(branch.back().position, drawn.back().position);
    for (std::size_t i = 1; i < branch.size(); ++i) {
        QVERIFY(branch[i].radius < branch[i - 1].radius);
        QVERIFY(branch[i].position.x > branch[i - 1].position.x);
        if (i > 1 && i + 2 < branch.size()) // its ends stay
            QVERIFY(std::abs(branch[i].position.y) < 0.011);
    }
    QVERIFY(std::abs(branch.front().radius - 0.05) < 1e-9 && std::abs(branch.back().radius - 0.01) < 1e-9);
}

void TestStrokeTools::theSawCutsWhatItCrosses()
{
    HandBench bench(HandTool::Saw);
    HandOptions options = bench.hand.options();
    options.sawThickest = 10.0;
    bench.hand.setOptions(options);
    const Index before = bench.skeleton().size();
    const QPointF trunk = bench.on(0, 0.5);
    stroke(bench, way({0.0, trunk.y()}, {800.0, trunk.y()}));
    QVERIFY(!bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    QVERIFY(bench.skeleton().size() < before);
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestStrokeTools::theSawSparesWhatIsThick()
{
    HandBench bench(HandTool::Saw);
    HandOptions options = bench.hand.options();
    options.sawThickest = 0.0; // held to the least
    bench.hand.setOptions(options);
    QCOMPARE(bench.hand.options().sawThickest, 0.001);
    stroke(bench, way({0.0, 300.0}, {800.0, 300.0}));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestStrokeTools::escapeTakesTheSawBack()
{
    HandBench bench(HandTool::Saw);
    HandOptions options = bench.hand.options();
    options.sawThickest = 10.0;
    bench.hand.setOptions(options);
    const QPointF trunk = bench.on(0, 0.5);
    bench.press({0.0, trunk.y()});
    bench.move({800.0, trunk.y()});
    QVERIFY(!bench.edits().empty());
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestStrokeTools::whatComesIntoAnAreaIsCut()
{
    for (const SawWay by : {SawWay::Rectangle, SawWay::Lasso}) {
        HandBench bench(HandTool::Saw);
        HandOptions options = bench.hand.options();
        options.sawThickest = 10.0;
        options.sawWay = by;
        bench.hand.setOptions(options);
        const double cut = bench.on(0, 1.0).y(); // all above the first piece of the trunk
        const QPointF corner(0.0, 0.0), opposite(800.0, cut - 10.0);
        const std::vector<QPointF> box =
            by == SawWay::Rectangle ? std::vector<QPointF>{corner, {400.0, 100.0}, opposite}
                                    : std::vector<QPointF>{corner, {800.0, 0.0}, opposite, {0.0, cut - 10.0}};
        bench.press(box.front());
        for (const QPointF at : box)
            bench.move(at);
        QVERIFY(!bench.marked.empty());
        QVERIFY(bench.edits().empty()); // until it is let go
        bench.release(box.back());
        QVERIFY2(!bench.edits().empty(), qPrintable(bench.messages.join(u'\n')));
        QVERIFY(bench.marked.empty());
        QCOMPARE(bench.document.undoStack()->count(), 1);
        bench.grow();
        for (Index b = 0; b < bench.skeleton().size(); ++b)
            QVERIFY(bench.on(b, 1.0).y() > cut - 14.0);
        bench.document.undo();
        QVERIFY(bench.edits().empty());
    }
}

void TestStrokeTools::anAreaWithNothingInIt()
{
    HandBench bench(HandTool::Saw);
    HandOptions options = bench.hand.options();
    options.sawWay = SawWay::Rectangle;
    bench.hand.setOptions(options);
    bench.click({5.0, 5.0});
    QVERIFY(bench.messages.isEmpty());
    bench.drag({2.0, 2.0}, {12.0, 12.0});
    QCOMPARE(bench.messages.size(), 1);
    QVERIFY(bench.edits().empty());
    bench.press({0.0, 0.0});
    bench.move({800.0, 600.0});
    QVERIFY(bench.says("Esc"));
    bench.key(Qt::Key_Escape);
    QVERIFY(bench.edits().empty() && bench.marked.empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestStrokeTools::aBranchBeginsOnABranch()
{
    HandBench bench(HandTool::Draw);
    stroke(bench, way({2.0, 2.0}, {200.0, 2.0}));
    QVERIFY(bench.edits().empty());
    QVERIFY(!bench.messages.empty());
    const QPointF trunk = bench.on(0, 0.5);
    bench.click(trunk); // goes nowhere
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.messages.size(), 2);
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestStrokeTools::aBranchGrowsAlongTheStroke()
{
    HandBench bench(HandTool::Draw);
    const QPointF trunk = bench.on(0, 0.5);
    const Index before = bench.skeleton().size();
    stroke(bench, way(trunk, trunk + QPointF(160.0, -60.0)));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QCOMPARE(bench.edits().front().operation, EditOperation::Draw);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    const std::uint64_t address = bench.edits().front().id;
    bench.grow();
    QVERIFY(bench.skeleton().size() > before);
    const std::vector<Index> grown = LimbFinder().limb(bench.document, 1, address);
    QVERIFY(!grown.empty());
    const QPointF tip = bench.on(grown.back(), 1.0);
    QVERIFY2(std::hypot(tip.x() - trunk.x() - 160.0, tip.y() - trunk.y() + 60.0) < 12.0,
             qPrintable(QStringLiteral("%1 %2").arg(tip.x() - trunk.x()).arg(tip.y() - trunk.y())));
}

/// A short stroke on a thick trunk makes a twig, a long one a limb thinner than the trunk; a chosen radius is
/// kept.
void TestStrokeTools::aBranchIsSlender()
{
    const auto radiusAfter = [](double pixels, double chosen) {
        HandBench bench(HandTool::Draw);
        bench.hand.setOptions({.drawRadius = chosen, .drawTip = 1.0}); // as thick everywhere as at its foot
        const QPointF trunk = bench.on(0, 0.5);
        stroke(bench, way(trunk, trunk + QPointF(pixels, -0.4 * pixels)));
        return bench.edits().empty() ? 0.0 : bench.edits().front().points.front().radius;
    };
    const double shorter = radiusAfter(40.0, 0.0), longer = radiusAfter(160.0, 0.0);
    QVERIFY(shorter > 0.0 && shorter < 0.5 * longer);
    QVERIFY(longer < HandBench(HandTool::Draw).skeleton().a0[0]);
    QVERIFY(std::abs(radiusAfter(40.0, 0.07) - 0.07) < 1e-9);
    QVERIFY(std::abs(radiusAfter(160.0, 0.07) - 0.07) < 1e-9);
}

void TestStrokeTools::theBranchCanGrowManyTimes()
{
    HandBench bench(HandTool::Draw);
    HandOptions options = bench.hand.options();
    options.copies = 3;
    options.mirrored = true;
    bench.hand.setOptions(options);
    const QPointF trunk = bench.on(0, 0.5);
    stroke(bench, way(trunk, trunk + QPointF(160.0, -60.0)));
    QCOMPARE(bench.edits().size(), std::size_t(6));
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    for (const TreeEdit& edit : bench.edits())
        QVERIFY(!LimbFinder().limb(bench.document, 1, edit.id).empty());
}

void TestStrokeTools::aBranchGrowsFromTheGround()
{
    HandBench bench(HandTool::Draw);
    bench.camera.pitchRad = 0.3;
    const QPointF ground = bench.pixelOf({0.4, 0.0, 0.2});
    stroke(bench, way(ground, ground + QPointF(40.0, -160.0)));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().target.address, std::uint64_t(0));
    bench.grow();
    const auto grown = LimbFinder().limb(bench.document, 1, bench.edits().front().id);
    QVERIFY(!grown.empty());
    QCOMPARE(bench.skeleton().parent[grown.front()], noIndex);
    QVERIFY(glm::length(bench.skeleton().p0[grown.front()] - glm::dvec3(0.4, 0.0, 0.2)) < 1e-3);
}

void TestStrokeTools::twigsGrowOnIt()
{
    HandBench bench(HandTool::Draw);
    HandOptions options = bench.hand.options();
    options.drawTwigs = true;
    bench.hand.setOptions(options);
    const QPointF trunk = bench.on(0, 0.5);
    stroke(bench, way(trunk, trunk + QPointF(160.0, -60.0)));
    QCOMPARE(bench.edits().size(), std::size_t(1));
    QVERIFY(bench.edits().front().below);
    bench.grow();
    QVERIFY(!LimbFinder().limb(bench.document, 1, bench.edits().front().id).empty());
}

void TestStrokeTools::thePenSaysHowThick()
{
    const auto thickness = [](std::optional<double> pressure) {
        HandBench bench(HandTool::Draw);
        const QPointF trunk = bench.on(0, 0.5);
        const auto pen = [&](QPointF at, Qt::MouseButton button) {
            ToolPoint point = bench.at(at, button);
            point.pressure = pressure;
            return point;
        };
        bench.tools.press(pen(trunk, Qt::LeftButton));
        for (int i = 1; i <= 10; ++i)
            bench.tools.move(pen(trunk + i * QPointF(16.0, -6.0), Qt::NoButton));
        bench.tools.release(pen(trunk + QPointF(160.0, -60.0), Qt::LeftButton));
        return bench.edits().empty() ? 0.0 : bench.edits().front().points.front().radius;
    };
    const double mouse = thickness({}), soft = thickness(0.1), hard = thickness(1.0);
    QVERIFY(soft > 0.0);
    QVERIFY(soft < mouse && mouse < hard);
}

void TestStrokeTools::theSpeedSaysHowThick()
{
    const auto thickness = [](DrawBy by, std::uint64_t step) {
        HandBench bench(HandTool::Draw);
        HandOptions options = bench.hand.options();
        options.drawBy = by;
        bench.hand.setOptions(options);
        const QPointF trunk = bench.on(0, 0.5);
        const auto hand = [&](int i, Qt::MouseButton button) {
            ToolPoint point = bench.at(trunk + i * QPointF(16.0, -6.0), button);
            point.milliseconds = 1000 + step * std::uint64_t(i);
            return point;
        };
        bench.tools.press(hand(0, Qt::LeftButton));
        for (int i = 1; i <= 10; ++i)
            bench.tools.move(hand(i, Qt::NoButton));
        bench.tools.release(hand(10, Qt::LeftButton));
        return bench.edits().empty() ? 0.0 : bench.edits().front().points.back().radius;
    };
    const double even = thickness(DrawBy::Even, 10), quick = thickness(DrawBy::Speed, 10),
                 slow = thickness(DrawBy::Speed, 200), timeless = thickness(DrawBy::Speed, 0);
    QVERIFY(quick > 0.0);
    QVERIFY(quick < 0.8 * even && slow > 1.1 * even);
    QVERIFY(timeless >= slow);
}

void TestStrokeTools::aTipGrowsOn()
{
    HandBench bench(HandTool::Extend);
    const Index twig = bench.twig();
    const LimbHit limb = bench.limb(twig);
    const auto tip = [&] { return bench.on(LimbFinder().limb(bench.document, 1, limb.address).back(), 1.0); };
    const QPointF before = tip(), at = bench.on(twig);
    stroke(bench, way(at, at + QPointF(50.0, -90.0)));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Extend);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    const QPointF moved = tip() - before;
    QVERIFY2(std::hypot(moved.x() - 50.0, moved.y() + 90.0) < 5.0,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
}

void TestStrokeTools::aBranchGoesAnotherWay()
{
    HandBench bench(HandTool::Redraw);
    const QPointF from = bench.on(0, 0.5);
    const LimbHit trunk = bench.limb(0);
    const Index before = bench.skeleton().size();
    const QPointF base = bench.on(0, 0.0);
    stroke(bench, way(from, from + QPointF(120.0, -140.0)));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Redraw);
    bench.grow();
    const std::vector<Index> limb = LimbFinder().limb(bench.document, 1, trunk.address);
    const QPointF tip = bench.on(limb.back(), 1.0) - from, foot = bench.on(limb.front(), 0.0) - base;
    QVERIFY2(std::hypot(tip.x() - 120.0, tip.y() + 140.0) < 5.0,
             qPrintable(QStringLiteral("%1 %2").arg(tip.x()).arg(tip.y())));
    QVERIFY(std::hypot(foot.x(), foot.y()) < 1.0);
    QVERIFY(bench.skeleton().size() >= before); // what grows on it has come along
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

void TestStrokeTools::besideABranchNothingGoesOn()
{
    for (const HandTool tool : {HandTool::Extend, HandTool::Redraw}) {
        HandBench bench(tool);
        stroke(bench, way({2.0, 2.0}, {200.0, 2.0}));
        QVERIFY(bench.edits().empty());
        QCOMPARE(bench.messages.size(), 1);
        bench.click(bench.on(bench.twig())); // goes nowhere
        QVERIFY(bench.edits().empty());
        QCOMPARE(bench.messages.size(), 2);
        bench.press(bench.on(bench.twig()));
        bench.move(bench.on(bench.twig()) + QPointF(60.0, 60.0));
        QCOMPARE(bench.edits().size(), std::size_t(1));
        bench.key(Qt::Key_Escape);
        QVERIFY(bench.edits().empty());
        QCOMPARE(bench.document.undoStack()->count(), 0);
    }
}

void TestStrokeTools::theEraserSaws()
{
    HandBench bench(HandTool::Draw);
    HandOptions options = bench.hand.options();
    options.sawThickest = 10.0;
    bench.hand.setOptions(options);
    const QPointF trunk = bench.on(0, 0.5);
    ToolPoint point = bench.at({0.0, trunk.y()}, Qt::LeftButton);
    point.isEraser = true;
    bench.tools.press(point);
    point.button = Qt::NoButton;
    point.at.setX(800.0);
    bench.tools.move(point);
    point.button = Qt::LeftButton;
    bench.tools.release(point);
    QVERIFY(!bench.edits().empty());
    QVERIFY(bench.edits().front().operation == EditOperation::Cut ||
            bench.edits().front().operation == EditOperation::Remove);
}

void TestStrokeTools::escapeTakesTheBranchBack()
{
    HandBench bench(HandTool::Draw);
    const QPointF trunk = bench.on(0, 0.5);
    bench.press(trunk);
    bench.move(trunk + QPointF(80.0, -30.0));
    bench.move(trunk + QPointF(160.0, -60.0));
    QCOMPARE(bench.edits().size(), std::size_t(1)); // while it is drawn
    QVERIFY(bench.says("Esc"));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

void TestStrokeTools::aLimbIsCopiedAndGrows()
{
    HandBench bench(HandTool::Graft);
    const Index twig = bench.twig(), before = bench.skeleton().size();
    QVERIFY(bench.says("copy it"));
    bench.click(bench.on(twig));
    QVERIFY(bench.edits().empty());
    QVERIFY(bench.says("grows here"));
    bench.click(bench.on(0, 0.5));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().operation, EditOperation::Graft);
    bench.grow();
    QVERIFY(bench.skeleton().size() > before);
    bench.click(bench.on(bench.twig()), Qt::ShiftModifier); // another one is copied
    QCOMPARE(bench.edits().size(), std::size_t(1));
    bench.hand.setTool(HandTool::None);
    bench.hand.setTool(HandTool::Graft);
    QVERIFY(bench.says("copy it"));
}

void TestStrokeTools::aLimbGrowsOnAnotherTree()
{
    HandBench bench(HandTool::Graft, 2);
    const Index twig = bench.twig(1), before = bench.skeleton(2).size();
    bench.click(bench.on(twig, 0.6, 1));
    bench.click(bench.on(0, 0.5, 2));
    QVERIFY(bench.edits(1).empty());
    QVERIFY2(bench.edits(2).size() == 1, qPrintable(bench.messages.join(u'\n')));
    QVERIFY(!bench.edits(2).front().limb.empty());
    bench.grow();
    QVERIFY(bench.skeleton(2).size() > before);
}

void TestStrokeTools::aShapePrunesTheTree()
{
    for (const EditShapeKind kind : {EditShapeKind::Sphere, EditShapeKind::Box, EditShapeKind::Cone}) {
        HandBench bench(HandTool::Prune);
        HandOptions options = bench.hand.options();
        options.shape = kind;
        bench.hand.setOptions(options);
        const QPointF trunk = bench.on(0, 0.2);
        bench.drag(trunk, trunk + QPointF(60.0, -90.0));
        QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
        QCOMPARE(bench.edits().front().operation, EditOperation::Prune);
        QCOMPARE(bench.edits().front().shape.kind, kind);
        QCOMPARE(bench.document.undoStack()->count(), 1);
        const double before = skeletonStats(bench.skeleton()).totalLength;
        bench.grow();
        QVERIFY(skeletonStats(bench.skeleton()).totalLength < before);
    }
}

void TestStrokeTools::aShortDragPrunesNothing()
{
    HandBench bench(HandTool::Prune);
    const QPointF air(12.0, 12.0);
    bench.press(air);
    bench.move(air + QPointF(14.0, 8.0));
    QVERIFY(bench.marked.empty());
    QVERIFY(bench.says("Drag from the middle"));
    bench.release(air + QPointF(14.0, 8.0));
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
    QCOMPARE(bench.messages.size(), 1);
}

void TestStrokeTools::whatAShapeWouldTakeIsShownFirst()
{
    HandBench bench(HandTool::Prune);
    const QPointF trunk = bench.on(0, 0.2), to = trunk + QPointF(60.0, -90.0);
    bench.press(trunk);
    bench.move(to);
    QVERIFY(bench.edits().empty());
    QVERIFY(!bench.marked.empty() && bench.markedGo);
    QVERIFY(bench.says("would go"));
    const std::size_t before = bench.skeleton().size(), goes = bench.marked.size();
    bench.release(to);
    QVERIFY(bench.marked.empty());
    QCOMPARE(bench.edits().size(), std::size_t(1));
    bench.grow();
    QVERIFY(bench.skeleton().size() <= before - goes / 2 && bench.skeleton().size() < before);
    bench.document.undo();
    QVERIFY(bench.edits().empty());
}

/// The other measure is the tree's: nothing is flat.
void TestStrokeTools::aStraightDragPrunesOneWay()
{
    for (const EditShapeKind kind : {EditShapeKind::Box, EditShapeKind::Cone})
        for (const QPointF way : {QPointF(120.0, 0.0), QPointF(120.0, -9.0), QPointF(0.0, -120.0)}) {
            HandBench bench(HandTool::Prune);
            HandOptions options = bench.hand.options();
            options.shape = kind;
            bench.hand.setOptions(options);
            const SkeletonStats tree = skeletonStats(bench.skeleton());
            const QPointF from = bench.pixelOf(0.5 * (tree.min + tree.max));
            bench.drag(from, from + way);
            QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
            const auto& n = bench.edits().front().shape.numbers;
            const bool isBox = kind == EditShapeKind::Box;
            const double high = isBox ? n[4] - n[1] : 2.0 * n[4], wide = isBox ? n[3] - n[0] : 2.0 * n[3];
            if (way.x() > 0.0)
                QVERIFY(high >= tree.max.y - tree.min.y && wide < tree.max.x - tree.min.x + 2.0);
            else
                QVERIFY(wide >= tree.max.x - tree.min.x);
        }
}

void TestStrokeTools::anOutlinePrunesTheTree()
{
    HandBench bench(HandTool::Prune);
    HandOptions options = bench.hand.options();
    options.shape = EditShapeKind::Profile;
    bench.hand.setOptions(options);
    const QPointF foot = bench.on(0, 0.0), top = bench.on(0, 1.0);
    stroke(bench, way(foot + QPointF(30.0, 0.0), foot + QPointF(90.0, 0.0))); // of no height
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.messages.size(), 1);
    stroke(bench, way(foot + QPointF(40.0, 0.0), top + QPointF(15.0, 0.0)));
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    const EditShape& shape = bench.edits().front().shape;
    QCOMPARE(shape.kind, EditShapeKind::Profile);
    QVERIFY(shape.points.front().x > shape.points.back().x);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    const double before = skeletonStats(bench.skeleton()).totalLength,
                 high = shape.numbers[1] + shape.points.back().y;
    bench.grow();
    QVERIFY(skeletonStats(bench.skeleton()).totalLength < before);
    QVERIFY(skeletonStats(bench.skeleton()).max.y < high + 1e-6);
}

void TestStrokeTools::aSolidPrunesTheTree()
{
    HandBench bench(HandTool::Prune);
    HandOptions options = bench.hand.options();
    options.shape = EditShapeKind::Mesh;
    bench.hand.setOptions(options);
    bench.click(bench.on(0, 0.5)); // no solid
    bench.click({2.0, 2.0});
    QVERIFY(bench.edits().empty());
    QCOMPARE(bench.messages.size(), 2);
    std::vector<Node> nodes{*bench.document.scene().find(1)};
    Node ball;
    ball.id = 2;
    ball.kind = NodeKind::Primitive;
    ball.name = "ball";
    nodes.push_back(ball);
    bench.open(Scene::fromNodes(nodes).value_or(Scene()));
    bench.grow();
    const double before = skeletonStats(bench.skeleton()).totalLength;
    const auto scene = bench.latestPickScene();
    std::optional<QPointF> on; // the ball
    for (double x = 5.0; x < bench.size.x && !on; x += 5.0)
        for (double y = 5.0; y < bench.size.y && !on; y += 5.0)
            if (const auto hit = scene->pick(bench.view(), {x, y}); hit && hit->node == 2)
                on = QPointF(x, y);
    QVERIFY(on);
    bench.click(*on);
    QVERIFY2(bench.edits().size() == 1, qPrintable(bench.messages.join(u'\n')));
    QCOMPARE(bench.edits().front().shape.kind, EditShapeKind::Mesh);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.grow();
    QVERIFY(skeletonStats(bench.skeleton()).totalLength < before);
}

void TestStrokeTools::escapeTakesTheShapeBack()
{
    HandBench bench(HandTool::Prune, 2);
    bench.drag({2.0, 2.0}, {60.0, 60.0}); // which tree?
    QVERIFY(bench.edits(1).empty() && bench.edits(2).empty());
    QCOMPARE(bench.messages.size(), 1);
    bench.press(bench.on(0, 0.2));
    bench.move(bench.on(0, 0.2) + QPointF(60.0, -60.0));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.edits(1).empty());
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

RAMURE_SUITE(TestStrokeTools)

} // namespace tst_stroke_tools

#include "tst_stroke_tools.moc"
