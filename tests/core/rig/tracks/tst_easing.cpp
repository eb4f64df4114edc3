#include "core/rig/tracks/track.h"
#include "tests/support/suite.h"

#include <QFile>

namespace tst_easing {

using namespace ramure;

static Key keyAt(double seconds, double value, KeyMode mode)
{
    Key key;
    key.time = ticksOf(seconds);
    key.value = value;
    key.mode = mode;
    return key;
}

static Key handled(double seconds, double value, KeyMode mode, double length)
{
    Key key = keyAt(seconds, value, mode);
    key.before = key.behind = HandleType::Free;
    key.in = {-length, 0.0};
    key.out = {length, 0.0};
    return key;
}

static Track trackOf(std::vector<Key> keys)
{
    return *Track::fromKeys(std::move(keys));
}

template <class T> static T named(const QString& name, int count, const char* (*nameOf)(T))
{
    for (int i = 0; i < count; ++i)
        if (name == QLatin1String(nameOf(static_cast<T>(i))))
            return static_cast<T>(i);
    qFatal("no such name");
}

class TestEasing : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void everyRowOfBlender_data()
    {
        QTest::addColumn<QStringList>("cells");
        QFile file(QStringLiteral(RAMURE_TEST_DATA "/blender_easing.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        file.readLine();
        while (!file.atEnd()) {
            const QByteArray line = file.readLine().trimmed();
            QTest::addRow("%s", line.left(40).constData()) << QString::fromLatin1(line).split(u',');
        }
    }
    void everyRowOfBlender()
    {
        QFETCH(QStringList, cells);
        QCOMPARE(cells.size(), 12);
        Key first = keyAt(0.0, 0.0, named(cells[0], keyModeCount, keyModeName));
        first.easing = named(cells[1], easingCount, easingName);
        first.back = cells[2].toDouble();
        first.amplitude = cells[3].toDouble();
        first.period = cells[4].toDouble(); // a frame is a second here
        const Track track = trackOf({first, keyAt(10.0, 2.0, KeyMode::Bezier)});
        const double range = 2.0, allowed = (first.mode == KeyMode::Elastic ? 1e-4 : 1e-6) * range;
        const double times[] = {0.0, 1.0, 2.5, 5.0, 7.5, 9.0, 10.0};
        for (int i = 0; i < 7; ++i) {
            const double expected = cells[5 + i].toDouble(), value = valueAt(track, times[i]);
            QVERIFY2(
                std::abs(value - expected) <= allowed,
                qPrintable(QStringLiteral("%1 s: %2, Blender %3").arg(times[i]).arg(value).arg(expected)));
        }
    }
    void valuesOfBlendersOwnTests()
    {
        const auto at = [](KeyMode mode, Easing easing, double seconds) {
            Key first = keyAt(1.0, 7.0, mode);
            first.easing = easing;
            return valueAt(trackOf({first, keyAt(2.0, 13.0, mode)}), seconds);
        };
        QCOMPARE(at(KeyMode::Linear, Easing::Auto, 1.25), 8.5);
        QVERIFY(std::abs(at(KeyMode::Bounce, Easing::In, 1.4) - 8.365) < 1e-9);
        QVERIFY(std::abs(at(KeyMode::Bounce, Easing::In, 1.5) - 8.40625) < 1e-9);
        QVERIFY(std::abs(at(KeyMode::Bounce, Easing::In, 1.8) - 11.185) < 1e-9);
        const Track bezier = trackOf({handled(1.0, 7.0, KeyMode::Bezier, 1.0 / 2.5614),
                                      handled(2.0, 13.0, KeyMode::Bezier, 1.0 / 2.5614)});
        QVERIFY(std::abs(valueAt(bezier, 1.25) - 7.8297067) < 1e-6);
        QVERIFY(std::abs(valueAt(bezier, 1.75) - 12.170294) < 1e-6);
    }
};

RAMURE_SUITE(TestEasing)

} // namespace tst_easing

#include "tst_easing.moc"
