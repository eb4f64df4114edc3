#include "core/recipe/edit_context.h"
#include "tests/support/shaped_tree.h"
#include "tests/support/step_map.h"

#include <set>

namespace tst_edit_shares {

using namespace ramure;
using namespace ramure::test;

namespace {

struct Share
{
    int right = 0, wrong = 0, unplaced = 0, gone = 0; ///< gone: its place is not there any more
    [[nodiscard]] bool keeps(double least) const { return right >= least * (right + wrong + unplaced); }
};

/// A hundred edits of different axes, or one of each, that leave the tree as it is.
std::vector<TreeEdit> harmlessEdits(const TreeResult& tree, std::uint64_t seed)
{
    const EditContext context(*tree.grown, {});
    const TreeAxes axes = axesOf(*tree.grown);
    Random random(seed, RandomStream::Test);
    std::set<Index> chosen;
    const auto count = static_cast<Index>(axes.axes.size());
    while (chosen.size() < std::min<std::size_t>(100, count))
        chosen.insert(random.below(count));
    std::vector<TreeEdit> edits;
    for (const Index axis : chosen) {
        auto edit = context.prepared(editOf(EditOperation::Length, axes.axes[axis].address), true);
        edit->id = newEditId(edits, *edit);
        edits.push_back(*edit);
    }
    return edits;
}

Share shareOf(const TreeResult& before, const TreeResult& after, const StepMap& map, std::uint64_t seed)
{
    const std::vector<TreeEdit> edits = harmlessEdits(before, seed);
    const TreeAxes then = axesOf(*before.grown), now = axesOf(*after.grown);
    const EditReport report = EditContext(*after.grown, edits).report();
    Share share;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const auto axis = std::ranges::find(then.axes, edits[i].target.address, &Axis::address);
        const Index step = map[then.nodes[axis->firstNode]];
        if (step == noIndex)
            ++share.gone;
        else if (report[i].state == EditState::Unplaced)
            ++share.unplaced;
        else
            ++(report[i].address == now.axes[now.axisOf[step]].address ? share.right : share.wrong);
    }
    return share;
}

} // namespace

/// Edits find their limbs again after the five changes of a tree.
class TestEditShares : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void keepTheirPlaces_data();
    void keepTheirPlaces();
    void otherNumbers_data() { keepTheirPlaces_data(); }
    void otherNumbers();
};

void TestEditShares::keepTheirPlaces_data()
{
    QTest::addColumn<QByteArray>("preset");
    for (const Preset& preset : courseworkPresets())
        QTest::newRow(preset.name) << QByteArray(preset.name);
}

void TestEditShares::keepTheirPlaces()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    const TreeResult before = grownTree(params, Stage::Skeleton);
    const Index steps = before.grown->size();
    // One iteration more.
    NodeParams more = params;
    ++more.grammar.iterations;
    QVERIFY(shareOf(before, grownTree(more, Stage::Skeleton), afterOneMore(params, *before.symbols), 1)
                .keeps(0.99));
    // The trunk one piece longer.
    const std::string piece = preset == "Fern2D" ? "F" : "B";
    NodeParams longer = params;
    longer.grammar.axiom = piece + params.grammar.axiom;
    const TreeResult grown = grownTree(longer, Stage::Skeleton);
    QVERIFY(shareOf(before, grown, shifted(steps, 0, grown.grown->size() - steps), 2).keeps(0.99));
    // A twig in front.
    NodeParams twig = params;
    twig.grammar.axiom = "[+" + piece + "]" + params.grammar.axiom;
    const TreeResult twigged = grownTree(twig, Stage::Skeleton);
    QVERIFY(shareOf(before, twigged, shifted(steps, 0, twigged.grown->size() - steps), 3).keeps(0.95));
}

void TestEditShares::otherNumbers()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    params.grammar.stochastic = true;
    const TreeResult before = grownTree(params, Stage::Skeleton);
    const StepMap same = shifted(before.grown->size(), 0, 0);
    // A new seed.
    NodeParams seeded = params;
    seeded.grammar.seed = 77;
    const Share share = shareOf(before, grownTree(seeded, Stage::Skeleton), same, 4);
    QVERIFY(share.keeps(1.0));
    for (double* number : {&params.turtle.theta, &params.turtle.alpha, &params.turtle.decay,
                           &params.variation.angle, &params.variation.length}) {
        const double was = std::exchange(*number, *number * 1.1);
        params.turtle.decay = std::min(params.turtle.decay, 1.0);
        QVERIFY(shareOf(before, grownTree(params, Stage::Skeleton), same, 5).keeps(0.95));
        *number = was;
    }
}

RAMURE_SUITE(TestEditShares)

} // namespace tst_edit_shares

#include "tst_edit_shares.moc"
