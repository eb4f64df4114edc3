#include "core/surface/season/phenology.h"

#include "core/surface/foliage/leaf_table.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace tst_phenology {

using namespace ramure;

namespace {

constexpr std::array climates{SeasonClimate::Oceanic, SeasonClimate::Continental, SeasonClimate::Boreal};

Climate even(double degrees)
{
    Climate out{48.0, {}};
    out.mean.fill(degrees);
    return out;
}

int burstIn(BudKind kind, SeasonClimate climate)
{
    return budburst(budModel(kind), climateOf(climate)).value_or(0);
}

double burstOf(LeafShape shape, SeasonClimate climate)
{
    return datesOf(plantYear(shape), climateOf(climate)).value().burst;
}

/// Menzel's sum on one day, from the beginning.
bool isWarmEnough(const BudModel& model, const Climate& climate, int day)
{
    int chill = 0;
    double warmth = 0.0;
    for (int d = -60; d <= day; ++d) { // from the first of November on
        const double degrees = climate.mean[std::size_t((d + 364) % 365)];
        chill += degrees <= model.chill ? 1 : 0;
        if (d > 31)
            warmth += degrees > model.warmth ? degrees - model.warmth : 0.0;
    }
    return chill > 0 && warmth >= model.a + model.b * std::log(double(chill));
}

} // namespace

class TestPhenology : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void yearsWithoutWinterOrSummerHaveNoDates()
    {
        for (const double degrees : {-30.0, 4.0, 9.5, 20.0, 60.0}) {
            const Climate climate = even(degrees);
            for (int kind = 0; kind < 7; ++kind)
                QVERIFY(degrees == 4.0 || !budburst(budModel(BudKind(kind)), climate));
            for (int shape = 1; shape < leafShapeCount; ++shape) {
                const auto dates = datesOf(plantYear(LeafShape(shape)), climate);
                QVERIFY(!dates || (dates->burst >= 1.0 && std::isfinite(dates->lastFall)));
            }
        }
        QVERIFY(!colouring(even(40.0))); // never cold
        QVERIFY(!colouring(climateOf(SeasonClimate::Oceanic), 1e9));
        Climate nothing{48.0, {}};
        nothing.mean.fill(std::nan(""));
        QVERIFY(!budburst(budModel(BudKind::Oak), nothing) && !colouring(nothing));
    }

    void theClimatesAreThoseOfTheirTowns()
    {
        for (const SeasonClimate climate : climates) {
            const auto& mean = climateOf(climate).mean;
            const auto warmest = std::ranges::max_element(mean) - mean.begin();
            QVERIFY(warmest > 180 && warmest < 230);
            for (std::size_t day = 0; day < mean.size(); ++day) // smooth, over the new year too
                QVERIFY(std::abs(mean[day] - mean[(day + 1) % mean.size()]) < 0.35);
        }
        QVERIFY(std::abs(climateOf(SeasonClimate::Oceanic).mean[14] - 6.0) < 0.3);
        QVERIFY(std::abs(climateOf(SeasonClimate::Boreal).mean[195] - 16.5) < 0.3);
    }

    void daysAreAsLongAsAtTheirLatitude()
    {
        QVERIFY(std::abs(dayLength(0.0, 100) - 12.1) < 0.05);
        QVERIFY(std::abs(dayLength(48.1, 172) - 16.1) < 0.1 && std::abs(dayLength(48.1, 355) - 8.3) < 0.1);
        QCOMPARE(dayLength(80.0, 172), 24.0);
        QCOMPARE(dayLength(80.0, 355), 0.0);
    }

    void budsBurstAsTheFormulaSays()
    {
        for (const SeasonClimate climate : climates)
            for (int kind = 0; kind < 7; ++kind) {
                const BudModel model = budModel(BudKind(kind));
                const int day = burstIn(BudKind(kind), climate);
                QVERIFY(day > 0 && isWarmEnough(model, climateOf(climate), day));
                QVERIFY(!isWarmEnough(model, climateOf(climate), day - 1));
            }
        // By hand.
        const auto near = [](int day, int expected) { return std::abs(day - expected) <= 5; };
        QVERIFY(near(burstIn(BudKind::Larch, SeasonClimate::Oceanic), 93));
        QVERIFY(near(burstIn(BudKind::Birch, SeasonClimate::Oceanic), 95));
        QVERIFY(near(burstIn(BudKind::Oak, SeasonClimate::Oceanic), 105));
        QVERIFY(near(burstIn(BudKind::Beech, SeasonClimate::Oceanic), 119));
        QVERIFY(near(burstIn(BudKind::Larch, SeasonClimate::Continental), 108));
        QVERIFY(near(burstIn(BudKind::Oak, SeasonClimate::Continental), 126));
        QVERIFY(near(burstIn(BudKind::Birch, SeasonClimate::Boreal), 141));
        QVERIFY(near(burstIn(BudKind::Spruce, SeasonClimate::Boreal), 154));
        QVERIFY(near(colouring(climateOf(SeasonClimate::Oceanic)).value_or(0), 304));
        QVERIFY(near(colouring(climateOf(SeasonClimate::Continental)).value_or(0), 285));
        QVERIFY(near(colouring(climateOf(SeasonClimate::Boreal)).value_or(0), 272));
    }

    void speciesFollowEachOther()
    {
        for (const SeasonClimate climate : climates) {
            const auto burst = [&](LeafShape shape) { return burstOf(shape, climate); };
            QVERIFY(burst(LeafShape::Larch) < burst(LeafShape::Birch));
            for (const LeafShape late :
                 {LeafShape::Beech, LeafShape::Oak, LeafShape::Ash, LeafShape::Robinia})
                QVERIFY(burst(LeafShape::Birch) + 5.0 < burst(late));
            QVERIFY(burst(LeafShape::HorseChestnut) < burst(LeafShape::Oak));
            QVERIFY(burst(LeafShape::Oak) < burst(LeafShape::Ash));
        }
    }

    void theYearOfEachSpeciesIsInOrder()
    {
        for (const SeasonClimate climate : climates)
            for (int shape = 1; shape < leafShapeCount; ++shape) {
                const PlantYear& plant = plantYear(LeafShape(shape));
                const auto dates = datesOf(plant, climateOf(climate));
                QVERIFY(dates);
                QVERIFY(plant.needleYears == 0.0 || leafRow(plant.shape).evergreen);
                if (leafRow(plant.shape).evergreen)
                    continue;
                QVERIFY(dates->burst > 60.0 && dates->burst < dates->unfolded);
                QVERIFY(dates->unfolded < dates->turned && dates->turned < dates->firstFall);
                QVERIFY(std::abs(dates->lastFall - dates->firstFall - 7.0 * plant.fallWeeks) < 1e-9);
                QVERIFY(dates->lastFall < 365.0 || climate == SeasonClimate::Oceanic);
                QVERIFY(plant.keeps == 0.0 || plant.shape == LeafShape::Grass ||
                        plant.shape == LeafShape::Fern || (plant.keeps >= 0.05F && plant.keeps <= 0.2F));
            }
        QVERIFY(plantYear(LeafShape::Oak).keeps > 0.0F && plantYear(LeafShape::Beech).keeps > 0.0F);
        // The colder the year, the shorter the summer.
        const auto summer = [](SeasonClimate climate) {
            const auto dates = datesOf(plantYear(LeafShape::Birch), climateOf(climate)).value();
            return dates.turned - dates.burst;
        };
        QVERIFY(summer(SeasonClimate::Boreal) < summer(SeasonClimate::Continental));
        QVERIFY(summer(SeasonClimate::Continental) < summer(SeasonClimate::Oceanic));
    }
};

RAMURE_SUITE(TestPhenology)

} // namespace tst_phenology

#include "tst_phenology.moc"
