#include "core/scatter/stand.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace tst_stand {

using namespace ramure;

namespace {

/// A quarter of a hectare, sown with 1,000 stems.
std::vector<Seedling> plot(const StandSpecies& species, std::uint64_t seed)
{
    Random random(seed, RandomStream::Test);
    std::vector<Seedling> seedlings;
    for (int i = 0; i < 1000; ++i) {
        const double x = random.range(-25.0, 25.0), z = random.range(-25.0, 25.0);
        seedlings.push_back({{x, z}, &species});
    }
    return seedlings;
}

/// As foresters count: stems a hectare, height (m) and diameter (cm) of the tree of mean basal area.
struct Table
{
    double stems = 0.0, height = 0.0, diameter = 0.0;
};

Table tableOf(const std::vector<StandTree>& trees)
{
    double area = 0.0, height = 0.0;
    for (const StandTree& tree : trees) {
        area += tree.diameter * tree.diameter;
        height += tree.height * tree.diameter * tree.diameter;
    }
    return {4.0 * double(trees.size()), height / area, 100.0 * std::sqrt(area / double(trees.size()))};
}

/// Of a yield table, first site class, at 50 and 80 years, and the exponent of self-thinning (Pretzsch and
/// Biber 2005); 0: none is published.
struct Published
{
    const char* species;
    Table at50, at80;
    double thinning;
};
constexpr Published published[] = {
    {"EuropeanBeech", {1104, 16.9, 14.5}, {391, 26.6, 28.3}, -1.789},
    {"EnglishOak", {666, 17.6, 18.7}, {312, 23.5, 30.0}, -1.424},
    {"NorwaySpruce", {705, 22.3, 24.4}, {466, 30.7, 35.2}, -1.664},
    {"ScotsPine", {829, 19.0, 20.5}, {430, 25.2, 31.0}, -1.593},
    {"DouglasFir", {445, 29.3, 35.5}, {282, 38.5, 49.2}, 0.0},
};

bool isWithin(double value, double of, double share)
{
    const bool fine = std::abs(value - of) <= share * of;
    if (!fine)
        qWarning("%g, not %g", value, of);
    return fine;
}

} // namespace

/// Trees that take each other's light.
class TestStand : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoStandIsRefused()
    {
        const StandSpecies& beech = *findStandSpecies("EuropeanBeech");
        const std::vector<Seedling> one{{{0.0, 0.0}, &beech}};
        const auto codeOf = [](const auto& grown) { return grown ? ErrorCode() : grown.error().code; };
        QCOMPARE(codeOf(grownStand({}, 10, 1)), ErrorCode::Invalid);
        for (const int years : {0, -1, 401, std::numeric_limits<int>::max()})
            QCOMPARE(codeOf(grownStand(one, years, 1)), ErrorCode::Invalid);
        for (const double x : {1001.0, -1e300, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()})
            QCOMPARE(codeOf(grownStand(std::vector<Seedling>{{{x, 0.0}, &beech}}, 10, 1)), ErrorCode::Limit);
        QCOMPARE(codeOf(grownStand(std::vector<Seedling>(mostSeedlings + 1, one.front()), 10, 1)),
                 ErrorCode::Limit);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(codeOf(grownStand(one, 10, 1, {stop.get_token(), {}})), ErrorCode::Cancelled);
        QVERIFY(!findStandSpecies("NoSuchTree"));
    }

    void aTreeAloneGrowsFreely()
    {
        for (const StandSpecies& species : standSpecies()) {
            const auto grown = grownStand(std::vector<Seedling>{{{3.0, -4.0}, &species}}, 60, 1);
            QVERIFY(grown);
            if (grown->empty())
                continue; // it may die by chance
            const StandTree& tree = grown->front();
            QVERIFY(std::abs(tree.height - topHeightAt(species, 60)) < 0.2 * tree.height);
            QVERIFY(glm::length(tree.crownOffset) < 0.1);
        }
    }

    void seedlingsAtOnePlaceLeaveOne()
    {
        const StandSpecies& pine = *findStandSpecies("ScotsPine");
        const auto grown = grownStand(std::vector<Seedling>(50, {{0.0, 0.0}, &pine}), 60, 1);
        QVERIFY(grown && grown->size() <= 1);
    }

    void fewerLiveEachYearAndTheyOnlyGrow()
    {
        const auto seedlings = plot(*findStandSpecies("EnglishOak"), 3);
        std::vector<StandTree> before = *grownStand(seedlings, 1, 3);
        for (const int years : {5, 20, 45, 90, 150}) {
            const std::vector<StandTree> now = *grownStand(seedlings, years, 3);
            QVERIFY(now.size() < before.size());
            for (const StandTree& tree : now) {
                const auto earlier = std::ranges::find(before, tree.number, &StandTree::number);
                QVERIFY(earlier != before.end());
                QVERIFY(tree.height >= earlier->height && tree.diameter >= earlier->diameter);
                QVERIFY(tree.crownBase >= earlier->crownBase && tree.crownBase < tree.height);
            }
            before = now;
        }
    }

    void theSameNumbersEachTime()
    {
        const auto seedlings = plot(*findStandSpecies("NorwaySpruce"), 5);
        const auto a = *grownStand(seedlings, 40, 5), b = *grownStand(seedlings, 40, 5);
        QVERIFY(std::ranges::equal(a, b, [](const StandTree& x, const StandTree& y) {
            return x.number == y.number && x.height == y.height && x.diameter == y.diameter &&
                   x.crownOffset == y.crownOffset;
        }));
        QVERIFY(grownStand(seedlings, 40, 6)->size() != 0);
    }

    void yieldTablesAreMet_data()
    {
        QTest::addColumn<int>("row");
        constexpr int rows = test::isSanitized ? 1 : int(std::size(published));
        for (int row = 0; row < rows; ++row)
            QTest::addRow("%s", published[row].species) << row;
    }
    /// The mean of three plots, as foresters count: on a single one chance decides a tenth.
    void yieldTablesAreMet()
    {
        QFETCH(int, row);
        const Published& of = published[row];
        double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, count = 0.0;
        for (int years = 40; years <= 80; years += 10) {
            std::vector<StandTree> trees;
            constexpr int plots = 3;
            for (int seed = 1; seed <= plots; ++seed) {
                const auto one = *grownStand(plot(*findStandSpecies(of.species), std::uint64_t(seed)), years,
                                             std::uint64_t(seed));
                trees.insert(trees.end(), one.begin(), one.end());
            }
            Table now = tableOf(trees);
            now.stems /= plots;
            if (const Table* wanted = years == 50 ? &of.at50 : years == 80 ? &of.at80 : nullptr) {
                QVERIFY(isWithin(now.stems, wanted->stems, 0.25));
                QVERIFY(isWithin(now.height, wanted->height, 0.25));
                QVERIFY(isWithin(now.diameter, wanted->diameter, 0.25));
            }
            const double d = maths::log(now.diameter), n = maths::log(now.stems);
            x += d, y += n, xx += d * d, xy += d * n, count += 1.0;
        }
        const double slope = (count * xy - x * y) / (count * xx - x * x);
        if (of.thinning != 0.0)
            QVERIFY2(std::abs(slope - of.thinning) <= 0.15, qPrintable(QString::number(slope)));
    }

    /// Crowns at the edge reach outwards, those inside stand over their feet.
    void edgesLeanOut()
    {
        for (const StandSpecies& species : standSpecies()) {
            double outside = 0.0, inside = 0.0, edges = 0.0, others = 0.0;
            const std::vector<StandTree> grown = *grownStand(plot(species, 2), 80, 2);
            for (const StandTree& tree : grown) {
                const double x = std::abs(tree.foot.x), z = std::abs(tree.foot.y);
                const glm::dvec2 out = x > z ? glm::dvec2(tree.foot.x < 0.0 ? -1.0 : 1.0, 0.0)
                                             : glm::dvec2(0.0, tree.foot.y < 0.0 ? -1.0 : 1.0);
                const double reach = glm::dot(tree.crownOffset, out) / tree.crownRadius;
                if (std::max(x, z) > 22.0) {
                    outside += reach;
                    edges += 1.0;
                } else if (std::max(x, z) < 15.0) {
                    inside += reach;
                    others += 1.0;
                }
            }
            QVERIFY2(outside >= 0.1 * edges, species.name);
            QVERIFY2(std::abs(inside) <= 0.03 * others, species.name);
        }
    }
};

RAMURE_SUITE(TestStand)

} // namespace tst_stand

#include "tst_stand.moc"
