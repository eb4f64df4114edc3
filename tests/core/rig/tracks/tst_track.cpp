#include "core/math/random.h"
#include "core/rig/tracks/track.h"
#include "tests/support/suite.h"
#include <algorithm>

#include <limits>

namespace tst_track {

using namespace ramure;

namespace {

Key keyAt(double seconds, double value, KeyMode mode = KeyMode::Linear)
{
    Key key;
    key.time = ticksOf(seconds);
    key.value = value;
    key.mode = mode;
    return key;
}

Track trackOf(std::vector<Key> keys)
{
    return *Track::fromKeys(std::move(keys));
}

/// SPEC B1 once more, from its text alone: keys as pairs, no cursor, no search tree.
double expectedAt(const std::vector<std::pair<double, double>>& keys, KeyMode mode, double t)
{
    const std::size_t n = keys.size();
    if (t <= keys[0].first)
        return keys[0].second;
    if (t >= keys[n - 1].first)
        return keys[n - 1].second;
    std::size_t i = 0;
    while (t >= keys[i + 1].first)
        ++i;
    const double u = (t - keys[i].first) / (keys[i + 1].first - keys[i].first);
    const double x1 = keys[i].second, x2 = keys[i + 1].second;
    const double x0 = i > 0 ? keys[i - 1].second : x1, x3 = i + 2 < n ? keys[i + 2].second : x2;
    if (mode == KeyMode::Constant)
        return x1;
    if (mode == KeyMode::Linear)
        return (1.0 - u) * x1 + u * x2;
    const double a = (3 * x1 - 3 * x2 + x3 - x0) / 2, b = (2 * x0 - 5 * x1 + 4 * x2 - x3) / 2;
    return a * std::pow(u, 3) + b * std::pow(u, 2) + (x2 - x0) / 2 * u + x1;
}

} // namespace

class TestTrack : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badKeysAreRefused()
    {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double bad : {nan, infinity, -infinity}) {
            const auto track = Track::fromKeys({keyAt(0.0, 1.0), keyAt(1.0, bad)});
            QVERIFY(!track);
            QCOMPARE(track.error().path, std::string("[1].value"));
            Key key = keyAt(0.0, 0.0);
            key.out.dv = bad;
            QVERIFY(!Track::fromKeys({key}));
            key = keyAt(0.0, 0.0);
            key.period = bad;
            QVERIFY(!Track::fromKeys({key}));
        }
        Key late = keyAt(0.0, 0.0);
        late.time = mostTicks + 1;
        QVERIFY(!Track::fromKeys({late}));
        Track track = trackOf({keyAt(0.0, 1.0), keyAt(1.0, 2.0)});
        const Track before = track;
        QVERIFY(!track.insert(keyAt(2.0, nan)));
        const std::size_t indices[] = {5};
        const Key keys[] = {keyAt(3.0, 1.0)};
        QVERIFY(!track.replace(indices, keys));
        QVERIFY(track == before);
    }
    void aSingleKeyIsTheValueEverywhere()
    {
        for (int mode = 0; mode < keyModeCount; ++mode)
            for (int e = 0; e < extrapolationCount; ++e) {
                Track track = trackOf({keyAt(1.0, 7.0, static_cast<KeyMode>(mode))});
                track.before = track.behind = static_cast<Extrapolation>(e);
                for (const double t : {-1e6, -1.0, 0.0, 1.0, 2.0, 1e6})
                    QCOMPARE(valueAt(track, t), 7.0);
            }
    }
    void keysAreSortedAndTheLastOfEqualTimesCounts()
    {
        const Track track =
            trackOf({keyAt(2.0, 3.0), keyAt(-1.0, 1.0), keyAt(2.0, 4.0), keyAt(0.0, 2.0), keyAt(-1.0, 0.0)});
        QCOMPARE(track.size(), std::size_t(3));
        QCOMPARE(valueAt(track, -1.0), 0.0);
        QCOMPARE(valueAt(track, -0.5), 1.0);
        QCOMPARE(valueAt(track, 2.0), 4.0);
    }
    void aMillionthFrameIsExact()
    {
        for (const double rate : {24.0, 25.0, 30.0, 60.0, 23.976, 29.97, 240.0})
            for (const int frame : {1, 999'999, 1'000'000}) {
                Track track = trackOf({keyAt(0.0, 1.0, KeyMode::Constant)});
                QVERIFY(track.insert(keyAt(double(frame) / rate, 2.0, KeyMode::Constant)));
                QCOMPARE(valueAt(track, double(frame) / rate), 2.0); // not one frame late
                QCOMPARE(valueAt(track, double(frame - 1) / rate), 1.0);
            }
    }
    void constantLinearAndCubicAreThoseOfTheSpecification()
    {
        Random random(1, RandomStream::Test);
        double worst = 0.0;
        for (int run = 0; run < 300; ++run) {
            const auto mode =
                static_cast<KeyMode>(random.below(2) == 0 ? random.below(2) : std::uint32_t(KeyMode::Cubic));
            std::vector<std::pair<double, double>> plain;
            std::vector<Key> keys;
            double time = random.range(-20.0, 0.0);
            for (std::uint32_t i = 1 + random.below(12); i-- > 0;) {
                const Key key = keyAt(time, random.range(-5.0, 5.0), mode);
                keys.push_back(key);
                plain.emplace_back(secondsOf(key.time), key.value);
                time += random.range(0.01, 3.0);
            }
            for (std::size_t i = keys.size(); i > 1; --i) // any order gives the same
                std::swap(keys[i - 1], keys[random.below(static_cast<std::uint32_t>(i))]);
            const Track track = trackOf(std::move(keys));
            TrackCursor cursor;
            for (int i = 0; i < 200; ++i) {
                const double t =
                    i < 20 && i < int(plain.size()) ? plain[std::size_t(i)].first : random.range(-25.0, 25.0);
                worst = std::max(worst, std::abs(valueAt(track, t, cursor) - expectedAt(plain, mode, t)));
            }
        }
        QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
    }
    void atAKeyTheValueIsExactlyThatOfTheKey()
    {
        Random random(2, RandomStream::Test);
        for (int run = 0; run < 200; ++run) {
            std::vector<Key> keys;
            for (int i = 0; i < 8; ++i)
                keys.push_back(keyAt(random.range(-10.0, 10.0), random.range(-9.0, 9.0),
                                     static_cast<KeyMode>(random.below(keyModeCount))));
            const Track track = trackOf(keys);
            for (const Key& key : track.keys())
                QCOMPARE(valueAt(track, secondsOf(key.time)), key.value);
        }
    }
    void aCursorChangesNoValue()
    {
        Random random(3, RandomStream::Test);
        std::vector<Key> keys;
        for (int i = 0; i < 500; ++i)
            keys.push_back(keyAt(random.range(-100.0, 100.0), random.range(-9.0, 9.0),
                                 static_cast<KeyMode>(random.below(keyModeCount))));
        const Track track = trackOf(keys);
        TrackCursor cursor{12345}; // of another track
        for (int i = 0; i < 20000; ++i) {
            const double t = random.below(4) == 0 ? random.range(-120.0, 120.0) : -100.0 + i * 0.01;
            QCOMPARE(valueAt(track, t, cursor), valueAt(track, t));
        }
    }
    void extrapolation()
    {
        Track track = trackOf({keyAt(0.0, 1.0), keyAt(10.0, 2.0), keyAt(30.0, 6.0)});
        const auto check = [&](Extrapolation how, double t, double expected) {
            track.before = track.behind = how;
            QVERIFY2(std::abs(valueAt(track, t) - expected) < 1e-9,
                     qPrintable(QStringLiteral("%1 at %2: %3, not %4")
                                    .arg(QLatin1String(extrapolationName(how)))
                                    .arg(t)
                                    .arg(valueAt(track, t))
                                    .arg(expected)));
        };
        check(Extrapolation::Hold, -5.0, 1.0);
        check(Extrapolation::Hold, 45.0, 6.0);
        check(Extrapolation::Linear, -5.0, 0.5);
        check(Extrapolation::Linear, 40.0, 8.0);
        check(Extrapolation::Repeat, 35.0, 1.5);
        check(Extrapolation::Repeat, 60.0, 6.0); // exactly at an end the key of that end
        check(Extrapolation::Repeat, -30.0, 1.0);
        check(Extrapolation::Repeat, -10.0, 4.0);
        check(Extrapolation::RepeatOffset, 35.0, 6.5);
        check(Extrapolation::RepeatOffset, 60.0, 11.0);
        check(Extrapolation::RepeatOffset, -30.0, -4.0);
        check(Extrapolation::RepeatOffset, -10.0, -1.0);
        check(Extrapolation::Mirror, 40.0, 4.0);
        check(Extrapolation::Mirror, 60.0, 1.0);
        check(Extrapolation::Mirror, 65.0, 1.5);
        check(Extrapolation::Mirror, -5.0, 1.5);
        check(Extrapolation::Mirror, -30.0, 6.0);
    }
    void aLoopTakesTheTimeModuloItsPeriod()
    {
        Track track = trackOf({keyAt(0.0, 0.0), keyAt(2.5, 5.0), keyAt(5.0, 0.0)});
        track.loop = 5 * ticksPerSecond;
        for (const double t : {0.0, 0.5, 2.5, 4.0})
            for (const int round : {-3, -1, 0, 1, 200'000})
                QVERIFY(std::abs(valueAt(track, t + 5.0 * round) - valueAt(track, t)) < 1e-8);
        QCOMPARE(valueAt(track, 5.0), 0.0);
    }
    void onlyKeysThatAreTakenOutGo()
    {
        Track track = trackOf({keyAt(0.0, 0.0), keyAt(1.0, 1.0), keyAt(2.0, 2.0), keyAt(3.0, 3.0)});
        const std::size_t gone[] = {2, 0, 2, 99};
        track.erase(gone);
        QCOMPARE(track.size(), std::size_t(2));
        QCOMPARE(track.keys()[0].value, 1.0);
        QCOMPARE(track.keys()[1].value, 3.0);
    }
    void movedKeysTakeThePlaceOfOthers()
    {
        Track track = trackOf({keyAt(0.0, 0.0), keyAt(1.0, 1.0), keyAt(2.0, 2.0), keyAt(3.0, 3.0)});
        const std::size_t indices[] = {0, 1};
        const Key keys[] = {keyAt(3.0, 10.0), keyAt(2.5, 11.0)};
        QVERIFY(track.replace(indices, keys));
        QCOMPARE(track.size(), std::size_t(3));
        QCOMPARE(valueAt(track, 3.0), 10.0);
        QCOMPARE(valueAt(track, 2.5), 11.0);
    }
    void keysChangedInPlaceGiveTheTrackThatAllOfThemGive()
    {
        Random random(9, RandomStream::Test);
        for (int run = 0; run < 2000; ++run) {
            std::vector<Key> keys;
            double time = random.range(-3.0, 0.0);
            for (std::uint32_t i = 2 + random.below(30); i-- > 0; time += random.range(0.05, 1.0)) {
                keys.push_back(keyAt(time, random.range(-3.0, 3.0), KeyMode::Bezier));
                if (random.below(4) == 0)
                    keys.back().before = static_cast<HandleType>(random.below(handleTypeCount));
                keys.back().behind = random.below(8) == 0 ? HandleType::Vector : keys.back().before;
                keys.back().in = {-random.range(0.0, 0.5), random.range(-1.0, 1.0)};
                keys.back().out = {random.range(0.0, 0.5), random.range(-1.0, 1.0)};
            }
            Track track = trackOf(keys);
            std::vector<std::size_t> indices;
            std::vector<Key> changed;
            for (std::size_t i = random.below(std::uint32_t(track.size())); i < track.size();
                 i += 1 + random.below(6)) {
                indices.push_back(i);
                changed.push_back(track.keys()[i]);
                changed.back().value += random.range(-2.0, 2.0);
                changed.back().time += ticksOf(random.range(-0.02, 0.02));
            }
            std::vector<Key> all = track.keys().toVector();
            for (std::size_t i = 0; i < indices.size(); ++i)
                all[indices[i]] = changed[i];
            QVERIFY(track.replace(indices, changed));
            QVERIFY(track == trackOf(all));
            // Some go elsewhere.
            std::vector<std::size_t> moved;
            std::vector<Key> elsewhere;
            all = track.keys().toVector();
            for (std::uint32_t k = 1 + random.below(3); k-- > 0;)
                if (const std::size_t i = random.below(std::uint32_t(track.size()));
                    std::find(moved.begin(), moved.end(), i) == moved.end()) {
                    moved.push_back(i);
                    elsewhere.push_back(track.keys()[i]);
                    elsewhere.back().time += ticksOf(random.range(-8.0, 8.0));
                }
            for (const std::size_t i : moved)
                all[i].time = mostTicks + 1;
            std::erase_if(all, [](const Key& key) { return key.time > mostTicks; });
            all.insert(all.end(), elsewhere.begin(), elsewhere.end());
            QVERIFY(track.replace(moved, elsewhere));
            QVERIFY(track == trackOf(all));
            Key added = keyAt(secondsOf(track.keys().front().time) + random.range(-1.0, 4.0),
                              random.range(-3.0, 3.0), KeyMode::Bezier);
            all = track.keys().toVector();
            all.push_back(added);
            QVERIFY(track.insert(added));
            QVERIFY(track == trackOf(all));
            QVERIFY(track.find(added.time));
        }
    }
    void aTrackThatGoesRoundIsSmoothAtItsSeam()
    {
        const auto slope = [](const Track& track, double t, double step) {
            return (valueAt(track, t + step) - valueAt(track, t)) / step;
        };
        for (const KeyMode mode : {KeyMode::Bezier, KeyMode::Cubic})
            for (const HandleType handles : {HandleType::Auto, HandleType::AutoClamped})
                for (const double gain : {0.0, 2.0}) {
                    Track track = trackOf({keyAt(0.0, 0.0, mode), keyAt(1.0, 1.0, mode),
                                           keyAt(3.0, -1.0 + gain, mode), keyAt(4.0, gain, mode)});
                    std::vector<Key> keys = track.keys().toVector();
                    for (Key& key : keys)
                        key.before = key.behind = handles;
                    track = trackOf(keys);
                    QVERIFY(!track.goesRound());
                    const double held = slope(track, 0.0, 1e-5);
                    track.before = track.behind =
                        gain == 0.0 ? Extrapolation::Repeat : Extrapolation::RepeatOffset;
                    track.settleEnds();
                    QVERIFY(track.goesRound());
                    for (const double seam : {0.0, 4.0, 400.0, -8.0})
                        QVERIFY(std::abs(slope(track, seam, 1e-5) - slope(track, seam, -1e-5)) < 1e-3);
                    QVERIFY(std::abs(slope(track, 4.0, 1e-5)) > 0.2); // not smooth by standing still
                    for (const Key& key : track.keys())
                        QCOMPARE(valueAt(track, secondsOf(key.time)), key.value);
                    if (gain == 0.0) { // a loop over the same period is the same curve
                        Track loop = trackOf(keys);
                        loop.loop = 4 * ticksPerSecond;
                        loop.settleEnds();
                        for (double t = -5.0; t < 10.0; t += 0.37)
                            QVERIFY(std::abs(valueAt(loop, t) - valueAt(track, t)) < 1e-9);
                        loop.loop = 5 * ticksPerSecond; // ... but not over a longer one
                        QVERIFY(!loop.goesRound());
                    }
                    track.before = Extrapolation::Mirror;
                    track.settleEnds();
                    QVERIFY(!track.goesRound());
                    QCOMPARE(slope(track, 0.0, 1e-5), held);
                }
    }
    void clampedHandlesNeverLeaveTheKeysValues()
    {
        Random random(4, RandomStream::Test);
        for (int run = 0; run < 300; ++run) {
            std::vector<Key> keys;
            double time = 0.0;
            for (std::uint32_t i = 2 + random.below(20); i-- > 0;) {
                keys.push_back(keyAt(time, random.range(-3.0, 3.0), KeyMode::Bezier));
                time += std::exp(random.range(-4.0, 3.0));
            }
            const Track track = trackOf(keys);
            for (std::size_t i = 0; i + 1 < track.size(); ++i) {
                const Key &a = track.keys()[i], &b = track.keys()[i + 1];
                const double low = std::min(a.value, b.value), high = std::max(a.value, b.value);
                for (int k = 1; k < 20; ++k) {
                    const double t = secondsOf(a.time) + k / 20.0 * secondsOf(b.time - a.time);
                    const double v = valueAt(track, t);
                    QVERIFY(v >= low - 1e-9 && v <= high + 1e-9);
                }
            }
        }
    }
    void smoothRunsHaveNoJumpOfTheAcceleration()
    {
        // Rising all the way, gently: nothing is clamped, so the second derivatives meet at the inner keys.
        const Track track = trackOf({keyAt(0.0, 0.0, KeyMode::Bezier), keyAt(1.0, 1.0, KeyMode::Bezier),
                                     keyAt(2.5, 2.2, KeyMode::Bezier), keyAt(4.0, 3.9, KeyMode::Bezier),
                                     keyAt(5.0, 5.0, KeyMode::Bezier)});
        const double h = 1e-3;
        for (std::size_t i = 1; i + 1 < track.size(); ++i) {
            const double t = secondsOf(track.keys()[i].time), at = valueAt(track, t);
            const auto second = [&](double step) {
                return (valueAt(track, t + 2 * step) - 2 * valueAt(track, t + step) + at) / (step * step);
            };
            QVERIFY(std::abs(second(h) - second(-h)) < 0.05);
        }
    }
};

RAMURE_SUITE(TestTrack)

} // namespace tst_track

#include "tst_track.moc"
