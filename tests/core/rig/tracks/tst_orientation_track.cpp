#include "core/math/random.h"
#include "core/rig/tracks/euler.h"
#include "core/rig/tracks/quaternions.h"
#include "core/rig/tracks/track.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace tst_orientation_track {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

OrientationKey keyAt(double seconds, const glm::dquat& value, KeyMode mode = KeyMode::Linear)
{
    OrientationKey key;
    key.time = ticksOf(seconds);
    key.value = value;
    key.mode = mode;
    return key;
}

OrientationTrack trackOf(std::vector<OrientationKey> keys)
{
    return *OrientationTrack::fromKeys(std::move(keys));
}

glm::dquat randomTurn(Random& random)
{
    for (;;) {
        const glm::dquat q{random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0),
                           random.range(-1.0, 1.0)}; // braces: the same order with every compiler
        if (glm::dot(q, q) > 0.01)
            return glm::normalize(q);
    }
}

/// Of the turn between two orientations, whatever their signs.
double angleBetween(const glm::dquat& a, const glm::dquat& b)
{
    const glm::dquat turn = glm::conjugate(a) * b;
    return 2.0 * std::atan2(std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z), std::abs(turn.w));
}

glm::dquat about(const glm::dvec3& axis, double angle)
{
    return glm::angleAxis(angle, glm::normalize(axis));
}

} // namespace

class TestOrientationTrack : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void aTurnThatGoesRoundIsSmoothAtItsSeam()
    {
        for (const KeyMode mode : {KeyMode::Bezier, KeyMode::Cubic})
            for (int b = 0; b < orientationBlendCount; ++b) {
                std::vector<OrientationKey> keys(5);
                for (std::size_t i = 0; i < keys.size(); ++i) {
                    keys[i].time = static_cast<Ticks>(i) * ticksPerSecond;
                    keys[i].mode = mode;
                    keys[i].before = keys[i].behind = HandleType::Auto;
                }
                keys[1].value = about({0.0, 1.0, 0.2}, 0.7);
                keys[2].value = about({1.0, 1.0, 0.0}, 1.1);
                keys[3].value = about({1.0, -0.3, 0.0}, 0.6);
                OrientationTrack track = *OrientationTrack::fromKeys(keys);
                track.blend = static_cast<OrientationBlend>(b);
                track.before = track.behind = Extrapolation::Repeat;
                track.settleEnds();
                QVERIFY(track.goesRound());
                const double step = 1e-4;
                const glm::dquat at = valueAt(track, 4.0), on = valueAt(track, 4.0 + step),
                                 before = valueAt(track, 4.0 - step);
                QVERIFY(angleBetween(at, on) > 0.1 * step); // moves through the seam
                // Twice as far apart as each is from the middle: straight on, at the same speed.
                QVERIFY(std::abs(angleBetween(before, on) - 2.0 * angleBetween(at, on)) < 0.01 * step);
                keys[4].value = about({0.0, 1.0, 0.0}, 2.0);
                track = *OrientationTrack::fromKeys(keys);
                track.before = track.behind = Extrapolation::Repeat;
                QVERIFY(!track.goesRound());
            }
    }
    void anglesGiveTheOrientationBackAndFollowIt()
    {
        Random random(12, RandomStream::Test);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 near(random.range(-9.0, 9.0), random.range(-9.0, 9.0), random.range(-9.0, 9.0));
            const glm::dquat q =
                about({random.range(-1.0, 1.0), random.range(-1.0, 1.0), 0.3}, random.range(-3.0, 3.0));
            const glm::dvec3 angles = anglesOf(q, near);
            QVERIFY(angleBetween(orientationOf(angles), q) < 1e-6);
            const glm::dvec3 again = anglesOf(q, angles);
            QVERIFY(glm::length(again - angles) < 1e-6);
            QVERIFY(std::abs(angles.x - near.x) < 3.3 && std::abs(angles.z - near.z) < 3.3);
        }
        // Straight up, X and Z turn about one axis: still the same orientation.
        for (const double y : {1.0, -1.0})
            for (const double z : {0.0, 0.4}) {
                const glm::dvec3 angles(0.2, y * std::numbers::pi / 2.0, z);
                const glm::dquat q = orientationOf(angles);
                QVERIFY(angleBetween(orientationOf(anglesOf(q, {0.0, 0.0, 0.3})), q) < 1e-6);
            }
        // Twice around in steps of 150 degrees: the angle goes on, it does not jump back.
        std::vector<OrientationKey> keys(6);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            keys[i].time = static_cast<Ticks>(i) * ticksPerSecond;
            keys[i].mode = KeyMode::Linear;
            keys[i].value = about({0.0, 0.0, 1.0}, 150.0 / 180.0 * std::numbers::pi * double(i));
        }
        const auto angles = anglesOfKeys(*OrientationTrack::fromKeys(keys));
        for (std::size_t i = 0; i < keys.size(); ++i)
            QVERIFY(std::abs(angles[i].z - 150.0 / 180.0 * std::numbers::pi * double(i)) < 1e-6);
    }
    void whatHasNoDirectionIsRefused()
    {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!OrientationTrack::fromKeys({keyAt(0.0, {0.0, 0.0, 0.0, 0.0})}));
        QVERIFY(!OrientationTrack::fromKeys({keyAt(0.0, {nan, 0.0, 0.0, 0.0})}));
        const auto long_ = OrientationTrack::fromKeys({keyAt(0.0, {3.0, 0.0, 4.0, 0.0})});
        QVERIFY(long_);
        QVERIFY(std::abs(glm::dot(long_->keys()[0].value, long_->keys()[0].value) - 1.0) < 1e-12);
    }
    /// An edit settles only what is around it: as if the track were made anew.
    void editsOfLongTracksAreAsMadeAnew_data()
    {
        QTest::addColumn<std::uint32_t>("seed");
        // Of all but the first, several edited keys reach into one another: their handles turned twice once.
        for (const std::uint32_t seed : {31u, 46u, 79u, 107u, 180u, 305u, 319u})
            QTest::addRow("%u", seed) << seed;
    }
    void editsOfLongTracksAreAsMadeAnew()
    {
        QFETCH(const std::uint32_t, seed);
        Random random(seed, RandomStream::Test);
        const auto turnedBy = [&](const glm::dquat& q, double most) {
            const glm::dvec3 axis{random.range(-1.0, 1.0), random.range(-1.0, 1.0), 1.1};
            return q * about(axis, random.range(-most, most));
        };
        const auto typed = [&](OrientationKey key) {
            key.before = static_cast<HandleType>(random.below(handleTypeCount));
            key.behind = static_cast<HandleType>(random.below(handleTypeCount));
            for (std::size_t c = 0; c < 4; ++c) {
                key.in[c] = {random.range(-0.2, 0.1), random.range(-0.5, 0.5)};
                key.out[c] = {random.range(-0.1, 0.2), random.range(-0.5, 0.5)};
            }
            return key;
        };
        std::vector<OrientationKey> keys;
        glm::dquat value(1.0, 0.0, 0.0, 0.0);
        for (int i = 0; i < 1300; ++i) { // several pages; some stay where they are, some turn half round
            const auto kind = random.below(10);
            value = kind == 0   ? value
                    : kind == 1 ? value * about({0.0, random.range(-1.0, 1.0), 0.5}, pi)
                                : turnedBy(value, kind == 2 ? 3.0 : 0.3);
            keys.push_back(typed(keyAt(0.1 * i, value, KeyMode::Bezier)));
        }
        OrientationTrack track = trackOf(keys);
        for (int edit = 0; edit < 110; ++edit) {
            std::vector<std::size_t> indices;
            for (auto n = 1 + random.below(3) * random.below(3); n-- > 0;)
                indices.push_back(random.below(static_cast<std::uint32_t>(track.size())));
            std::sort(indices.begin(), indices.end());
            indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
            keys = track.keys().toVector();
            const auto kind = random.below(4);
            if (kind == 0) {
                OrientationKey key =
                    typed(keyAt(random.range(-1.0, 131.0), randomTurn(random), KeyMode::Bezier));
                key.value =
                    random.below(2) == 0 ? 3.0 * key.value : turnedBy(track.keys()[indices[0]].value, 0.2);
                keys.push_back(key);
                QVERIFY(track.insert(key));
            } else if (kind == 1) {
                for (std::size_t i = indices.size(); i-- > 0;)
                    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(indices[i]));
                track.erase(indices);
            } else { // in their places, or thrown elsewhere
                std::vector<OrientationKey> fresh;
                for (const std::size_t index : indices) {
                    OrientationKey key = track.keys()[index];
                    key.value = random.below(3) == 0 ? -2.0 * randomTurn(random) : turnedBy(key.value, 0.5);
                    if (kind == 3)
                        key.time = ticksOf(random.range(-1.0, 131.0));
                    fresh.push_back(key);
                }
                for (std::size_t i = indices.size(); i-- > 0;)
                    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(indices[i]));
                keys.insert(keys.end(), fresh.begin(), fresh.end());
                QVERIFY(track.replace(indices, fresh));
            }
            const OrientationTrack anew = trackOf(keys);
            QCOMPARE(track.size(), anew.size());
            for (std::size_t i = 0; i < track.size(); ++i)
                QVERIFY2(track.keys()[i] == anew.keys()[i],
                         qPrintable(QStringLiteral("edit %1 (%2), key %3").arg(edit).arg(kind).arg(i)));
        }
    }
    void hundredThousandEditsNeverTakeTheLongWay()
    {
        Random random(1, RandomStream::Test);
        OrientationTrack track;
        double worstLength = 0.0, worstDot = 1.0;
        for (int edit = 0; edit < 100'000; ++edit) {
            const auto at = random.below(static_cast<std::uint32_t>(track.size()) + 1);
            const std::size_t one[] = {at};
            OrientationKey key = keyAt(random.range(-50.0, 50.0), randomTurn(random),
                                       static_cast<KeyMode>(random.below(keyModeCount)));
            if (random.below(3) == 0 && !track.empty()) // often the same with the other sign, or half a turn
                key.value = -track.keys()[random.below(static_cast<std::uint32_t>(track.size()))].value;
            if (track.size() > 20 || (random.below(4) == 0 && at < track.size()))
                track.erase(one);
            else if (random.below(3) == 0 && at < track.size())
                QVERIFY(track.replace(one, std::span(&key, 1)));
            else
                QVERIFY(track.insert(key));
            for (std::size_t i = 1; i < track.size(); ++i)
                worstDot = std::min(worstDot, glm::dot(track.keys()[i - 1].value, track.keys()[i].value));
            if (track.empty())
                continue;
            track.blend = static_cast<OrientationBlend>(random.below(orientationBlendCount));
            track.behind = static_cast<Extrapolation>(random.below(extrapolationCount));
            const glm::dquat q = valueAt(track, random.range(-60.0, 60.0));
            worstLength = std::max(worstLength, std::abs(std::sqrt(glm::dot(q, q)) - 1.0));
        }
        QVERIFY2(worstDot > -1e-6, qPrintable(QString::number(worstDot)));
        QVERIFY2(worstLength < 1e-6, qPrintable(QString::number(worstLength)));
    }
    void linearTurnsEvenlyByTheShorterWay()
    {
        Random random(2, RandomStream::Test);
        for (int run = 0; run < 500; ++run) {
            const glm::dquat a = randomTurn(random), b = randomTurn(random);
            const OrientationTrack track = trackOf({keyAt(0.0, a), keyAt(1.0, b)});
            const double whole = angleBetween(a, b);
            for (const double u : {0.0, 0.1, 0.5, 0.9, 1.0}) {
                const glm::dquat q = valueAt(track, u);
                QVERIFY(std::abs(angleBetween(a, q) - u * whole) < 1e-7);
                QVERIFY(std::abs(angleBetween(q, b) - (1.0 - u) * whole) < 1e-7);
            }
        }
    }
    void halfTurnsGoOnAboutTheAxisBefore()
    {
        for (const double noise : {-1e-9, 0.0, 1e-9})
            for (const double sign : {-1.0, 1.0})
                for (const glm::dvec3& axis :
                     {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 2, -3)}) {
                    const OrientationTrack track =
                        trackOf({keyAt(0.0, about(axis, 0.0)), keyAt(1.0, about(axis, 0.5)),
                                 keyAt(2.0, sign * about(axis, 0.5 + pi + noise))});
                    QVERIFY(angleBetween(valueAt(track, 1.5), about(axis, 0.5 + pi / 2)) < 1e-6);
                }
    }
    void aFirstHalfTurnIsAlwaysTheSame()
    {
        for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            for (const double noise : {-1e-9, 0.0, 1e-9})
                for (const double sign : {-1.0, 1.0})
                    for (const double along : {-1.0, 1.0}) {
                        const OrientationTrack track =
                            trackOf({keyAt(0.0, about(axis, 0.0)),
                                     keyAt(1.0, sign * about(along * axis, pi + noise))});
                        QVERIFY(angleBetween(valueAt(track, 0.5), about(axis, pi / 2)) < 1e-6);
                    }
    }
    void cubicOfComponentsIsThatOfTheSpecification()
    {
        Random random(3, RandomStream::Test);
        double worst = 0.0;
        for (int run = 0; run < 200; ++run) {
            std::vector<OrientationKey> keys;
            for (int i = 0; i < 6; ++i)
                keys.push_back(keyAt(i + random.range(0.0, 0.8), randomTurn(random), KeyMode::Cubic));
            OrientationTrack track = trackOf(keys);
            track.blend = OrientationBlend::Classic;
            // Independent: aligned units, the four polynomials, made a unit.
            std::vector<glm::dquat> q;
            for (const OrientationKey& key : keys)
                q.push_back(!q.empty() && glm::dot(q.back(), key.value) < 0.0 ? -key.value : key.value);
            for (int i = 0; i < 5; ++i) {
                const double u = random.range(0.0, 1.0);
                const double t0 = secondsOf(keys[std::size_t(i)].time),
                             t1 = secondsOf(keys[std::size_t(i + 1)].time);
                const glm::dquat x0 = q[std::size_t(std::max(i - 1, 0))], x1 = q[std::size_t(i)],
                                 x2 = q[std::size_t(i + 1)], x3 = q[std::size_t(std::min(i + 2, 5))];
                const glm::dquat a = (3.0 * x1 - 3.0 * x2 + x3 - x0) * 0.5,
                                 b = (2.0 * x0 - 5.0 * x1 + 4.0 * x2 - x3) * 0.5, c = (x2 - x0) * 0.5;
                const glm::dquat expected = glm::normalize(a * (u * u * u) + b * (u * u) + c * u + x1);
                worst = std::max(worst, angleBetween(valueAt(track, t0 + u * (t1 - t0)), expected));
            }
        }
        QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
    }
    void squadPassesTheKeysWithoutAJumpOfSpeed()
    {
        Random random(4, RandomStream::Test);
        for (int run = 0; run < 100; ++run) {
            std::vector<OrientationKey> keys;
            glm::dquat q = randomTurn(random);
            double time = 0.0;
            for (int i = 0; i < 5; ++i) {
                keys.push_back(keyAt(time, q, KeyMode::Cubic));
                q = q * about(glm::dvec3(randomTurn(random).x, randomTurn(random).y, 0.5),
                              random.range(0.1, 1.2));
                time += random.range(0.3, 2.0);
            }
            const OrientationTrack track = trackOf(keys);
            for (int i = 1; i < 4; ++i) {
                const double t = secondsOf(keys[std::size_t(i)].time), h = 1e-5;
                QVERIFY(angleBetween(valueAt(track, t), keys[std::size_t(i)].value) < 1e-9);
                const glm::dvec3 before =
                    logarithm(glm::conjugate(valueAt(track, t - h)) * valueAt(track, t)) / h;
                const glm::dvec3 behind =
                    logarithm(glm::conjugate(valueAt(track, t)) * valueAt(track, t + h)) / h;
                QVERIFY2(std::abs(before.x - behind.x) + std::abs(before.y - behind.y) +
                                 std::abs(before.z - behind.z) <
                             1e-2,
                         "the speed jumps");
            }
        }
    }
    void roundsTurnOn()
    {
        OrientationTrack track =
            trackOf({keyAt(0.0, about({0, 1, 0}, 0.0)), keyAt(1.0, about({0, 1, 0}, 0.7))});
        track.before = track.behind = Extrapolation::RepeatOffset;
        for (const double t : {-3.25, -1.0, 0.5, 2.5, 10.0})
            QVERIFY(angleBetween(valueAt(track, t), about({0, 1, 0}, 0.7 * t)) < 1e-7);
        track.before = track.behind = Extrapolation::Linear;
        for (const double t : {-0.5, 1.5, 3.0})
            QVERIFY(angleBetween(valueAt(track, t), about({0, 1, 0}, 0.7 * t)) < 1e-7);
    }
};

RAMURE_SUITE(TestOrientationTrack)

} // namespace tst_orientation_track

#include "tst_orientation_track.moc"
