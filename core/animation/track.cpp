#include "core/animation/track.h"

#include "core/animation/handles.h"
#include "core/animation/quaternions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
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

double& component(glm::dquat& q, int i)
{
    return i == 0 ? q.w : i == 1 ? q.x : i == 2 ? q.y : q.z;
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

/// Gives every key the sign that makes the way from the one before the shorter one.
void settleSigns(std::vector<OrientationKey>& keys)
{
    constexpr double halfTurn = 1e-7; // cosine of half an angle that counts as 180 degrees
    glm::dvec3 turnBefore(0.0);
    for (std::size_t i = 1; i < keys.size(); ++i) {
        glm::dquat turn = glm::conjugate(keys[i - 1].value) * keys[i].value;
        const glm::dvec3 axis{turn.x, turn.y, turn.z};
        bool wrong = turn.w < 0.0;
        if (std::abs(turn.w) < halfTurn) {
            const double along = glm::dot(axis, turnBefore);
            wrong = std::abs(along) > 1e-6 ? along < 0.0 : firstCoordinateIsNegative(axis);
        }
        if (wrong)
            turnRound(keys[i]);
        if (glm::dot(axis, axis) > 1e-12)
            turnBefore = (wrong ? -axis : axis) / std::sqrt(glm::dot(axis, axis));
    }
}

void settleKeys(std::vector<Key>& keys, bool goesRound)
{
    if (goesRound)
        settleHandlesOfLoop(keys, keys.back().value - keys.front().value);
    else
        settleHandles(keys);
}

void settleKeys(std::vector<OrientationKey>& keys, bool goesRound)
{
    for (OrientationKey& key : keys)
        // What is a unit already stays as it is to the last digit: settling twice changes nothing.
        if (std::abs(glm::dot(key.value, key.value) - 1.0) > 1e-15)
            key.value = unit(key.value, {1.0, 0.0, 0.0, 0.0});
    settleSigns(keys);
    std::vector<Key> curve(keys.size());
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t i = 0; i < keys.size(); ++i) {
            static_cast<KeyShape&>(curve[i]) = keys[i];
            curve[i].value = component(keys[i].value, static_cast<int>(c));
            curve[i].in = keys[i].in[c];
            curve[i].out = keys[i].out[c];
        }
        if (goesRound)
            settleHandlesOfLoop(curve, curve.back().value - curve.front().value);
        else
            settleHandles(curve);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            keys[i].in[c] = curve[i].in;
            keys[i].out[c] = curve[i].out;
        }
    }
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

} // namespace

template <class KeyType> bool KeyTrack<KeyType>::goesRound() const
{
    if (m_keys.size() < 2)
        return false;
    const auto repeats = [](Extrapolation way) {
        return way == Extrapolation::Repeat || way == Extrapolation::RepeatOffset;
    };
    const Ticks first = m_keys.front().time, last = m_keys.back().time;
    const bool wholePeriod = loop > 0 && last - first == loop && first % loop == 0;
    if (!wholePeriod && !(loop == 0 && repeats(before) && repeats(behind)))
        return false;
    // Components of orientations that end elsewhere than they began do not simply go on from there.
    if constexpr (std::is_same_v<KeyType, OrientationKey>)
        return glm::dot(m_keys.front().value, m_keys.back().value) > 1.0 - 1e-9;
    return true;
}

template <class KeyType> void KeyTrack<KeyType>::settle()
{
    const auto earlier = [](const KeyType& a, const KeyType& b) { return a.time < b.time; };
    if (!std::is_sorted(m_keys.begin(), m_keys.end(), earlier))
        std::stable_sort(m_keys.begin(), m_keys.end(), earlier);
    // Of equal times the last: unique() keeps the first, so it runs from behind.
    const auto sameTime = [](const KeyType& a, const KeyType& b) { return a.time == b.time; };
    const auto kept = std::unique(m_keys.rbegin(), m_keys.rend(), sameTime);
    m_keys.erase(m_keys.begin(), kept.base());
    settleKeys(m_keys, goesRound());
    m_times.resize(m_keys.size());
    std::transform(m_keys.begin(), m_keys.end(), m_times.begin(),
                   [](const KeyType& key) { return key.time; });
}

template <class KeyType> Expected<KeyTrack<KeyType>> KeyTrack<KeyType>::fromKeys(std::vector<KeyType> keys)
{
    if (auto good = checkKeys(std::span<const KeyType>(keys)); !good)
        return fail(std::move(good.error()));
    KeyTrack track;
    track.m_keys = std::move(keys);
    track.settle();
    return track;
}

template <class KeyType> std::size_t KeyTrack<KeyType>::lowerBound(Ticks time) const
{
    return static_cast<std::size_t>(std::lower_bound(m_times.begin(), m_times.end(), time) - m_times.begin());
}

template <class KeyType> std::optional<std::size_t> KeyTrack<KeyType>::find(Ticks time) const
{
    const std::size_t at = lowerBound(time);
    if (at < m_times.size() && m_times[at] == time)
        return at;
    return std::nullopt;
}

template <class KeyType> Expected<void> KeyTrack<KeyType>::insert(KeyType key)
{
    if (auto good = checkKey(key); !good)
        return good;
    const std::size_t at = lowerBound(key.time);
    if (at < m_keys.size() && m_keys[at].time == key.time) {
        m_keys[at] = std::move(key);
    } else {
        m_times.insert(m_times.begin() + static_cast<std::ptrdiff_t>(at), key.time);
        m_keys.insert(m_keys.begin() + static_cast<std::ptrdiff_t>(at), std::move(key));
    }
    settleAround(at, at);
    return {};
}

template <class KeyType> void KeyTrack<KeyType>::erase(std::span<const std::size_t> indices)
{
    std::vector<bool> gone(m_keys.size(), false);
    for (const std::size_t index : indices)
        if (index < gone.size())
            gone[index] = true;
    std::size_t next = 0;
    std::erase_if(m_keys, [&](const KeyType&) { return bool(gone[next++]); });
    settle();
}

template <class KeyType>
Expected<void> KeyTrack<KeyType>::replace(std::span<const std::size_t> indices, std::span<const KeyType> keys)
{
    if (auto good = checkKeys(keys); !good)
        return good;
    for (const std::size_t index : indices)
        if (index >= m_keys.size() || indices.size() != keys.size())
            return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no key %1"), {std::to_string(index)});
    if (replaceInPlace(indices, keys))
        return {};
    std::vector<bool> changes(m_keys.size(), false);
    std::vector<Ticks> left;
    for (const std::size_t index : indices) {
        changes[index] = true;
        left.push_back(m_keys[index].time);
    }
    std::vector<KeyType> stay, come(keys.begin(), keys.end()), all;
    stay.reserve(m_keys.size());
    for (std::size_t i = 0; i < m_keys.size(); ++i)
        if (!changes[i])
            stay.push_back(std::move(m_keys[i]));
    const auto earlier = [](const KeyType& a, const KeyType& b) { return a.time < b.time; };
    std::stable_sort(come.begin(), come.end(), earlier);
    all.reserve(m_keys.size());
    // Of equal times those that stay come first: the others take their place.
    std::merge(stay.begin(), stay.end(), come.begin(), come.end(), std::back_inserter(all), earlier);
    m_keys = std::move(all);
    // A few that have gone elsewhere among very many: only what is around their old and new places.
    constexpr std::size_t few = 16;
    const auto sameTime = [](const KeyType& a, const KeyType& b) { return a.time == b.time; };
    if (left.size() > few || goesRound() || !std::is_same_v<KeyType, Key> ||
        std::adjacent_find(m_keys.begin(), m_keys.end(), sameTime) != m_keys.end()) {
        settle();
        return {};
    }
    m_times.resize(m_keys.size());
    std::transform(m_keys.begin(), m_keys.end(), m_times.begin(),
                   [](const KeyType& key) { return key.time; });
    for (const KeyType& key : come)
        left.push_back(key.time);
    for (const Ticks time : left) {
        const std::size_t at = std::min(lowerBound(time), m_keys.size() - 1);
        settleAround(at > 0 ? at - 1 : 0, at);
    }
    return {};
}

/// Where all keys keep their order; of a curve with very many only those around need to be settled.
template <class KeyType>
bool KeyTrack<KeyType>::replaceInPlace(std::span<const std::size_t> indices, std::span<const KeyType> keys)
{
    if (indices.empty() || !std::is_sorted(indices.begin(), indices.end(), std::less_equal<>()))
        return indices.empty();
    const auto timeOf = [&](std::size_t index, std::size_t from) { // `from` is the place in the list
        return from < indices.size() && indices[from] == index ? keys[from].time : m_keys[index].time;
    };
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::size_t at = indices[i];
        if ((i == 0 && at > 0 && m_keys[at - 1].time >= keys[i].time) ||
            (i > 0 && timeOf(at - 1, indices[i - 1] == at - 1 ? i - 1 : indices.size()) >= keys[i].time) ||
            (at + 1 < m_keys.size() && timeOf(at + 1, i + 1) <= keys[i].time))
            return false;
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
        m_keys[indices[i]] = keys[i];
        m_times[indices[i]] = keys[i].time;
    }
    settleAround(indices.front(), indices.back());
    return true;
}

template <class KeyType> void KeyTrack<KeyType>::settleAround(std::size_t first, std::size_t last)
{
    if constexpr (std::is_same_v<KeyType, Key>) {
        if (!goesRound())
            return settleHandlesAround(m_keys, first, last);
    }
    settleKeys(m_keys, goesRound()); // signs of orientations hang on those before them
}

template <class KeyType> void KeyTrack<KeyType>::settleEnds()
{
    settleKeys(m_keys, goesRound());
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
