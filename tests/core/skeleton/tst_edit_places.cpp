#include "core/math/random.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/skeleton/edit_places.h"
#include "tests/support/step_map.h"
#include "tests/support/suite.h"

#include <functional>
#include <set>

namespace tst_edit_places {

using namespace ramure;
using test::afterOneMore, test::shifted, test::StepMap;

namespace {

TreeResult grown(const NodeParams& params)
{
    TreePipeline pipeline;
    auto result = pipeline.evaluate(params, Stage::Simplified);
    if (!result)
        qFatal("%s", test::why(result).constData());
    return std::move(*result);
}

/// Places by the key of their branch.
using Places = std::map<std::uint64_t, BranchPlace>;

/// Of a hundred branches, each once.
Places randomPlaces(const TreeResult& tree, std::uint64_t seed)
{
    Random random(seed, RandomStream::Test);
    const Skeleton& skeleton = tree.simplified->skeleton;
    const TreeAxes axes = axesOf(*tree.skeleton);
    const std::uint64_t mark = treeMark(axes);
    Places places;
    while (places.size() < 100) {
        const Index branch = random.below(skeleton.size());
        places[skeleton.key[branch]] = placeOf(axes, skeleton.source[branch], mark);
    }
    return places;
}

/// By the key of the branch that each was made of; those without a place are left out.
std::map<std::uint64_t, Index> foundIn(const TreeResult& tree, const Places& places)
{
    std::vector<BranchPlace> wanted;
    for (const auto& [key, place] : places)
        wanted.push_back(place);
    const std::vector<Index> branches = findBranches(*tree.skeleton, *tree.simplified, wanted);
    std::map<std::uint64_t, Index> found;
    std::size_t i = 0;
    for (const auto& [key, place] : places)
        if (const Index branch = branches[i++]; branch != noIndex)
            found.emplace(key, branch);
    return found;
}

struct Share
{
    int right = 0, wrong = 0, unplaced = 0; ///< of the edits whose place is still there
    int listed = 0, elsewhere = 0;          ///< of those whose place is gone
};

Share shareOf(const TreeResult& before, const TreeResult& after, const StepMap& map, std::uint64_t seed)
{
    const Places edits = randomPlaces(before, seed);
    const auto found = foundIn(after, edits);
    Share share;
    for (Index i = 0; i < before.simplified->skeleton.size(); ++i) {
        const std::uint64_t name = before.simplified->skeleton.key[i];
        if (!edits.contains(name))
            continue;
        const Index step = map[before.simplified->skeleton.source[i]];
        const auto at = found.find(name);
        if (step == noIndex)
            ++(at == found.end() ? share.listed : share.elsewhere);
        else if (at == found.end())
            ++share.unplaced;
        else
            ++(at->second == after.simplified->mergedInto[step] ? share.right : share.wrong);
    }
    return share;
}

/// Asked for by a variable: how many edits kept their places.
void tell(const char* preset, const char* change, const Share& share)
{
    if (qEnvironmentVariableIsSet("RAMURE_EDIT_SHARES"))
        qInfo("%s, %s: %d right, %d elsewhere, %d without; gone: %d listed, %d elsewhere", preset, change,
              share.right, share.wrong, share.unplaced, share.listed, share.elsewhere);
}

bool keeps(const Share& share, double least)
{
    const int all = share.right + share.wrong + share.unplaced;
    return share.right >= least * all;
}

} // namespace

/// Edits find their branches again.
class TestEditPlaces : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingIsForced();
    void addressesKnowNoPieces();
    void unchangedTreesKeepAll_data() { addPresets(); }
    void unchangedTreesKeepAll();
    void newSeeds_data() { addPresets(); }
    void newSeeds();
    void oneIterationMore_data() { addPresets(); }
    void oneIterationMore();
    void longerTrunks_data() { addPresets(); }
    void longerTrunks();
    void twigsInFront_data() { addPresets(); }
    void twigsInFront();
    void otherNumbers_data() { addPresets(); }
    void otherNumbers();

private:
    static void addPresets();
};

void TestEditPlaces::addPresets()
{
    QTest::addColumn<QByteArray>("preset");
    for (const Preset& preset : courseworkPresets())
        QTest::newRow(preset.name) << QByteArray(preset.name);
}

void TestEditPlaces::nothingIsForced()
{
    QVERIFY(findPlaces({}, {}).empty());
    const BranchPlace nothing;
    const std::vector<const BranchPlace*> one{&nothing};
    QCOMPARE(findPlaces({}, one).front().branch, noIndex);
    const TreeResult tree = grown(*presetParams("SmallTree"));
    // On another tree altogether nothing lands, or what does looks alike.
    const TreeResult other = grown(*presetParams("Fern2D"));
    QVERIFY(foundIn(other, randomPlaces(tree, 1)).size() < 50);
}

void TestEditPlaces::addressesKnowNoPieces()
{
    NodeParams params;
    params.grammar.rules.clear();
    params.grammar.iterations = 0;
    const auto addresses = [&params](const char* axiom) {
        params.grammar.axiom = axiom;
        std::vector<std::uint64_t> all;
        for (const Axis& axis : axesOf(*grown(params).skeleton).axes)
            all.push_back(axis.address);
        return all;
    };
    const auto plain = addresses("F[+F[-F]]F[^F][_F]F");
    QCOMPARE(plain.size(), std::size_t{5});
    QCOMPARE(std::set(plain.begin(), plain.end()).size(), plain.size());
    QVERIFY(addresses("FFFF[+FFF[-FF]F]FF[^F][_FFFF]") == plain);
    QVERIFY(addresses("F[+F[-F]]F[^F]F").back() == plain[3]);
    params.grammar.axiom = "FF[+F[-F]]F";
    const TreeResult tree = grown(params);
    const TreeAxes axes = axesOf(*tree.skeleton);
    QCOMPARE(axes.axes[0].length, 3 * params.turtle.alpha);
    QCOMPARE(axes.axes[0].forks, Index{1});
    QCOMPARE(axes.axes[1].parent, Index{0});
    QCOMPARE(axes.axes[1].s, 2 * params.turtle.alpha);
    QVERIFY(std::abs(axes.axes[1].share - 2.0 / 3.0) < 1e-12);
    QVERIFY(std::abs(axes.axes[1].downAngle - params.turtle.theta) < 1e-9);
    QCOMPARE(axes.axes[2].order, Index{2});
    QCOMPARE(std::vector<Index>(axes.nodesOf(0).begin(), axes.nodesOf(0).end()),
             (std::vector<Index>{0, 1, 4}));
}

void TestEditPlaces::unchangedTreesKeepAll()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    const TreeResult tree = grown(params);
    const StepMap same = shifted(tree.skeleton->size(), 0, 0);
    QCOMPARE(shareOf(tree, tree, same, 1).right, 100);
    // Whatever is merged, and whatever else is set.
    params.simplify.enabled = false;
    QCOMPARE(shareOf(tree, grown(params), same, 2).right, 100);
}

void TestEditPlaces::newSeeds()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    params.grammar.stochastic = true;
    const TreeResult before = grown(params);
    params.grammar.seed = 77;
    const TreeResult after = grown(params);
    QCOMPARE(after.skeleton->size(), before.skeleton->size());
    const Share share = shareOf(before, after, shifted(before.skeleton->size(), 0, 0), 3);
    tell(preset.constData(), "new seed", share);
    QCOMPARE(share.right, 100);
}

void TestEditPlaces::oneIterationMore()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    const TreeResult before = grown(params);
    const StepMap map = afterOneMore(params, *before.symbols);
    ++params.grammar.iterations;
    const Share share = shareOf(before, grown(params), map, 4);
    tell(preset.constData(), "iterations + 1", share);
    QVERIFY(keeps(share, 0.99));
}

void TestEditPlaces::longerTrunks()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    const TreeResult before = grown(params);
    const std::string first = preset == "Fern2D" ? "F" : "B";
    params.grammar.axiom = first + params.grammar.axiom;
    const TreeResult after = grown(params);
    const Index steps = before.skeleton->size();
    const Share share = shareOf(before, after, shifted(steps, 0, after.skeleton->size() - steps), 5);
    tell(preset.constData(), "a longer trunk", share);
    QVERIFY(keeps(share, 0.99));
}

void TestEditPlaces::twigsInFront()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    const TreeResult before = grown(params);
    const Index steps = before.skeleton->size();
    const std::string axiom = params.grammar.axiom;
    const std::string twig = preset == "Fern2D" ? "[+F]" : "[+B]";
    params.grammar.axiom = twig + axiom;
    const TreeResult atFoot = grown(params);
    const Share share = shareOf(before, atFoot, shifted(steps, 0, atFoot.skeleton->size() - steps), 6);
    tell(preset.constData(), "a twig at the foot", share);
    QVERIFY(keeps(share, 0.95));
    if (preset == "Fern2D")
        return; // its axiom is one symbol, there is no place on it
    const std::size_t at = axiom.find_first_of("BE") + 1;
    params.grammar.axiom = axiom.substr(0, at) + twig + axiom.substr(at);
    const TreeResult onTrunk = grown(params);
    const Share above = shareOf(before, onTrunk, shifted(steps, 1, onTrunk.skeleton->size() - steps), 7);
    tell(preset.constData(), "a twig on the trunk", above);
    QVERIFY(keeps(above, 0.95));
}

void TestEditPlaces::otherNumbers()
{
    QFETCH(QByteArray, preset);
    NodeParams params = *presetParams(preset.constData());
    params.grammar.stochastic = true;
    const TreeResult before = grown(params);
    const StepMap same = shifted(before.skeleton->size(), 0, 0);
    for (const double factor : {0.9, 1.1})
        for (double* number :
             {&params.turtle.theta, &params.turtle.alpha, &params.turtle.decay, &params.variation.angle,
              &params.variation.length, &params.variation.radius, &params.simplify.rotationThreshold}) {
            const double was = std::exchange(*number, *number * factor);
            params.turtle.decay = std::min(params.turtle.decay, 1.0);
            const Share share = shareOf(before, grown(params), same, 8);
            tell(preset.constData(), "one number by 10 %", share);
            QVERIFY(keeps(share, 0.95));
            *number = was;
        }
}

RAMURE_SUITE(TestEditPlaces)

} // namespace tst_edit_places

#include "tst_edit_places.moc"
