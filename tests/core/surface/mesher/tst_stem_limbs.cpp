#include "core/surface/mesher/stem_limbs.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace tst_stem_limbs {

using namespace ramure;

/// Which children of a fork are limbs of one of them, and what becomes of those that show nothing of
/// themselves.
class TestStemLimbs : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingHasNoStem();
    void equalsAreNoLimbs();
    void limbsStandWhereTheyComeOut_data();
    void limbsStandWhereTheyComeOut();
    void limbsBesideEachOtherNeedRoom();
    void limbsComeOutAboveTheFork();
    void thinOnesEndInAForkOfEquals();
};

namespace {

StemLimb child(double degrees, double length, double radius, bool hasChildren = true, double azimuth = 0.0)
{
    const double angle = degrees * 0.017453292519943295;
    return {{std::sin(angle) * std::cos(azimuth), std::cos(angle), std::sin(angle) * std::sin(azimuth)},
            length,
            radius,
            hasChildren};
}

const StemLimb trunk = child(0.0, 1.0, 0.3);

} // namespace

void TestStemLimbs::nothingHasNoStem()
{
    QCOMPARE(stemOf({}), noIndex);
    QVERIFY(!standAroundStem({}));
    QVERIFY(!areStemAndLimb(0.0, 0.0) || stemOf(std::vector{StemLimb(), StemLimb()}) != noIndex);
    // A limb without a length is no reason for anything that is not finite.
    QVERIFY(std::isfinite(limbStart(StemLimb(), trunk)));
    QVERIFY(!std::isnan(limbStart(StemLimb(), StemLimb())));
}

void TestStemLimbs::equalsAreNoLimbs()
{
    const StemLimb twin = child(40.0, 1.0, 0.2);
    QCOMPARE(stemOf(std::vector{trunk, twin}), noIndex);
    QCOMPARE(limbAtFork(twin, trunk), LimbAtFork::Stands);
    const StemLimb limb = child(40.0, 1.0, 0.15);
    QCOMPARE(stemOf(std::vector{limb, trunk}), Index(1));
    QVERIFY(areStemAndLimb(0.15, 0.3) && areStemAndLimb(0.3, 0.15) && !areStemAndLimb(0.2, 0.3));
}

void TestStemLimbs::limbsStandWhereTheyComeOut_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("length");
    QTest::addColumn<bool>("hasChildren");
    QTest::addColumn<double>("stemLength");
    QTest::addColumn<int>("stands");
    QTest::newRow("aside") << 90.0 << 1.0 << true << 1.0 << int(LimbAtFork::Stands);
    QTest::newRow("up") << 45.0 << 1.0 << true << 1.0 << int(LimbAtFork::Stands);
    QTest::newRow("ends inside") << 90.0 << 0.2 << true << 1.0 << int(LimbAtFork::Inside);
    QTest::newRow("a twig inside") << 90.0 << 0.2 << false << 1.0 << int(LimbAtFork::Inside);
    QTest::newRow("a twig that goes on above the fork")
        << 5.0 << 2.0 << false << 1.0 << int(LimbAtFork::Beyond);
    QTest::newRow("comes out above the next fork") << 20.0 << 3.0 << true << 0.5 << int(LimbAtFork::Beyond);
    QTest::newRow("the stem is too short") << 90.0 << 1.0 << true << 0.05 << int(LimbAtFork::Crowded);
    QTest::newRow("straight back") << 180.0 << 1.0 << true << 1.0 << int(LimbAtFork::Crowded);
}

void TestStemLimbs::limbsStandWhereTheyComeOut()
{
    QFETCH(double, degrees);
    QFETCH(double, length);
    QFETCH(bool, hasChildren);
    QFETCH(double, stemLength);
    QTEST(int(limbAtFork(child(degrees, length, 0.05, hasChildren), child(0.0, stemLength, 0.3))), "stands");
}

void TestStemLimbs::limbsBesideEachOtherNeedRoom()
{
    const auto around = [](double radius, int count) {
        std::vector<StemLimb> fork{trunk};
        for (int i = 0; i < count; ++i)
            fork.push_back(child(90.0, 1.0, radius, true, 6.283185307179586 * i / count));
        return fork;
    };
    QVERIFY(standAroundStem(around(0.15, 2)));
    QVERIFY(!standAroundStem(around(0.15, 6)));
    QVERIFY(standAroundStem(around(0.05, 6)));
    QVERIFY(!standAroundStem(around(0.05, 30)));
    QVERIFY(!standAroundStem(std::vector{trunk, trunk, child(90.0, 1.0, 0.05)}));
}

/// The way from there to its end comes out of the stem right above the fork.
void TestStemLimbs::limbsComeOutAboveTheFork()
{
    double last = -1.0;
    for (const double degrees : {45.0, 60.0, 80.0, 90.0, 100.0, 110.0, 120.0}) {
        const StemLimb limb = child(degrees, 1.0, 0.02);
        const double start = limbStart(limb, trunk), angle = degrees * 0.017453292519943295;
        QVERIFY(start > last); // the more it droops, the higher
        QVERIFY(std::abs(start) <= 2.0 * trunk.radius);
        const double slope = (std::cos(angle) - start) / std::sin(angle),
                     comesOut = start + trunk.radius * slope;
        QVERIFY(comesOut >= limb.radius && comesOut < 3.0 * limb.radius);
        last = start;
    }
    QVERIFY(std::abs(limbStart(child(150.0, 1.0, 0.02), trunk)) <= 2.0 * trunk.radius);
}

void TestStemLimbs::thinOnesEndInAForkOfEquals()
{
    const auto endsInside = [](const StemLimb& thin, double other) {
        const StemLimb fork[] = {child(28.0, 0.3, 0.22), child(28.0, 0.4, other, true, 3.14159), thin};
        return endsInFork(fork, 2, child(0.0, 0.1, 0.3));
    };
    QVERIFY(!endsInFork(std::vector{child(90.0, 0.2, 0.05)}, 0, trunk));
    QVERIFY(endsInside(child(90.0, 0.2, 0.05), 0.22));
    QVERIFY(!endsInside(child(90.0, 0.2, 0.05), 0.05)); // no equals
    QVERIFY(!endsInside(child(90.0, 0.2, 0.15), 0.22)); // not thin
    QVERIFY(!endsInside(child(90.0, 1.0, 0.05), 0.22)); // it shows
    QVERIFY(!endsInside(child(10.0, 1.0, 0.05), 0.22));
}

RAMURE_SUITE(TestStemLimbs)

} // namespace tst_stem_limbs

#include "tst_stem_limbs.moc"
