#include "core/generators/variety.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/named_seeds.h"
#include "core/presets/presets.h"
#include "core/skeleton/measures.h"
#include "tests/support/suite.h"
#include <cmath>
#include <set>

namespace tst_measures {

using namespace ramure;

class TestMeasures : public QObject
{
    Q_OBJECT

    static TreeMeasures grown(const Preset& preset, std::int64_t seed)
    {
        TreePipeline pipeline;
        return measuresOf(*pipeline.evaluate(reseeded(preset.params, seed), Stage::Skeleton)->skeleton);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void noTreeHasNoMeasures()
    {
        const TreeMeasures none = measuresOf({});
        QVERIFY(none.height == 0.0 && none.stemDiameter == 0.0 && none.crownWidth == 0.0);
        Skeleton low;
        low.add(noIndex, {0, 0, 0}, {0, 1.2, 0}, 0.1, 0.1);
        QCOMPARE(measuresOf(low).height, 1.2);
        QCOMPARE(measuresOf(low).stemDiameter, 0.0);
    }
    void stemsCountTogether()
    {
        Skeleton tree;
        const Index foot = tree.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.5, 0.5);
        tree.add(foot, {0, 1, 0}, {0, 2, 0}, 0.4, 0.2);    // 0.34 at 1.3 m
        tree.add(foot, {0, 1, 0}, {0.1, 2, 0}, 0.4, 0.2);  // a second trunk
        tree.add(foot, {0, 1, 0}, {2, 3, 0}, 0.4, 0.2, 1); // a limb
        tree.add(foot, {0, 1, 0}, {-2, 0.5, 0}, 0.4, 0.2); // falls
        QVERIFY(std::abs(measuresOf(tree).stemDiameter - 2.0 * 0.34 * std::sqrt(2.0)) < 1e-12);
        QCOMPARE(measuresOf(tree).height, 3.0);
    }
    void crownsAreMeasuredAllRound()
    {
        Skeleton tree;
        const Index trunk = tree.add(noIndex, {0, 0, 0}, {0, 5, 0}, 0.5, 0.5);
        for (int i = 0; i < 360; ++i) {
            const double angle = i * 3.14159265358979 / 180.0;
            tree.add(trunk, {0, 5, 0}, {2.0 * std::cos(angle), 5, 2.0 * std::sin(angle)}, 0.1, 0.1, 1);
        }
        QVERIFY(std::abs(measuresOf(tree).crownWidth - 4.0) < 0.001);
    }
    void everySpeciesHasNamedSeeds()
    {
        int measured = 0;
        for (const Preset& preset : presets()) {
            const auto* seeds = namedSeeds(preset.name);
            QCOMPARE(seeds != nullptr, *preset.latin != '\0');
            if (!seeds)
                continue;
            QCOMPARE(std::set(seeds->begin(), seeds->end()).size(), namedSeedCount);
            if (test::isSanitized && preset.ages.front() != 0) // their growth has suites of its own
                continue;
            std::vector<TreeMeasures> trees;
            TreeMeasures mean;
            for (const std::int64_t seed : *seeds) {
                trees.push_back(grown(preset, seed));
                mean.height += trees.back().height / double(namedSeedCount);
                mean.stemDiameter += trees.back().stemDiameter / double(namedSeedCount);
                mean.crownWidth += trees.back().crownWidth / double(namedSeedCount);
            }
            const auto spread = [&trees](std::size_t i) { return trees[i].crownWidth / trees[i].height; };
            QVERIFY2(trees[1].height > trees[2].height && spread(3) > spread(4), preset.name);
            const PublishedMeasures* published = publishedMeasures(preset.latin);
            if (!published ||
                preset.ages.front() != 0) // those that grow are measured when old: tst_grown_species
                continue;
            ++measured;
            const auto near = [](double ours, double theirs) {
                return std::abs(ours / theirs - 1.0) <= 0.15;
            };
            QVERIFY2(near(mean.height, published->mean.height), preset.name);
            QVERIFY2(near(mean.stemDiameter, published->mean.stemDiameter), preset.name);
            QVERIFY2(near(mean.crownWidth, published->mean.crownWidth), preset.name);
        }
        QCOMPARE(std::size_t(measured), publishedMeasures().size());
        QVERIFY(measured >= 40);
    }
};

RAMURE_SUITE(TestMeasures)

} // namespace tst_measures

#include "tst_measures.moc"
