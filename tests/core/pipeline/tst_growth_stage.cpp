#include "core/pipeline/longest_life.h"
#include "core/pipeline/stage_hashes.h"
#include "core/presets/presets.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"
#include <set>

namespace tst_growth_stage {

using namespace ramure;
using namespace ramure::test;

namespace {

NodeParams oak(double age)
{
    NodeParams params = *presetParams("EnglishOak");
    params.growth.age = age;
    return params;
}

std::vector<const Preset*> grownPresets()
{
    std::vector<const Preset*> grown;
    for (const Preset& preset : presets())
        if (preset.params.generator.kind == EditOperation::Growth)
            grown.push_back(&preset);
    return grown;
}

std::vector<std::uint64_t> addressesAt(double age)
{
    std::vector<std::uint64_t> addresses;
    for (const Axis& axis : axesOf(*grownTree(oak(age), Stage::Skeleton).skeleton).axes)
        addresses.push_back(axis.address);
    std::ranges::sort(addresses);
    return addresses;
}

} // namespace

/// Trees that grow by years, through the pipeline.
class TestGrowthStage : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void impossibleLivesSayWhy()
    {
        NodeParams params = oak(60.0);
        QVERIFY(!setParam(params, *findParam("growth.age"), 10'000.0));
        QVERIFY(!setParam(params, *findParam("growth.age"), -1.0));
        params.growth.sunlight = 0.0;
        TreePipeline pipeline;
        const auto dead = pipeline.evaluate(params, Stage::Skeleton);
        QVERIFY(!dead);
        QCOMPARE(dead.error().path, std::string("growth.age"));
        QVERIFY(QByteArray(dead.error().message().c_str()).contains("for want of light"));
        params = oak(60.0);
        params.growth.crownWidth = 150.0;
        params.growth.height = 150.0;
        params.growth.internode = 0.001;
        const auto huge = pipeline.evaluate(params, Stage::Skeleton);
        QVERIFY(!huge);
        QVERIFY(huge.error().path.starts_with("growth."));
    }

    void aSeedlingIsOneShoot()
    {
        const TreeResult tree = grownTree(oak(0.0), Stage::Mesh);
        QCOMPARE(axesOf(*tree.skeleton).axes.size(), std::size_t(1));
        QVERIFY(tree.report->valid);
    }

    /// The ages of ten years are cut out of one life: the dearest stage need not run again.
    void agesShareALife()
    {
        QCOMPARE(StageHashes(oak(41.0))[Stage::Symbols], StageHashes(oak(50.0))[Stage::Symbols]);
        QVERIFY(StageHashes(oak(41.0))[Stage::Skeleton] != StageHashes(oak(50.0))[Stage::Skeleton]);
        QVERIFY(StageHashes(oak(51.0))[Stage::Symbols] != StageHashes(oak(50.0))[Stage::Symbols]);
        // Whichever life it is cut out of, and whatever was looked at before.
        NodeParams longer = oak(50.0);
        longer.growth.age = 88.0;
        TreePipeline pipeline;
        QVERIFY(pipeline.evaluate(longer, Stage::Skeleton));
        for (const double age : {33.0, 47.5, 12.25}) {
            const auto again = pipeline.evaluate(oak(age), Stage::Skeleton);
            QVERIFY2(again, why(again).constData());
            QVERIFY(*again->skeleton == *grownTree(oak(age), Stage::Skeleton).skeleton);
        }
    }

    /// Years that were lived are not grown again, those before a cancel neither; and another life is begun
    /// from the seed.
    void anOlderTreeGoesOn()
    {
        LongestLife life;
        double first = 0.0;
        const auto grow = [&](const NodeParams& params, std::stop_token stop = {}) {
            first = 0.0;
            const Progress progress{stop, [&](double done) { first = first == 0.0 ? done : first; }};
            return life.grow(StageHashes(params).life(), params, progress);
        };
        std::stop_source source;
        source.request_stop();
        const auto none = grow(oak(40.0), source.get_token());
        QVERIFY(!none);
        QCOMPARE(none.error().code, ErrorCode::Cancelled);
        QVERIFY(grow(oak(40.0)));
        QCOMPARE(first, 1.0 / 40.0);
        const auto older = grow(oak(50.0));
        QCOMPARE(first, 41.0 / 50.0);
        const auto again = grow(oak(20.0));
        QVERIFY(older && again && older->history == again->history);
        for (const double age : {9.0, 33.5, 50.0})
            QVERIFY(*growSkeleton(*older, oak(age)) == *grownTree(oak(age), Stage::Skeleton).skeleton);
        NodeParams other = oak(50.0);
        other.grammar.seed = 7;
        QVERIFY(grow(other));
        QCOMPARE(first, 1.0 / 50.0);
        other.growth.age = 60.0;
        other.growth.sunlight = 0.0;
        QVERIFY(grow(other)); // it dies, and does so again
        QVERIFY(grow(other)->history->diedAt > 0);
        QVERIFY(StageHashes(oak(40.0)).life() == StageHashes(oak(90.0)).life());
        QCOMPARE(StageHashes(NodeParams()).life(), std::uint64_t(0));
    }

    /// However the age goes up and down, with a limb cut on the way.
    void agesOfALifeAreThoseOfAFreshOne()
    {
        NodeParams params = oak(60.0);
        params.growth.density = 0.3;
        const TreeAxes axes = axesOf(*grownTree(params, Stage::Skeleton).grown);
        const auto limb = std::ranges::find(axes.axes, Index(1), &Axis::order);
        TreeEdit cut = editOf(EditOperation::Cut, limb->address);
        cut.at = 0.5;
        cut.year = 25.0;
        cut.id = 1;
        params.edits = {cut};
        TreePipeline pipeline;
        for (const double age : {12.0, 26.0, 8.5, 44.0, 61.0, 25.0}) {
            params.growth.age = age;
            const auto tree = pipeline.evaluate(params, Stage::Skeleton);
            QVERIFY2(tree, why(tree).constData());
            QVERIFY(*tree->skeleton == *grownTree(params, Stage::Skeleton).skeleton);
        }
    }

    void axesKeepTheirAddresses()
    {
        const auto young = addressesAt(30.0), old = addressesAt(45.0);
        std::vector<std::uint64_t> kept;
        std::ranges::set_intersection(young, old, std::back_inserter(kept));
        QVERIFY(!kept.empty() && old.size() > young.size());
        QCOMPARE(std::set<std::uint64_t>(old.begin(), old.end()).size(), old.size());
    }

    /// An edit that was made at one age is there at another.
    void editsStayOverTheYears()
    {
        NodeParams params = oak(30.0);
        params.growth.density = 0.3;
        const Skeleton grown = *grownTree(params, Stage::Skeleton).grown;
        const TreeAxes axes = axesOf(grown);
        EditContext context(grown, {});
        int made = 0, there = 0;
        for (const Axis& axis : axes.axes)
            if (axis.order == 1 && axis.length > 1.0 && made < 12) {
                TreeEdit bend = editOf(EditOperation::Bend, axis.address);
                bend.rotation = {0.1, 0.0, 0.05};
                made += make(params, bend, context) ? 1 : 0;
            }
        QVERIFY(made >= 4);
        params.growth.age = 34.0;
        const TreeResult later = grownTree(params, Stage::Skeleton);
        for (const EditOutcome& outcome : *later.edits)
            there += outcome.state == EditState::ByAddress ? 1 : 0;
        QVERIFY2(there >= made / 2, qPrintable(QString::number(there))); // the others were shed
    }

    /// Of forty ages of each species two, others in each RAMURE_ROUND: continuous integration counts them by
    /// its commits. RAMURE_AGES asks for so many at once.
    void everyAgeIsWhole_data()
    {
        QTest::addColumn<QByteArray>("preset");
        const auto grown = grownPresets();
        for (std::size_t i = 0; i < grown.size(); i += isSanitized ? 4 : 1)
            QTest::newRow(grown[i]->name) << QByteArray(grown[i]->name);
    }
    void everyAgeIsWhole()
    {
        QFETCH(QByteArray, preset);
        const auto grown = grownPresets();
        const Preset& tree =
            **std::ranges::find(grown, std::string_view(preset.constData()),
                                [](const Preset* each) { return std::string_view(each->name); });
        const int asked = qEnvironmentVariableIntValue("RAMURE_AGES"), ages = asked > 0 ? asked : 2;
        constexpr int rounds = 20;
        const int round = qEnvironmentVariableIntValue("RAMURE_ROUND") % rounds;
        TreePipeline pipeline;
        for (int i = 0; i < ages; ++i) {
            NodeParams params = tree.params;
            const int place = asked > 0 ? i : i * rounds + round;
            params.grammar.seed = place % 6 + 1;
            params.growth.age = tree.ages[2] * (place + 0.37) / (asked > 0 ? ages : 2 * rounds);
            const auto made = pipeline.evaluate(params, Stage::Mesh);
            QVERIFY2(made, why(made).constData());
            const QByteArray label = QByteArray::number(params.growth.age) + " years";
            QVERIFY2(made->report->valid, label.constData());
            QCOMPARE(made->report->components, made->branches->roots);
            QVERIFY2(checkMesh(made->branches->mesh).perfect(made->branches->roots), label.constData());
        }
    }
};

RAMURE_SUITE(TestGrowthStage)

} // namespace tst_growth_stage

#include "tst_growth_stage.moc"
