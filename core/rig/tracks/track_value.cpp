// The value of a track at a time.
#include "core/rig/tracks/bezier.h"
#include "core/rig/tracks/easing.h"
#include "core/rig/tracks/quaternions.h"
#include "core/rig/tracks/track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {

namespace {

/// Where on the keys a time falls.
struct TrackPlace
{
    double ticks = 0.0;
    double rounds = 0.0; ///< whole rounds from the first one: of RepeatOffset
    double beyond = 0.0; ///< ticks before the first key (negative) or behind the last one: of Linear
};

Extrapolation repeats(Extrapolation extrapolation)
{
    return extrapolation >= Extrapolation::Repeat ? extrapolation : Extrapolation::Hold;
}

template <class KeyType> TrackPlace placeOf(const KeyTrack<KeyType>& track, double seconds)
{
    TrackPlace place{exactTicks(seconds), 0.0, 0.0};
    if (track.loop > 0) {
        const auto period = double(track.loop);
        place.ticks -= period * std::floor(place.ticks / period);
    }
    const auto first = double(track.keys().front().time), last = double(track.keys().back().time);
    if (place.ticks >= first && place.ticks <= last)
        return place;
    const bool early = place.ticks < first;
    const Extrapolation wanted = early ? track.before : track.behind;
    const double span = last - first, at = place.ticks;
    place.ticks = early ? first : last;
    if (span > 0.0 && repeats(wanted) != Extrapolation::Hold) {
        // Exactly at an end the key of that end: the last one behind, the first one before.
        const double share = (at - first) / span;
        const double rounds = early ? std::floor(share) : std::ceil(share) - 1.0;
        place.ticks = std::clamp(at - rounds * span, first, last);
        if (wanted == Extrapolation::Mirror && std::fmod(rounds, 2.0) != 0.0)
            place.ticks = first + last - place.ticks;
        if (wanted == Extrapolation::RepeatOffset)
            place.rounds = rounds;
    } else if (wanted == Extrapolation::Linear) {
        place.beyond = early ? at - first : at - last;
    }
    return place;
}

/// The segment, or the last key, in which the time lies. Half a tick before a key is at the key: the time of
/// a frame whose key was rounded to its tick must not show the key before.
template <class KeyType>
std::size_t segmentAt(const KeyList<KeyType>& keys, double exactly, TrackCursor& cursor)
{
    const double ticks = exactly + 0.5;
    const auto holds = [&](std::size_t i) {
        return double(keys.timeOf(i)) <= ticks &&
               (i + 1 == keys.size() || ticks < double(keys.timeOf(i + 1)));
    };
    for (std::size_t i = cursor.segment; i < keys.size() && i < cursor.segment + 2; ++i)
        if (holds(i))
            return cursor.segment = i;
    return cursor.segment = std::max<std::size_t>(keys.upperBound(ticks), 1) - 1;
}

/// The spline of SPEC B1 through x1 and x2.
double classicCubic(double x0, double x1, double x2, double x3, double u)
{
    const double a = 0.5 * (3.0 * x1 - 3.0 * x2 + x3 - x0), b = 0.5 * (2.0 * x0 - 5.0 * x1 + 4.0 * x2 - x3);
    return ((a * u + b) * u + 0.5 * (x2 - x0)) * u + x1;
}

/// One segment of one number.
struct Segment
{
    const KeyShape& shape;
    double v0, v1;
    Handle out, in;
    double before, behind; ///< values of the neighbours, repeated at the ends
    double duration, u;

    [[nodiscard]] double value() const
    {
        switch (shape.mode) {
        case KeyMode::Constant:
            return v0;
        case KeyMode::Linear:
            return v0 + (v1 - v0) * u;
        case KeyMode::Bezier:
            return bezierValue(duration, v0, out, in, v1, u * duration);
        case KeyMode::Cubic:
            return classicCubic(before, v0, v1, behind, u);
        default:
            return v0 + (v1 - v0) * easedShare(shape, u, duration, v1 - v0);
        }
    }
};

/// The values before and behind a segment: at the ends of a track those on the other side where it goes
/// round, else the end once more.
std::pair<double, double> aroundSegment(const Track& track, std::size_t i)
{
    const KeyList<Key>& keys = track.keys();
    const std::size_t last = keys.size() - 1;
    const bool atEnd = i == 0 || i + 1 == last;
    if (!atEnd || keys[i].mode != KeyMode::Cubic || !track.goesRound())
        return {keys[i == 0 ? 0 : i - 1].value, keys[std::min(i + 2, last)].value};
    const double shift = keys[last].value - keys[0].value;
    return {i == 0 ? keys[last - 1].value - shift : keys[i - 1].value,
            i + 1 == last ? keys[1].value + shift : keys[i + 2].value};
}

double inSegment(const Track& track, std::size_t i, double ticks)
{
    const KeyList<Key>& keys = track.keys();
    const Key& from = keys[i];
    const auto offset = ticks - double(from.time);
    if (offset <= 0.0 || i + 1 == keys.size())
        return from.value;
    const Key& to = keys[i + 1];
    const auto span = double(to.time - from.time);
    const auto around = aroundSegment(track, i);
    return Segment{from,         from.value,   to.value,      from.out,
                   to.in,        around.first, around.second, span / double(ticksPerSecond),
                   offset / span}
        .value();
}

/// Of the curve at its first or last key, in units per tick, for the straight way on.
double slopeAtEnd(const KeyList<Key>& keys, bool early)
{
    if (keys.size() < 2)
        return 0.0;
    const Key& end = early ? keys.front() : keys.back();
    const Key& inner = early ? keys[1] : keys[keys.size() - 2];
    switch (end.mode) {
    case KeyMode::Linear:
    case KeyMode::Cubic:
        return (end.value - inner.value) / double(end.time - inner.time);
    case KeyMode::Bezier: {
        const Handle& handle = early ? end.out : end.in;
        return handle.dt == 0.0 ? 0.0 : handle.dv / handle.dt / double(ticksPerSecond);
    }
    default:
        return 0.0;
    }
}

double part(const glm::dquat& q, std::size_t c)
{
    return c == 0 ? q.w : c == 1 ? q.x : c == 2 ? q.y : q.z;
}

/// Everything by components.
glm::dquat blended(const OrientationTrack& track, std::size_t i, double duration, double u)
{
    const KeyList<OrientationKey>& keys = track.keys();
    const OrientationKey &from = keys[i], &to = keys[i + 1];
    const std::size_t last = keys.size() - 1;
    const bool round = (i == 0 || i + 1 == last) && track.goesRound(); // then both ends are the same
    const glm::dquat& before = keys[i > 0 ? i - 1 : round ? last - 1 : 0].value;
    const glm::dquat& behind = keys[i + 1 < last ? i + 2 : round ? 1 : last].value;
    double v[4];
    for (std::size_t c = 0; c < 4; ++c)
        v[c] = Segment{from,     part(from.value, c), part(to.value, c), from.out[c],
                       to.in[c], part(before, c),     part(behind, c),   duration,
                       u}
                   .value();
    return unit({v[0], v[1], v[2], v[3]}, from.value);
}

/// The angular velocity at a key by which the orientation passes it smoothly, times \p scale: that of the
/// parabola through the key and its two neighbours, in the key's own space. At an end half that of the only
/// neighbour, as where the end is repeated.
glm::dvec3 velocityAt(const OrientationTrack& track, std::size_t i, double scale)
{
    const KeyList<OrientationKey>& keys = track.keys();
    const std::size_t last = keys.size() - 1;
    const bool round = (i == 0 || i == last) && track.goesRound();
    const glm::dquat back = glm::conjugate(keys[i].value);
    glm::dvec3 slow(0.0), fast(0.0);
    double before = 0.0, behind = 0.0;
    if (i > 0) {
        before = double(keys[i].time - keys[i - 1].time);
        slow = -logarithm(back * keys[i - 1].value) / before;
    } else if (round) {
        before = double(keys[last].time - keys[last - 1].time);
        slow = -logarithm(glm::conjugate(keys[last].value) * keys[last - 1].value) / before;
    }
    if (i < last) {
        behind = double(keys[i + 1].time - keys[i].time);
        fast = logarithm(back * keys[i + 1].value) / behind;
    } else if (round) {
        behind = double(keys[1].time - keys[0].time);
        fast = logarithm(glm::conjugate(keys[0].value) * keys[1].value) / behind;
    }
    if (before == 0.0 || behind == 0.0)
        return 0.5 * scale * (slow + fast);
    return scale * (behind * slow + before * fast) / (before + behind);
}

glm::dquat squadAt(const OrientationTrack& track, std::size_t i, double u)
{
    const KeyList<OrientationKey>& keys = track.keys();
    const glm::dquat &a = keys[i].value, &b = keys[i + 1].value;
    const auto span = double(keys[i + 1].time - keys[i].time);
    const glm::dvec3 ahead = logarithm(glm::conjugate(a) * b), back = logarithm(glm::conjugate(b) * a);
    const glm::dquat sa = a * exponential(0.5 * (velocityAt(track, i, span) - ahead));
    const glm::dquat sb = b * exponential(-0.5 * (velocityAt(track, i + 1, span) + back));
    return squadded(a, sa, sb, b, u);
}

glm::dquat inSegment(const OrientationTrack& track, std::size_t i, double ticks)
{
    const KeyList<OrientationKey>& keys = track.keys();
    const OrientationKey& from = keys[i];
    const auto offset = ticks - double(from.time);
    if (offset <= 0.0 || i + 1 == keys.size() || from.mode == KeyMode::Constant)
        return from.value;
    const OrientationKey& to = keys[i + 1];
    const auto span = double(to.time - from.time);
    const double u = offset / span, duration = span / double(ticksPerSecond);
    const bool byComponents = track.blend == OrientationBlend::Components || from.mode == KeyMode::Bezier ||
                              (from.mode == KeyMode::Cubic && track.blend == OrientationBlend::Classic);
    if (byComponents)
        return blended(track, i, duration, u);
    if (from.mode == KeyMode::Linear)
        return slerped(from.value, to.value, u);
    if (from.mode == KeyMode::Cubic)
        return squadAt(track, i, u);
    const glm::dvec3 half = logarithm(glm::conjugate(from.value) * to.value);
    return slerped(from.value, to.value,
                   easedShare(from, u, duration, 2.0 * std::sqrt(glm::dot(half, half))));
}

/// On along the last way, or back along the first.
glm::dquat beyondEnd(const KeyList<OrientationKey>& keys, double beyond)
{
    const bool early = beyond < 0.0;
    const OrientationKey& end = early ? keys.front() : keys.back();
    if (keys.size() < 2 || end.mode == KeyMode::Constant || end.mode >= firstEasingMode)
        return end.value;
    const OrientationKey& inner = early ? keys[1] : keys[keys.size() - 2];
    const double share = std::abs(beyond) / double(std::abs(end.time - inner.time));
    return slerped(inner.value, end.value, 1.0 + share);
}

/// What one round turns, as often as there were rounds.
glm::dquat turnOfRounds(const KeyList<OrientationKey>& keys, double rounds)
{
    glm::dquat turn = keys.back().value * glm::conjugate(keys.front().value);
    if (turn.w < 0.0)
        turn = -turn;
    return exponential(logarithm(turn) * rounds);
}

} // namespace

double valueAt(const Track& track, double seconds, TrackCursor& cursor)
{
    const TrackPlace place = placeOf(track, seconds);
    const KeyList<Key>& keys = track.keys();
    double value = inSegment(track, segmentAt(track.keys(), place.ticks, cursor), place.ticks);
    if (place.beyond != 0.0)
        value += place.beyond * slopeAtEnd(keys, place.beyond < 0.0);
    if (place.rounds != 0.0)
        value += place.rounds * (keys.back().value - keys.front().value);
    return value;
}

double valueAt(const Track& track, double seconds)
{
    TrackCursor cursor;
    return valueAt(track, seconds, cursor);
}

glm::dquat valueAt(const OrientationTrack& track, double seconds, TrackCursor& cursor)
{
    const TrackPlace place = placeOf(track, seconds);
    if (place.beyond != 0.0)
        return beyondEnd(track.keys(), place.beyond);
    const glm::dquat value = inSegment(track, segmentAt(track.keys(), place.ticks, cursor), place.ticks);
    return place.rounds == 0.0 ? value : unit(turnOfRounds(track.keys(), place.rounds) * value, value);
}

glm::dquat valueAt(const OrientationTrack& track, double seconds)
{
    TrackCursor cursor;
    return valueAt(track, seconds, cursor);
}

} // namespace ramure
