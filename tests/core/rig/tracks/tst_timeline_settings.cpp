#include "core/rig/tracks/timeline_settings.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>

namespace tst_timeline_settings {

using namespace ramure;
using namespace ramure::test;

class TestTimelineSettings : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void badSettingsAreErrors_data();
    void badSettingsAreErrors();
    void everyFrameIsShownAtItsTime();
    void playingStaysInside();
    void onceEnds();
    void loopRepeatsAllFrames();
    void pingPongTurnsAtTheEnds();
    void oneFrameStandsStill();
};

void TestTimelineSettings::badSettingsAreErrors_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<qint64>("first");
    QTest::addColumn<qint64>("last");
    QTest::addColumn<QString>("path");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("no frames") << 0.0 << qint64(0) << qint64(10) << "framesPerSecond";
    QTest::newRow("backwards") << -24.0 << qint64(0) << qint64(10) << "framesPerSecond";
    QTest::newRow("not a number") << nan << qint64(0) << qint64(10) << "framesPerSecond";
    QTest::newRow("too fast") << 241.0 << qint64(0) << qint64(10) << "framesPerSecond";
    QTest::newRow("end before start") << 24.0 << qint64(11) << qint64(10) << "lastFrame";
    QTest::newRow("too early") << 24.0 << qint64(-1000001) << qint64(10) << "firstFrame";
    QTest::newRow("too late") << 24.0 << qint64(0) << qint64(1000001) << "lastFrame";
}

void TestTimelineSettings::badSettingsAreErrors()
{
    QFETCH(double, rate);
    QFETCH(qint64, first);
    QFETCH(qint64, last);
    QFETCH(QString, path);
    const auto checked = checkTimeline({rate, first, last, PlayLoop::Loop});
    QVERIFY(!checked);
    QCOMPARE(QString::fromStdString(checked.error().path), path);
    QVERIFY(checkTimeline({}));
}

void TestTimelineSettings::everyFrameIsShownAtItsTime()
{
    for (const double rate : {1.0, 23.976, 24.0, 25.0, 29.97, 30.0, 60.0, 240.0}) {
        TimelineSettings settings;
        settings.framesPerSecond = rate;
        for (const std::int64_t frame :
             {-1000000L, -7L, -1L, 0L, 1L, 2L, 3L, 29L, 1001L, 999999L, 1000000L}) {
            QCOMPARE(settings.frameAt(settings.timeOf(frame)), frame);
            QCOMPARE(settings.frameAt(settings.timeOf(frame) - 0.5 / rate), std::max(frame - 1, leastFrame));
        }
        QCOMPARE(settings.frameAt(1e300), mostFrame);
        QCOMPARE(settings.frameAt(-1e300), leastFrame);
    }
}

void TestTimelineSettings::playingStaysInside()
{
    for (const PlayLoop loop : {PlayLoop::Once, PlayLoop::Loop, PlayLoop::PingPong}) {
        const TimelineSettings settings{24.0, -3, 11, loop};
        for (double travelled = -500.0; travelled < 500.0; travelled += 0.37) {
            const PlayPlace place = playedFrame(settings, travelled);
            QVERIFY(place.frame >= settings.firstFrame && place.frame <= settings.lastFrame);
        }
        for (const double strange : {1e300, -1e300, std::nan(""), HUGE_VAL}) {
            const PlayPlace place = playedFrame(settings, strange);
            QVERIFY(place.frame >= settings.firstFrame && place.frame <= settings.lastFrame);
        }
    }
}

void TestTimelineSettings::onceEnds()
{
    const TimelineSettings settings{24.0, 5, 8, PlayLoop::Once};
    QCOMPARE(playedFrame(settings, -2.0), (PlayPlace{5, false}));
    QCOMPARE(playedFrame(settings, 2.99), (PlayPlace{7, false}));
    QCOMPARE(playedFrame(settings, 3.0), (PlayPlace{8, true}));
    QCOMPARE(playedFrame(settings, 1000.0), (PlayPlace{8, true}));
}

void TestTimelineSettings::loopRepeatsAllFrames()
{
    const TimelineSettings settings{24.0, 5, 7, PlayLoop::Loop};
    const std::int64_t expected[] = {5, 6, 7};
    for (int k = -9; k < 9; ++k)
        QCOMPARE(playedFrame(settings, k + 0.5).frame, expected[((k % 3) + 3) % 3]);
}

void TestTimelineSettings::pingPongTurnsAtTheEnds()
{
    const TimelineSettings settings{24.0, 0, 3, PlayLoop::PingPong};
    const std::int64_t expected[] = {0, 1, 2, 3, 2, 1};
    for (int k = -12; k < 12; ++k)
        QCOMPARE(playedFrame(settings, k + 0.5).frame, expected[((k % 6) + 6) % 6]);
}

void TestTimelineSettings::oneFrameStandsStill()
{
    QCOMPARE(playedFrame({24.0, 4, 4, PlayLoop::Loop}, 77.0), (PlayPlace{4, false}));
    QCOMPARE(playedFrame({24.0, 4, 4, PlayLoop::PingPong}, 77.0), (PlayPlace{4, false}));
    QCOMPARE(playedFrame({24.0, 4, 4, PlayLoop::Once}, 0.0), (PlayPlace{4, true}));
}

RAMURE_SUITE(TestTimelineSettings)

} // namespace tst_timeline_settings

#include "tst_timeline_settings.moc"
