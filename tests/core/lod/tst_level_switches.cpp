#include "core/lod/level_switches.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_level_switches {

using namespace ramure;

namespace {

/// A cross of so many m.
TreeLevel levelOf(float width, float height, double detail)
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = {{0.0F, 0.0F, 0.0F}, {width, 0.0F, 0.0F}, {0.0F, height, 0.0F}};
    TreeLevel level;
    level.bark = std::move(mesh);
    level.detail = detail;
    return level;
}

} // namespace

/// When levels of detail take over.
class TestLevelSwitches : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("about");
        QTest::newRow("words") << "near, far"
                               << "\"near\"";
        QTest::newRow("nothing between") << "10,,20"
                                         << "\"\"";
        QTest::newRow("other unit") << "10ft, 20ft"
                                    << "\"10ft\"";
        QTest::newRow("both") << "60%, 20"
                              << "not at both";
        QTest::newRow("few") << "10"
                             << "not 1";
        QTest::newRow("many") << "60%,30%,10%"
                              << "not 3";
        QTest::newRow("nought") << "0, 20"
                                << "over 0";
        QTest::newRow("negative") << "-60%, -70%"
                                  << "over 0";
        QTest::newRow("endless") << "20, inf"
                                 << "over 0";
        QTest::newRow("not a number") << "nan%, 30%"
                                      << "over 0";
        QTest::newRow("falling") << "20, 10"
                                 << "level 2: distances must rise, and 10 m is not farther than 20 m";
        QTest::newRow("the same") << "20, 20"
                                  << "must rise";
        QTest::newRow("rising") << "30%, 60%"
                                << "level 2: shares of the picture must fall, and 60 % is not less than 30 %";
        QTest::newRow("large") << "2000%, 60%"
                               << "more than the most, 1000 %";
    }
    void whatIsRefused()
    {
        QFETCH(QString, text);
        QFETCH(QString, about);
        LevelOptions options{3};
        auto fine = readSwitches(text.toStdString(), options);
        if (fine)
            fine = checkLevels(options);
        QVERIFY(!fine);
        QVERIFY2(QString::fromStdString(fine.error().message()).contains(about), test::why(fine));
    }

    void textIsReadAndWritten()
    {
        LevelOptions options{3};
        QVERIFY(readSwitches("20,60.5", options));
        QCOMPARE(options.distances, (std::vector<double>{20.0, 60.5}));
        QCOMPARE(switchesText(options), std::string("20; 60.5"));
        QVERIFY(readSwitches(" 20 m ; 60,5\u00a0m; ", options)); // as other languages write it
        QCOMPARE(switchesText(options), std::string("20; 60.5"));
        QVERIFY(!readSwitches("20; far", options));
        QCOMPARE(switchesText(options), std::string("20; 60.5"));
        QVERIFY(readSwitches("60%, 12.5 %", options));
        QVERIFY(options.distances.empty());
        QCOMPARE(switchesText(options), std::string("60 %; 12.5 %"));
        LevelOptions again{3};
        QVERIFY(readSwitches(switchesText(options), again));
        QCOMPARE(again.shares.size(), std::size_t(2));
        QVERIFY(checkLevels(again));
        QVERIFY(readSwitches(" ", again) && again == LevelOptions{3});
    }

    /// An oak of 20 m changes where a game has its trees, however fine its levels are.
    void theUsualAreThoseOfGames()
    {
        const std::vector<TreeLevel> levels{levelOf(16.0F, 20.0F, 0.0), levelOf(16.0F, 20.0F, 0.9),
                                            levelOf(16.0F, 20.0F, 2.0)};
        const LevelSwitches at = switchesOf(levels, {3}, 1.0);
        QCOMPARE(at.distances[0], 0.0);
        QVERIFY(std::isinf(at.shares[0]));
        QCOMPARE(at.shares[1], 0.6);
        QCOMPARE(at.shares[2], 0.3);
        QVERIFY2(std::abs(at.distances[1] - 20.0 / (2.0 * std::tan(0.345) * 0.6)) < 1e-9,
                 QByteArray::number(at.distances[1]));
        QVERIFY(std::abs(at.distances[2] - 2.0 * at.distances[1]) < 1e-9);
        QVERIFY(std::abs(at.coverage[0] - 0.6 * 0.6 * 0.8 * 9.0 / 16.0) < 1e-12);
        QCOMPARE(at.coverage[2], 0.0);
        QVERIFY(at.unseen[1] > 1000.0 && at.unseen[2] > at.unseen[1]);
        const LevelSwitches twice = switchesOf(levels, {3}, 2.0);
        QVERIFY(std::abs(twice.distances[1] - 2.0 * at.distances[1]) < 1e-9);
        QCOMPARE(twice.coverage, at.coverage);
    }

    void distancesAndSharesSayTheSame()
    {
        const std::vector<TreeLevel> levels{levelOf(4.0F, 9.0F, 0.0), levelOf(4.0F, 9.0F, 0.1),
                                            levelOf(4.0F, 9.0F, 0.3)};
        LevelOptions options{3};
        options.distances = {12.0, 50.0};
        const LevelSwitches far = switchesOf(levels, options, 1.5);
        QCOMPARE(far.distances, (std::vector<double>{0.0, 12.0, 50.0}));
        options.shares = {far.shares[1], far.shares[2]};
        options.distances.clear();
        const LevelSwitches same = switchesOf(levels, options, 1.5);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(std::abs(same.distances[i] - far.distances[i]) < 1e-9);
            QCOMPARE(same.coverage[i], far.coverage[i]);
        }
    }

    void nothingHasASizeToo()
    {
        const LevelSwitches at = switchesOf({TreeLevel{}, TreeLevel{}}, {2}, 1.0);
        QVERIFY(std::isfinite(at.distances[1]) && std::isfinite(at.coverage[0]));
    }
};

RAMURE_SUITE(TestLevelSwitches)

} // namespace tst_level_switches

#include "tst_level_switches.moc"
