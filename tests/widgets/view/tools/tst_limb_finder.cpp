#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include "tests/support/turned_branches.h"
#include "widgets/view/tools/hand/hand_edit.h"

namespace tst_limb_finder {

using namespace ramure;
using test::HandBench;

/// Which limb a branch of the picture is, and where on it.
class TestLimbFinder : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void thereIsNothingWhereNothingGrew();
    void sharesGrowAlongTheLimb();
    void whatGrowsAboveComesAlong();
    void selectedBranchesAreMeantTogether();
    void skeletonsAloneAnswerWhereBranchesAre();
    void placesOfBentTreesAreThoseThatAreSeen();
    void aGestureIsOneStepOrNone();
};

void TestLimbFinder::thereIsNothingWhereNothingGrew()
{
    Document document;
    LimbFinder finder;
    QVERIFY(!finder.axes(document, 1));
    QVERIFY(!finder.startOf(document, 1, 0) && !finder.at(document, {}));
    QVERIFY(finder.limb(document, 1, 5).empty() && finder.spans(document, 1).empty());
    QVERIFY(finder.selected(document).empty());
    QVERIFY(!HandEdit::begin(document, 1));
    HandBench bench(HandTool::None);
    QVERIFY(!finder.startOf(bench.document, 1, bench.skeleton().size()));
    QVERIFY(!removeLimbs(bench.document, {}, true) && !toggleLeaves(bench.document, {}));
    QVERIFY(edit::setNodeLocked(bench.document, {1}, true));
    QVERIFY(!finder.startOf(bench.document, 1, 0));
    QVERIFY(!HandEdit::begin(bench.document, 1));
}

void TestLimbFinder::sharesGrowAlongTheLimb()
{
    HandBench bench(HandTool::None);
    LimbFinder finder;
    const std::vector<LimbSpan> spans = finder.spans(bench.document, 1);
    QCOMPARE(spans.size(), std::size_t(bench.skeleton().size()));
    for (Index b = 0; b < bench.skeleton().size(); ++b) {
        const auto start = finder.startOf(bench.document, 1, b);
        QVERIFY(start && start->branch == b && start->address == spans[b].address);
        QVERIFY(start->share >= 0.0 && start->share < 1.0);
        QVERIFY(spans[b].to > spans[b].from);
        const auto limb = finder.limb(bench.document, 1, start->address);
        QVERIFY(std::ranges::find(limb, b) != limb.end());
        const Index parent = bench.skeleton().parent[b];
        if (parent != noIndex && spans[parent].address == spans[b].address)
            QVERIFY(std::abs(spans[parent].to - spans[b].from) < 1e-9);
    }
}

void TestLimbFinder::whatGrowsAboveComesAlong()
{
    HandBench bench(HandTool::None);
    LimbFinder finder;
    const auto foot = finder.startOf(bench.document, 1, 0);
    QCOMPARE(finder.above(bench.document, *foot, true), bench.all());
    for (Index b = 0; b < bench.skeleton().size(); ++b) {
        const auto limb = finder.startOf(bench.document, 1, b);
        const auto above = finder.above(bench.document, *limb, false);
        QVERIFY(std::ranges::find(above, b) != above.end());
        for (const Index child : bench.all())
            if (bench.skeleton().parent[child] == b)
                QVERIFY(std::ranges::find(above, child) != above.end());
    }
}

void TestLimbFinder::selectedBranchesAreMeantTogether()
{
    HandBench bench(HandTool::None);
    LimbFinder finder;
    const LimbHit hit = bench.limb(1);
    QCOMPARE(finder.meantBy(bench.document, hit).size(), std::size_t(1));
    bench.select(1, bench.all());
    const auto limbs = finder.meantBy(bench.document, hit);
    QCOMPARE(limbs.size(), finder.axes(bench.document, 1)->axes.size()); // each once, from its foot on
    QVERIFY(std::ranges::all_of(limbs, [](const LimbHit& limb) { return limb.share == 0.0; }));
    // Of one limb, selected as a whole, the place that was hit is meant.
    bench.select(1, finder.limbOf(bench.document, 1, hit.branch));
    QCOMPARE(finder.meantBy(bench.document, hit).size(), std::size_t(1));
    QCOMPARE(finder.meantBy(bench.document, hit).front().share, hit.share);
    bench.select(1, {0, 1});
    QCOMPARE(finder.meantBy(bench.document, bench.limb(bench.skeleton().size() - 1)).size(), std::size_t(1));
}

/// While nothing is ready to pick in; what is seen is hit, and the side of it.
void TestLimbFinder::skeletonsAloneAnswerWhereBranchesAre()
{
    HandBench bench(HandTool::None);
    LimbFinder finder;
    QVERIFY(!finder.under(bench.document, bench.view(), {2.0, 2.0}));
    QVERIFY(edit::setNodeVisible(bench.document, {1}, false));
    const QPointF at = bench.on(0);
    QVERIFY(!finder.under(bench.document, bench.view(), {at.x(), at.y()}));
    QVERIFY(edit::setNodeVisible(bench.document, {1}, true));
    for (const Index branch : {Index(0), bench.twig(), Index(0)}) {
        const bool isMesh = bench.mode == DisplayMode::Mesh;
        const QPointF place = bench.on(branch, 0.5);
        const auto exact = bench.latestPickScene()->pick(bench.view(), {place.x(), place.y()});
        const auto hit = finder.under(bench.document, bench.view(), {place.x(), place.y()});
        QVERIFY(exact && hit);
        const auto wanted = finder.at(bench.document, *exact);
        QCOMPARE(hit->branch, wanted->branch);
        QVERIFY(std::abs(hit->share - wanted->share) < 0.1);
        QVERIFY(!isMesh || glm::dot(hit->side, wanted->side) > 0.0); // lines have no side
        if (branch != 0) {
            bench.mode = DisplayMode::Mesh;
            bench.show();
        }
    }
}

void TestLimbFinder::placesOfBentTreesAreThoseThatAreSeen()
{
    HandBench bench(HandTool::None);
    const Index last = bench.skeleton().size() - 1;
    QVERIFY(
        edit::putTreeEdits(bench.document, 1,
                           test::bends(bench.document.result(1)->tree, bench.document.scene().find(1)->params,
                                       {{0, {0.3, 0.0, 0.2}}, {last, {-0.4, 0.2, 0.0}}})));
    bench.grow();
    const auto gesture = HandEdit::begin(bench.document, 1);
    QVERIFY(gesture.has_value());
    for (const Index b : bench.all()) {
        const LimbHit limb = bench.limb(b);
        const auto grown = (*gesture)->context().pointOn(limb.address, limb.share);
        QVERIFY(grown.has_value());
        QVERIFY2(glm::length(limb.seen - grown->position) < 1e-6, qPrintable(QString::number(b)));
    }
}

void TestLimbFinder::aGestureIsOneStepOrNone()
{
    HandBench bench(HandTool::None);
    const NodeParams before = bench.document.scene().find(1)->params;
    for (const bool keeps : {false, true}) {
        auto gesture = HandEdit::begin(bench.document, 1);
        TreeEdit edit;
        edit.operation = EditOperation::Length;
        edit.target.address = 12345;
        QVERIFY(!(*gesture)->add(edit)); // no such limb
        QVERIFY((*gesture)->edits().empty());
        edit.target.address = bench.limb(bench.twig()).address;
        for (const double factor : {1.1, 1.2, 1.3}) {
            edit.factor = factor;
            QVERIFY((*gesture)->replace({edit}));
            QVERIFY((*gesture)->show());
            QCOMPARE(bench.edits().size(), std::size_t(1));
        }
        QVERIFY((*gesture)->replace({}));
        QVERIFY((*gesture)->show());
        QVERIFY(bench.document.scene().find(1)->params == before);
        QVERIFY((*gesture)->replace({edit}));
        QVERIFY((*gesture)->show());
        keeps ? (*gesture)->keep() : (*gesture)->cancel();
        QCOMPARE(bench.document.undoStack()->count(), keeps ? 1 : 0);
    }
    bench.document.undo();
    QVERIFY(bench.document.scene().find(1)->params == before);
}

RAMURE_SUITE(TestLimbFinder)

} // namespace tst_limb_finder

#include "tst_limb_finder.moc"
