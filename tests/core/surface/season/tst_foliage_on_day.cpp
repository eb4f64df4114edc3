#include "core/surface/season/foliage_on_day.h"

#include "core/params/param_def.h"
#include "core/params/param_relevance.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/season/phenology.h"
#include "tests/support/colour_difference.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tst_foliage_on_day {

using namespace ramure;

namespace {

constexpr double alpha = 0.2;

const Skeleton& skeleton()
{
    static const auto tree = test::presetSkeleton({"TinyTree"});
    return *tree;
}

NodeParams treeOf(LeafShape shape, FruitKind fruit = FruitKind::Faithful)
{
    NodeParams params;
    params.leaf.shape = shape;
    params.fruit.kind = fruit;
    params.foliage = {0.1, 10, fruit == FruitKind::Faithful ? 0.0 : 1.0, 1};
    params.turtle.alpha = alpha;
    return params;
}

Foliage on(double day, NodeParams params)
{
    params.season.day = day;
    auto made = foliageOf(skeleton(), params);
    if (!made)
        qFatal("%s", made.error().message().c_str());
    return std::move(*made);
}

Foliage on(double day, LeafShape shape)
{
    return on(day, treeOf(shape));
}

using Address = std::pair<Index, std::uint32_t>;

std::map<Address, const FoliageItem*> byAddress(const Foliage& foliage)
{
    std::map<Address, const FoliageItem*> out;
    for (const FoliageItem& leaf : foliage.leaves)
        out[{leaf.branch, leaf.number}] = &leaf;
    return out;
}

/// The share of leaves, buds not counted, that hang.
double share(const Foliage& foliage)
{
    const auto leaves =
        std::ranges::count_if(foliage.leaves, [](const FoliageItem& leaf) { return leaf.size > 0.3F; });
    return double(leaves) / double(foliage.leaves.size() + foliage.shed);
}

YearDates dates(LeafShape shape, SeasonClimate climate = SeasonClimate::Oceanic)
{
    return datesOf(plantYear(shape), climateOf(climate)).value();
}

double hue(const glm::vec3& srgb)
{
    const glm::dvec3 lab = test::labOf(glm::dvec3(srgb));
    return std::atan2(lab.z, lab.y) * 180.0 / 3.14159265358979;
}

} // namespace

class TestFoliageOnDay : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void daysOutsideTheYearAreRefused()
    {
        NodeParams params;
        for (const double day : {-1.0, 365.5, 400.0, std::nan("")})
            QVERIFY(!setParam(params, *findParam("season.day"), day));
        // Whoever asks all the same gets some day.
        for (const double day : {1.0, 400.0, 1e9})
            QVERIFY(on(day, LeafShape::Oak).leaves.size() <= on(200, LeafShape::Oak).leaves.size());
    }

    void bareTreesAndFaithfulLeavesStay()
    {
        NodeParams bare = treeOf(LeafShape::Oak, FruitKind::Acorn);
        bare.foliage.leavesDensity = 0;
        bare.foliage.applesProbability = 0.0;
        for (const double day : {1.0, 110.0, 200.0, 310.0}) {
            const Foliage none = on(day, bare);
            QVERIFY(none.leaves.empty() && none.apples.empty() && none.shed == 0);
        }
        const Foliage faithful = on(10, LeafShape::Faithful);
        QVERIFY(!faithful.leaves.empty() && !faithful.form.onDay && faithful.shed == 0);
        QVERIFY(foliageOnDay(Foliage(), Skeleton(), {100.0}, alpha).leaves.empty());
    }

    void withoutADayNothingChanges()
    {
        NodeParams params = treeOf(LeafShape::Maple);
        params.leaf.season = 0.7;
        const Foliage old = on(0.0, params), half = on(0.5, params);
        QVERIFY(old.shed > 0 && !old.form.onDay && old.leaves.size() == half.leaves.size());
        // And on a day the other season does not count.
        QVERIFY(on(200, params).shed == 0);
    }

    void everyLeafHasItsPlace()
    {
        for (const LeafShape shape : {LeafShape::Birch, LeafShape::Larch, LeafShape::Spruce}) {
            const Foliage summer = on(200, shape);
            const auto places = byAddress(summer);
            for (double day = 1.0; day < 366.0; day += 7.0) {
                const Foliage now = on(day, shape);
                QCOMPARE(now.leaves.size() + now.shed, summer.leaves.size() + summer.shed);
                for (const auto& [address, leaf] : byAddress(now)) {
                    const auto same = places.find(address);
                    QVERIFY(same == places.end() || same->second->position == leaf->position);
                    QVERIFY(glm::all(glm::lessThanEqual(leaf->tint, glm::vec3(1.0F))));
                    QVERIFY(leaf->size > 0.0F && leaf->tone == 1.0F);
                }
            }
        }
    }

    void winterIsBareAndSummerIsNot()
    {
        for (const LeafShape shape : {LeafShape::Birch, LeafShape::Maple, LeafShape::Larch, LeafShape::Ash}) {
            QVERIFY(on(15, shape).leaves.empty() && on(364, shape).leaves.empty());
            const Foliage summer = on(200, shape);
            QVERIFY(summer.shed == 0 && share(summer) == 1.0);
        }
    }

    void leavesUnfoldFromTheirBuds()
    {
        for (const LeafShape shape : {LeafShape::Beech, LeafShape::Oak, LeafShape::Birch}) {
            const YearDates year = dates(shape);
            const auto meanSize = [&](double day) {
                double sum = 0.0;
                const Foliage now = on(day, treeOf(shape));
                for (const FoliageItem& leaf : now.leaves)
                    sum += double(leaf.size);
                return sum / double(now.leaves.size() + now.shed);
            };
            double before = meanSize(year.burst);
            const double full = meanSize(200);
            QVERIFY(before < 0.45 * full);
            for (double day = year.burst; day < year.unfolded + 12.0; day += 2.0) {
                const double now = meanSize(day);
                // Brown leaves of the year before still fall when buds burst.
                QVERIFY(now >= before || day < year.burst + 10.0);
                before = now;
            }
            QVERIFY(std::abs(before - full) < 0.01 * full);
        }
    }

    /// A tenth of the leaves has fallen on the first date, nine tenths on the second.
    void leavesFallOverTheirWeeks()
    {
        for (const LeafShape shape :
             {LeafShape::Birch, LeafShape::Maple, LeafShape::Larch, LeafShape::Linden}) {
            for (const SeasonClimate climate : {SeasonClimate::Oceanic, SeasonClimate::Boreal}) {
                const YearDates year = dates(shape, climate);
                NodeParams params = treeOf(shape);
                params.season.climate = climate;
                const double first = share(on(year.firstFall, params)),
                             last = share(on(year.lastFall, params));
                QVERIFY2(first > 0.82 && first < 0.97, qPrintable(QString::number(first)));
                QVERIFY2(last > 0.03 && last < 0.18, qPrintable(QString::number(last)));
            }
        }
    }

    void whatFellDoesNotComeBackBeforeSpring()
    {
        std::set<Address> before;
        for (const FoliageItem& leaf : on(250, LeafShape::Oak).leaves)
            before.insert({leaf.branch, leaf.number});
        for (double day = 260.0; day <= 365.0; day += 5.0) {
            std::set<Address> now;
            for (const FoliageItem& leaf : on(day, LeafShape::Oak).leaves)
                now.insert({leaf.branch, leaf.number});
            QVERIFY(std::ranges::includes(before, now));
            before = now;
        }
    }

    void oaksAndBeechesKeepBrownLeaves()
    {
        for (const LeafShape shape : {LeafShape::Oak, LeafShape::Beech}) {
            const Foliage winter = on(20, shape);
            const double kept = share(winter);
            QVERIFY2(kept >= 0.05 && kept <= 0.2, qPrintable(QString::number(kept)));
            QVERIFY(hue(winter.meanColour) < 80.0 && hue(winter.meanColour) > 40.0);
            QVERIFY(share(on(364, shape)) >= kept - 0.01);
        }
    }

    void everySpeciesHasItsAutumn()
    {
        const auto autumn = [](LeafShape shape) {
            return hue(on(dates(shape).turned + 6.0, shape).meanColour);
        };
        const auto summer = [](LeafShape shape) { return hue(on(200, shape).meanColour); };
        for (const LeafShape shape : {LeafShape::Birch, LeafShape::Maple, LeafShape::Oak, LeafShape::Beech,
                                      LeafShape::Larch, LeafShape::Ginkgo, LeafShape::Rowan})
            QVERIFY2(summer(shape) > 105.0 && autumn(shape) < 100.0,
                     qPrintable(QString::number(summer(shape))));
        for (const LeafShape yellow :
             {LeafShape::Birch, LeafShape::Ginkgo, LeafShape::Larch, LeafShape::Aspen})
            for (const LeafShape red : {LeafShape::Maple, LeafShape::JapaneseMaple, LeafShape::Sweetgum,
                                        LeafShape::RedOak, LeafShape::Cherry})
                QVERIFY(autumn(yellow) > autumn(red) + 8.0);
        // A Norway maple beside a sugar maple.
        NodeParams maple = treeOf(LeafShape::Maple);
        const auto greenToRed = [&](double redness) {
            maple.season.redness = redness;
            const glm::vec3 mean = on(300, maple).meanColour;
            return mean.g / mean.r;
        };
        QVERIFY2(greenToRed(0.0) > 0.75, qPrintable(QString::number(greenToRed(0.0))));
        QVERIFY(greenToRed(1.0) < greenToRed(0.5) && greenToRed(0.5) < greenToRed(0.0));
        // Purple leaves hide their green.
        NodeParams purple = treeOf(LeafShape::Beech);
        purple.season.purple = true;
        const glm::vec3 copper = on(200, purple).meanColour;
        QVERIFY(copper.r > copper.g && copper.r < 110.0F);
    }

    void evergreensDropTheirOldestNeedles()
    {
        for (const LeafShape shape : {LeafShape::Spruce, LeafShape::ScotsPine, LeafShape::Magnolia}) {
            double least = 1.0, most = 0.0;
            for (double day = 1.0; day < 366.0; day += 7.0) {
                const double now = share(on(day, shape));
                least = std::min(least, now);
                most = std::max(most, now);
            }
            QVERIFY2(least > 0.5 && least < most, qPrintable(QString::number(least)));
        }
        // Young shoots are brighter.
        const auto light = [](double day) { return on(day, LeafShape::Spruce).meanColour.g; };
        const YearDates year = dates(LeafShape::Spruce);
        QVERIFY(light(year.unfolded) > light(250) + 1.0F);
        // Palms have no year.
        for (const LeafShape palm : {LeafShape::Palm, LeafShape::FanPalm}) {
            NodeParams params = treeOf(palm);
            QVERIFY(on(20, palm).shed == 0 && !on(200, palm).form.onDay);
            QVERIFY(!isRelevant(params, *findParam("season.day")));
        }
        QVERIFY(isRelevant(treeOf(LeafShape::Spruce), *findParam("season.day")));
    }

    void flowersComeBeforeFruit()
    {
        const NodeParams apple = treeOf(LeafShape::Apple, FruitKind::Apple);
        const YearDates year = dates(LeafShape::Apple);
        QVERIFY(on(30, apple).apples.empty());
        const Foliage spring = on(year.burst + 14.0, apple);
        QVERIFY(spring.apples.size() > 20 && spring.fruit.kind == FruitKind::Blossom);
        const Foliage june = on(year.burst + 45.0, apple), ripe = on(plantYear(LeafShape::Apple).ripe, apple);
        QVERIFY(june.fruit.kind == FruitKind::Apple && june.fruit.ripe == 0.0 && ripe.fruit.ripe == 1.0);
        QVERIFY(june.apples.size() == ripe.apples.size() &&
                june.apples.front().size < ripe.apples.front().size);
        QVERIFY(on(330, apple).apples.empty());
        // Cherries flower before their leaves are out.
        const Foliage cherry =
            on(dates(LeafShape::Cherry).burst + 1.0, treeOf(LeafShape::Cherry, FruitKind::Cherry));
        QVERIFY(!cherry.apples.empty() && share(cherry) < 0.5);
        const Foliage bare =
            on(dates(LeafShape::Cherry).burst - 5.0, treeOf(LeafShape::Cherry, FruitKind::Cherry));
        QVERIFY(share(bare) < 0.2 && 2 * bare.apples.size() > cherry.apples.size() && bare.fruit.head > 1);
        QVERIFY(on(20, treeOf(LeafShape::Larch, FruitKind::Cone)).apples.size() > 0);
    }

    /// Neither the mesher nor the placement runs for another day.
    void aDayMovesNoLeaf()
    {
        NodeParams params = presetParams("TinyTree").value();
        params.leaf.shape = LeafShape::Birch;
        TreePipeline pipeline;
        const auto none = pipeline.evaluate(params);
        QVERIFY(none && none->placed == none->foliage);
        params.season.day = 200.0;
        const auto summer = pipeline.evaluate(params);
        params.season.day = 20.0;
        const auto winter = pipeline.evaluate(params);
        QVERIFY(summer && winter);
        for (const auto& day : {summer, winter})
            QVERIFY(day->branches == none->branches && day->placed == none->placed &&
                    day->foliage != none->foliage);
        QVERIFY(winter->foliage->leaves.empty() && winter->leaves->empty());
        QCOMPARE(summer->foliage->leaves.size(), none->foliage->leaves.size());
        // The other season does not count then, and counts again without a day.
        params.leaf.season = 1.0;
        params.season.day = 200.0;
        QCOMPARE(pipeline.evaluate(params)->foliage->shed, std::size_t(0));
        params.season.day = 0.0;
        QVERIFY(pipeline.evaluate(params)->foliage->leaves.empty());
    }

    void phasesAreThoseOfTheLeaves()
    {
        const Foliage summer = on(200, LeafShape::Maple);
        const auto phases = leafPhases(summer, skeleton());
        QCOMPARE(phases.size(), summer.leaves.size());
        QVERIFY(leafPhases(Foliage(), Skeleton()).empty());
        const auto [least, most] = std::ranges::minmax(phases);
        QVERIFY(least >= 0.0F && most <= 1.0F && most - least > 0.4F);
        // Who turns first is redder on the day when half of them have turned.
        const Foliage turned = on(dates(LeafShape::Maple).turned, LeafShape::Maple);
        const auto now = byAddress(turned);
        double early = 0.0, late = 0.0;
        int earlies = 0, lates = 0;
        for (std::size_t i = 0; i < phases.size(); ++i) {
            const auto leaf = now.find({summer.leaves[i].branch, summer.leaves[i].number});
            if (leaf == now.end())
                continue;
            const glm::vec3& tint = leaf->second->tint;
            (phases[i] < 0.4F ? early : late) += double(tint.r - tint.g);
            ++(phases[i] < 0.4F ? earlies : lates);
        }
        QVERIFY(earlies > 0 && lates > 0 && early / earlies > late / lates);
    }
};

RAMURE_SUITE(TestFoliageOnDay)

} // namespace tst_foliage_on_day

#include "tst_foliage_on_day.moc"
