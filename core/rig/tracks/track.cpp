#include "core/rig/tracks/track.h"

#include "core/rig/tracks/handles.h"
#include "core/rig/tracks/quaternions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>

namespace ramure {
namespace {

tl::unexpected<Error> refuse(const char* member, const char* text)
{
    auto error = fail(ErrorCode::Invalid, text);
    error.value().path = member;
    return error;
}

bool isFinite(const Handle& handle)
{
    return std::isfinite(handle.dt) && std::isfinite(handle.dv);
}

Expected<void> checkShape(const KeyShape& key)
{
    if (key.time < -mostTicks || key.time > mostTicks)
        return refuse("time", RAMURE_NOOP("the time lies beyond a million seconds"));
    if (!std::isfinite(key.back))
        return refuse("back", RAMURE_NOOP("must be a finite number"));
    if (!std::isfinite(key.amplitude) || key.amplitude < 0.0)
        return refuse("amplitude", RAMURE_NOOP("must be a finite number that is not negative"));
    if (!std::isfinite(key.period) || key.period < 0.0)
        return refuse("period", RAMURE_NOOP("must be a finite number that is not negative"));
    return {};
}

Expected<void> checkKey(const Key& key)
{
    if (!std::isfinite(key.value))
        return refuse("value", RAMURE_NOOP("must be a finite number"));
    if (!isFinite(key.in) || !isFinite(key.out))
        return refuse("handles", RAMURE_NOOP("must be finite numbers"));
    return checkShape(key);
}

Expected<void> checkKey(const OrientationKey& key)
{
    const double length = glm::dot(key.value, key.value);
    if (!std::isfinite(length) || length < 1e-12)
        return refuse("value", RAMURE_NOOP("a quaternion of this length has no direction"));
    if (!std::all_of(key.in.begin(), key.in.end(), isFinite) ||
        !std::all_of(key.out.begin(), key.out.end(), isFinite))
        return refuse("handles", RAMURE_NOOP("must be finite numbers"));
    return checkShape(key);
}

void turnRound(OrientationKey& key)
{
    key.value = -key.value;
    for (int i = 0; i < 4; ++i) {
        auto& in = key.in[static_cast<std::size_t>(i)];
        auto& out = key.out[static_cast<std::size_t>(i)];
        in.dv = -in.dv;
        out.dv = -out.dv;
    }
}

bool firstCoordinateIsNegative(const glm::dvec3& v)
{
    for (int i = 0; i < 3; ++i)
        if (std::abs(v[i]) > 1e-6)
            return v[i] < 0.0;
    return false;
}

/// The way from an orientation to the next one: its axis times the sine of half its angle.
struct Turn
{
    Turn(const glm::dquat& from, const glm::dquat& to)
    {
        const glm::dquat turn = glm::conjugate(from) * to;
        cosine = turn.w;
        axis = {turn.x, turn.y, turn.z};
    }
    [[nodiscard]] bool hasAxis() const { return glm::dot(axis, axis) > 1e-12; }
    [[nodiscard]] glm::dvec3 direction() const { return axis / std::sqrt(glm::dot(axis, axis)); }

    double cosine = 0.0;
    glm::dvec3 axis{0.0};
};

/// Gives \p key the sign that makes the way from \p before the shorter one. \p turnBefore: the direction of
/// the turn before; becomes that of this one. Returns whether this one has a direction.
bool settleSign(const glm::dquat& before, OrientationKey& key, glm::dvec3& turnBefore)
{
    constexpr double halfTurn = 1e-7; // cosine of half an angle that counts as 180 degrees
    const Turn turn(before, key.value);
    bool wrong = turn.cosine < 0.0;
    if (std::abs(turn.cosine) < halfTurn) {
        const double along = glm::dot(turn.axis, turnBefore);
        wrong = std::abs(along) > 1e-6 ? along < 0.0 : firstCoordinateIsNegative(turn.axis);
    }
    if (wrong)
        turnRound(key);
    if (!turn.hasAxis())
        return false;
    turnBefore = wrong ? -turn.direction() : turn.direction();
    return true;
}

void settleSigns(std::vector<OrientationKey>& keys)
{
    glm::dvec3 turnBefore(0.0);
    for (std::size_t i = 1; i < keys.size(); ++i)
        settleSign(keys[i - 1].value, keys[i], turnBefore);
}

/// What is a unit already stays as it is to the last digit: settling twice changes nothing.
void settleLength(OrientationKey& key)
{
    if (std::abs(glm::dot(key.value, key.value) - 1.0) > 1e-15)
        key.value = unit(key.value, {1.0, 0.0, 0.0, 0.0});
}

/// \p settle is given the keys of each component.
template <class Settle> void settleComponents(std::vector<OrientationKey>& keys, Settle&& settle)
{
    std::vector<Key> curve(keys.size());
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t i = 0; i < keys.size(); ++i)
            curve[i] = componentKey(keys[i], c);
        settle(curve);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            keys[i].in[c] = curve[i].in;
            keys[i].out[c] = curve[i].out;
        }
    }
}

void settleTurns(std::vector<Key>&)
{
}

void settleTurns(std::vector<OrientationKey>& keys)
{
    for (OrientationKey& key : keys)
        settleLength(key);
    settleSigns(keys);
}

void settleAllHandles(std::vector<Key>& keys, bool goesRound)
{
    if (goesRound)
        settleHandlesOfLoop(keys, keys.back().value - keys.front().value);
    else
        settleHandles(keys);
}

void settleAllHandles(std::vector<OrientationKey>& keys, bool goesRound)
{
    settleComponents(keys, [goesRound](std::vector<Key>& curve) { settleAllHandles(curve, goesRound); });
}

/// Handles after a change of the keys first .. last of a track that does not go round.
void settleHandlesIn(KeyList<Key>& keys, std::size_t first, std::size_t last)
{
    const auto reach = handlesReach(keys, first, last);
    std::vector<Key> around = keys.copied(reach.first, reach.second + 1);
    settleHandlesAround(around, first - reach.first, last - reach.first);
    keys.overwrite(reach.first, around);
}

void settleHandlesIn(KeyList<OrientationKey>& keys, std::size_t first, std::size_t last)
{
    const auto reach = handlesReach(keys, first, last);
    std::vector<OrientationKey> around = keys.copied(reach.first, reach.second + 1);
    settleComponents(around, [&](std::vector<Key>& curve) {
        settleHandlesAround(curve, first - reach.first, last - reach.first);
    });
    keys.overwrite(reach.first, around);
}

/// The direction of the last turn before the key \p index, as settleSigns() finds it.
glm::dvec3 turnBeforeKey(const KeyList<OrientationKey>& keys, std::size_t index)
{
    for (; index >= 2; --index) {
        const Turn turn(keys[index - 2].value, keys[index - 1].value);
        if (turn.hasAxis())
            return turn.direction();
    }
    return glm::dvec3(0.0);
}

/// After a change of the keys first .. last: makes them units and gives signs, to them and to those behind
/// as far as these hang on them; handles turn round with their keys. \p seams: the keys behind that turned
/// round while the one before them did not, or the other way about, are added.
void settleSignsIn(KeyList<OrientationKey>& keys, std::size_t first, std::size_t last,
                   std::vector<std::size_t>& seams)
{
    glm::dvec3 turnBefore = turnBeforeKey(keys, first);
    std::vector<OrientationKey> fresh;
    std::size_t changed = last;
    bool turnedBefore = false;
    for (std::size_t i = first; i < keys.size(); ++i) {
        const OrientationKey& old = keys[i];
        OrientationKey key = old;
        settleLength(key);
        const bool hasAxis =
            i > 0 && settleSign(i == first ? keys[i - 1].value : fresh.back().value, key, turnBefore);
        const bool turned = glm::dot(key.value, old.value) < 0.0;
        if (i > last + 1 && turned != turnedBefore)
            seams.push_back(i);
        turnedBefore = turned;
        if (key.value != old.value)
            changed = std::max(changed, i);
        fresh.push_back(key);
        if (hasAxis && i > changed + 1)
            break; // this key and the one before stay: so does the turn between, and all that follows
    }
    keys.overwrite(first, fresh);
}

template <class KeyType> Expected<void> checkKeys(std::span<const KeyType> keys)
{
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (auto good = checkKey(keys[i]); !good) {
            Error error = std::move(good.error());
            error.path = std::string("[").append(std::to_string(i)).append("].").append(error.path);
            return fail(std::move(error));
        }
    return {};
}

/// Whether the track would go round with these keys.
template <class TrackType, class Keys> bool isRound(const TrackType& track, const Keys& keys)
{
    if (keys.size() < 2)
        return false;
    const auto repeats = [](Extrapolation way) {
        return way == Extrapolation::Repeat || way == Extrapolation::RepeatOffset;
    };
    const Ticks first = keys.front().time, last = keys.back().time, loop = track.loop;
    const bool wholePeriod = loop > 0 && last - first == loop && first % loop == 0;
    if (!wholePeriod && !(loop == 0 && repeats(track.before) && repeats(track.behind)))
        return false;
    // Components of orientations that end elsewhere than they began do not simply go on from there.
    if constexpr (std::is_same_v<TrackType, OrientationTrack>)
        return glm::dot(keys.front().value, keys.back().value) > 1.0 - 1e-9;
    return true;
}

/// As many edited keys are put in their places one by one; of more the whole track is made anew.
constexpr std::size_t few = 16;

} // namespace

template <class KeyType> bool KeyTrack<KeyType>::goesRound() const
{
    return isRound(*this, m_keys);
}

template <class KeyType> void KeyTrack<KeyType>::settle(std::vector<KeyType> keys)
{
    const auto earlier = [](const KeyType& a, const KeyType& b) { return a.time < b.time; };
    if (!std::is_sorted(keys.begin(), keys.end(), earlier))
        std::stable_sort(keys.begin(), keys.end(), earlier);
    // Of equal times the last: unique() keeps the first, so it runs from behind.
    const auto sameTime = [](const KeyType& a, const KeyType& b) { return a.time == b.time; };
    const auto kept = std::unique(keys.rbegin(), keys.rend(), sameTime);
    keys.erase(keys.begin(), kept.base());
    settleTurns(keys);
    settleAllHandles(keys, isRound(*this, keys)); // the signs of the ends tell
    m_keys.assign(keys);
}

template <class KeyType> Expected<KeyTrack<KeyType>> KeyTrack<KeyType>::fromKeys(std::vector<KeyType> keys)
{
    RAMURE_TRY(checkKeys(std::span<const KeyType>(keys)));
    KeyTrack track;
    track.settle(std::move(keys));
    return track;
}

template <class KeyType> std::optional<std::size_t> KeyTrack<KeyType>::find(Ticks time) const
{
    const std::size_t at = lowerBound(time);
    if (at < m_keys.size() && m_keys.timeOf(at) == time)
        return at;
    return std::nullopt;
}

template <class KeyType> Expected<void> KeyTrack<KeyType>::insert(KeyType key)
{
    if (auto good = checkKey(key); !good)
        return good;
    const bool wasRound = goesRound();
    const std::size_t at = lowerBound(key.time);
    const std::size_t end = at < m_keys.size() && m_keys.timeOf(at) == key.time ? at + 1 : at;
    m_keys.splice(at, end, std::span<const KeyType>(&key, 1));
    if (wasRound)
        settleEnds(); // the other end may have had this side for its neighbour
    else
        settleAround({{at, at}});
    return {};
}

template <class KeyType> void KeyTrack<KeyType>::erase(std::span<const std::size_t> indices)
{
    std::vector<std::size_t> gone(indices.begin(), indices.end());
    std::sort(gone.begin(), gone.end());
    gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
    gone.erase(std::lower_bound(gone.begin(), gone.end(), m_keys.size()), gone.end());
    if (gone.size() > few || goesRound()) {
        std::vector<KeyType> keys = m_keys.toVector();
        for (std::size_t next = 0, to = 0, i = 0; i < m_keys.size(); ++i) {
            if (next < gone.size() && gone[next] == i)
                ++next;
            else
                keys[to++] = keys[i];
        }
        keys.resize(m_keys.size() - gone.size());
        return settle(std::move(keys));
    }
    for (std::size_t i = gone.size(); i-- > 0;)
        m_keys.splice(gone[i], gone[i] + 1, {});
    std::vector<Range> ranges;
    for (std::size_t i = 0; i < gone.size() && !m_keys.empty(); ++i) {
        const std::size_t at = std::min(gone[i] - i, m_keys.size() - 1);
        ranges.emplace_back(at > 0 ? at - 1 : 0, at);
    }
    settleAround(std::move(ranges));
}

template <class KeyType>
Expected<void> KeyTrack<KeyType>::replace(std::span<const std::size_t> indices, std::span<const KeyType> keys)
{
    if (auto good = checkKeys(keys); !good)
        return good;
    for (const std::size_t index : indices)
        if (index >= m_keys.size() || indices.size() != keys.size())
            return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no key %1"), {std::to_string(index)});
    if (indices.empty())
        return {};
    const bool wasRound = goesRound();
    if (keepsOrder(indices, keys)) {
        m_keys.overwrite(indices, keys);
        if (wasRound)
            settleEnds();
        else if (indices.size() > few)
            settleAround({{indices.front(), indices.back()}});
        else {
            std::vector<Range> ranges;
            for (const std::size_t index : indices)
                ranges.emplace_back(index, index);
            settleAround(std::move(ranges));
        }
    } else if (indices.size() > few || wasRound) {
        replaceMany(indices, keys);
    } else {
        replaceFew(indices, keys);
    }
    return {};
}

template <class KeyType>
void KeyTrack<KeyType>::replaceMany(std::span<const std::size_t> indices, std::span<const KeyType> keys)
{
    std::vector<bool> changes(m_keys.size(), false);
    for (const std::size_t index : indices)
        changes[index] = true;
    std::vector<KeyType> stay, come(keys.begin(), keys.end()), all;
    stay.reserve(m_keys.size());
    std::size_t next = 0;
    for (const KeyType& key : m_keys)
        if (!changes[next++])
            stay.push_back(key);
    const auto earlier = [](const KeyType& a, const KeyType& b) { return a.time < b.time; };
    std::stable_sort(come.begin(), come.end(), earlier);
    all.reserve(m_keys.size());
    // Of equal times those that stay come first: the others take their place.
    std::merge(stay.begin(), stay.end(), come.begin(), come.end(), std::back_inserter(all), earlier);
    settle(std::move(all));
}

/// A few that have gone elsewhere among very many: only what is around their old and new places changes.
template <class KeyType>
void KeyTrack<KeyType>::replaceFew(std::span<const std::size_t> indices, std::span<const KeyType> keys)
{
    std::vector<std::size_t> left(indices.begin(), indices.end());
    std::sort(left.begin(), left.end());
    left.erase(std::unique(left.begin(), left.end()), left.end());
    std::vector<Ticks> times;
    for (std::size_t i = left.size(); i-- > 0;) {
        times.push_back(m_keys.timeOf(left[i]));
        m_keys.splice(left[i], left[i] + 1, {});
    }
    for (const KeyType& key : keys) { // the later of two at one time takes the place of the other
        times.push_back(key.time);
        const std::size_t at = lowerBound(key.time);
        const std::size_t end = at < m_keys.size() && m_keys.timeOf(at) == key.time ? at + 1 : at;
        m_keys.splice(at, end, std::span<const KeyType>(&key, 1));
    }
    std::sort(times.begin(), times.end()); // signs of orientations hang on those before them
    std::vector<Range> ranges;
    for (const Ticks time : times) {
        const std::size_t at = std::min(lowerBound(time), m_keys.size() - 1);
        ranges.emplace_back(at > 0 ? at - 1 : 0, at);
    }
    settleAround(std::move(ranges));
}

/// Every key stays between its neighbours.
template <class KeyType>
bool KeyTrack<KeyType>::keepsOrder(std::span<const std::size_t> indices, std::span<const KeyType> keys) const
{
    if (!std::is_sorted(indices.begin(), indices.end(), std::less_equal<>()))
        return false;
    const auto timeOf = [&](std::size_t index, std::size_t from) { // `from` is the place in the list
        return from < indices.size() && indices[from] == index ? keys[from].time : m_keys.timeOf(index);
    };
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::size_t at = indices[i];
        if ((i == 0 && at > 0 && m_keys.timeOf(at - 1) >= keys[i].time) ||
            (i > 0 && timeOf(at - 1, indices[i - 1] == at - 1 ? i - 1 : indices.size()) >= keys[i].time) ||
            (at + 1 < m_keys.size() && timeOf(at + 1, i + 1) <= keys[i].time))
            return false;
    }
    return true;
}

/// All signs come before any handle: one that stands in line with the other of its key keeps its length only
/// up to rounding when that turns, so it is to turn once, to where it stays.
template <class KeyType> void KeyTrack<KeyType>::settleAround(std::vector<Range> ranges)
{
    if (goesRound())
        return settleEnds();
    if constexpr (std::is_same_v<KeyType, OrientationKey>) {
        std::vector<std::size_t> seams;
        for (const auto& [first, last] : ranges)
            settleSignsIn(m_keys, first, last, seams);
        if (seams.size() > few || goesRound()) // the ends may have come together by it
            return settleEnds();
        for (const std::size_t seam : seams)
            ranges.emplace_back(seam - 1, seam);
    }
    // What reaches into one another settles as one, for the same reason.
    std::sort(ranges.begin(), ranges.end());
    for (auto next = ranges.begin(); next != ranges.end();) {
        auto [first, last] = *next;
        auto end = handlesReach(m_keys, first, last).second;
        while (++next != ranges.end() && handlesReach(m_keys, next->first, next->second).first <= end) {
            last = std::max(last, next->second);
            end = std::max(end, handlesReach(m_keys, next->first, next->second).second);
        }
        settleHandlesIn(m_keys, first, last);
    }
}

template <class KeyType> void KeyTrack<KeyType>::settleEnds()
{
    settle(m_keys.toVector());
}

template class KeyTrack<Key>;
template class KeyTrack<OrientationKey>;

const char* extrapolationName(Extrapolation extrapolation)
{
    constexpr std::array<const char*, extrapolationCount> names{"hold", "linear", "repeat", "repeatOffset",
                                                                "mirror"};
    return names[static_cast<std::size_t>(extrapolation)];
}

const char* orientationBlendName(OrientationBlend blend)
{
    constexpr std::array<const char*, orientationBlendCount> names{"spherical", "classic", "components"};
    return names[static_cast<std::size_t>(blend)];
}

} // namespace ramure
