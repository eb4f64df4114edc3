#include "tests/support/suite.h"
#include "widgets/view/render/light/sun_position.h"
#include <QDateTime>
#include <QTest>
#include <cmath>

namespace tst_sun_position {

using namespace ramure;

class TestSunPosition : public QObject
{
    Q_OBJECT

    static SunPosition at(const QDateTime& time, double latitude, double longitude)
    {
        return sunPosition(double(time.toSecsSinceEpoch()), latitude, longitude);
    }

private slots:
    void init() { test::failOnAnyWarning(); }
    /// Reda and Andreas, "Solar Position Algorithm for Solar Radiation Applications" (NREL 2003), their
    /// example: 17 October 2003, 12:30:30 at UTC-7, 39.742476 N, 105.1786 W: zenith 50.11162 (with 0.01 of
    /// refraction), azimuth 194.34024.
    void itIsThatOfAnIndependentAlgorithm()
    {
        const SunPosition sun = at(QDateTime({2003, 10, 17}, {19, 30, 30}, Qt::UTC), 39.742476, -105.1786);
        QVERIFY2(std::abs(sun.heightDeg - (90.0 - 50.11162)) < 0.03,
                 qPrintable(QString::number(sun.heightDeg, 'f', 4)));
        QVERIFY2(std::abs(sun.azimuthDeg - 194.34024) < 0.03,
                 qPrintable(QString::number(sun.azimuthDeg, 'f', 4)));
    }
    void itRisesInTheEastAndSetsInTheWest()
    {
        for (int day = 1; day <= 365; day += 7) {
            const QDateTime midnight = QDateTime(QDate(2026, 1, 1).addDays(day - 1), {0, 0}, Qt::UTC);
            QVERIFY(at(midnight, 45.0, 0.0).heightDeg < 0.0);
            QVERIFY(at(midnight.addSecs(9 * 3600), 45.0, 0.0).azimuthDeg < 180.0);
            QVERIFY(at(midnight.addSecs(15 * 3600), 45.0, 0.0).azimuthDeg > 180.0);
            const double noon = at(midnight.addSecs(12 * 3600), 45.0, 0.0).heightDeg;
            QVERIFY(noon > 21.0 && noon < 69.0);
            // A quarter of the way around the earth it is six hours earlier.
            const SunPosition here = at(midnight.addSecs(9 * 3600), 45.0, 0.0);
            const SunPosition there = at(midnight.addSecs(15 * 3600), 45.0, -90.0);
            QVERIFY(std::abs(here.heightDeg - there.heightDeg) < 0.2);
        }
    }
};

RAMURE_SUITE(TestSunPosition)

} // namespace tst_sun_position

#include "tst_sun_position.moc"
