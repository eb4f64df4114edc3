#include "core/qt/document/project/project_tracks.h"

#include "core/qt/document/project/project_json.h"

#include <QJsonArray>
#include <cmath>

namespace ramure::json {
namespace {

constexpr QLatin1String keysKey("keys");

template <class T> void putNumber(QJsonObject& object, const char* key, T value, T usual)
{
    if (value != usual)
        object.insert(QLatin1String(key), value);
}

template <class T>
void putName(QJsonObject& object, const char* key, T value, T usual, const char* (*name)(T))
{
    if (value != usual)
        object.insert(QLatin1String(key), QLatin1String(name(value)));
}

bool isByHand(HandleType type)
{
    return type == HandleType::Free || type == HandleType::Aligned;
}

QJsonArray fromHandle(const Handle& handle)
{
    return {handle.dt, handle.dv};
}

QJsonArray fromHandle(const std::array<Handle, 4>& handles)
{
    QJsonArray array;
    for (const Handle& handle : handles)
        array.append(fromHandle(handle));
    return array;
}

QJsonValue fromValue(double value)
{
    return value + 0.0; // -0 is written as 0
}

QJsonValue fromValue(const glm::dquat& q)
{
    return QJsonArray{q.w + 0.0, q.x + 0.0, q.y + 0.0, q.z + 0.0};
}

template <class KeyType> QJsonObject writeKey(const KeyType& key)
{
    const KeyShape usual;
    QJsonObject object{{QLatin1String("time"), secondsOf(key.time)},
                       {QLatin1String("value"), fromValue(key.value)}};
    putName(object, "mode", key.mode, usual.mode, keyModeName);
    putName(object, "easing", key.easing, usual.easing, easingName);
    putName(object, "before", key.before, usual.before, handleTypeName);
    putName(object, "behind", key.behind, usual.behind, handleTypeName);
    putNumber(object, "back", key.back, usual.back);
    putNumber(object, "amplitude", key.amplitude, usual.amplitude);
    putNumber(object, "period", key.period, usual.period);
    if (isByHand(key.before))
        object.insert(QLatin1String("in"), fromHandle(key.in));
    if (isByHand(key.behind))
        object.insert(QLatin1String("out"), fromHandle(key.out));
    return object;
}

template <class TrackType> QJsonObject writeTrack(const TrackType& track)
{
    QJsonArray keys;
    for (const auto& key : track.keys())
        keys.append(writeKey(key));
    QJsonObject object{{keysKey, keys}};
    putName(object, "before", track.before, Extrapolation::Hold, extrapolationName);
    putName(object, "behind", track.behind, Extrapolation::Hold, extrapolationName);
    if (track.loop > 0)
        object.insert(QLatin1String("loop"), secondsOf(track.loop));
    putName(object, "blend", track.blend, OrientationBlend::Spherical, orientationBlendName);
    return object;
}

/// Takes known keys out of one object.
class Taker
{
public:
    explicit Taker(QJsonObject object)
        : m_rest(std::move(object))
    {
    }
    Expected<void> number(const char* key, double& into, bool needed = false)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (value.isUndefined() && !needed)
            return {};
        if (!value.isDouble())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
        into = value.toDouble();
        return {};
    }
    Expected<void> seconds(const char* key, Ticks& into, bool needed)
    {
        double seconds = secondsOf(into);
        if (auto read = number(key, seconds, needed); !read)
            return read;
        if (!(std::abs(seconds) <= 1e6))
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("the time lies beyond a million seconds"));
        into = ticksOf(seconds);
        return {};
    }
    template <class T> Expected<void> name(const char* key, T& into, int count, const char* (*nameOf)(T))
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (value.isUndefined())
            return {};
        std::string names;
        for (int i = 0; i < count; ++i) {
            const auto item = static_cast<T>(i);
            if (value == QJsonValue(QLatin1String(nameOf(item)))) {
                into = item;
                return {};
            }
            names.append(i == 0 ? "" : ", ").append(nameOf(item));
        }
        return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("one of %1 is expected here"), {names});
    }
    Expected<void> numbers(const char* key, double* into, int count)
    {
        return list(m_rest.take(QLatin1String(key)), key, into, count);
    }
    Expected<void> handle(const char* key, Handle& into)
    {
        return pair(m_rest.take(QLatin1String(key)), key, into);
    }
    Expected<void> handle(const char* key, std::array<Handle, 4>& into)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (value.isUndefined())
            return {};
        const QJsonArray array = value.toArray();
        if (array.size() != 4)
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("four pairs of numbers are expected here"));
        for (qsizetype i = 0; i < 4; ++i)
            if (auto read = pair(array[i], key, into[static_cast<std::size_t>(i)]); !read)
                return read;
        return {};
    }
    QJsonValue take(QLatin1String key) { return m_rest.take(key); }
    [[nodiscard]] const QJsonObject& rest() const { return m_rest; }

private:
    static Expected<void> list(const QJsonValue& value, const char* key, double* into, int count)
    {
        const QJsonArray array = value.toArray();
        bool good = array.size() == count;
        for (int i = 0; good && i < count; ++i) {
            good = array[i].isDouble();
            into[i] = array[i].toDouble();
        }
        if (!good)
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("an array of %1 numbers is expected here"),
                          {std::to_string(count)});
        return {};
    }
    static Expected<void> pair(const QJsonValue& value, const char* key, Handle& into)
    {
        if (value.isUndefined())
            return {};
        double numbers[2]{};
        auto read = list(value, key, numbers, 2);
        into = {numbers[0], numbers[1]};
        return read;
    }

    QJsonObject m_rest;
};

Expected<void> readValue(Taker& taker, double& value)
{
    return taker.number("value", value, true);
}

Expected<void> readValue(Taker& taker, glm::dquat& value)
{
    double numbers[4]{};
    auto read = taker.numbers("value", numbers, 4);
    value = {numbers[0], numbers[1], numbers[2], numbers[3]};
    return read;
}

template <class KeyType> Expected<KeyType> readKey(const QJsonValue& json)
{
    if (!json.isObject())
        return failAt({}, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    Taker taker(json.toObject());
    KeyType key;
    // One after the other: the first error counts.
    auto done = taker.seconds("time", key.time, true);
    const auto then = [&done](auto&& step) {
        if (done)
            done = step();
    };
    then([&] { return readValue(taker, key.value); });
    then([&] { return taker.name("mode", key.mode, keyModeCount, keyModeName); });
    then([&] { return taker.name("easing", key.easing, easingCount, easingName); });
    then([&] { return taker.name("before", key.before, handleTypeCount, handleTypeName); });
    then([&] { return taker.name("behind", key.behind, handleTypeCount, handleTypeName); });
    then([&] { return taker.number("back", key.back); });
    then([&] { return taker.number("amplitude", key.amplitude); });
    then([&] { return taker.number("period", key.period); });
    then([&] { return taker.handle("in", key.in); });
    then([&] { return taker.handle("out", key.out); });
    RAMURE_TRY(done);
    if (!taker.rest().isEmpty())
        return failAt(taker.rest().begin().key().toStdString(), ErrorCode::Unknown,
                      RAMURE_NOOP("a key has nothing of this name"));
    return key;
}

template <class TrackType> Expected<TrackType> readKeys(const QJsonValue& value)
{
    using KeyType = typename TrackType::KeyKind;
    if (!value.isArray())
        return failAt("keys", ErrorCode::Invalid, RAMURE_NOOP("an array is expected here"));
    const QJsonArray array = value.toArray();
    std::vector<KeyType> keys;
    keys.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i) {
        auto key = readKey<KeyType>(array[i]);
        if (!key)
            return failInside("keys" + indexPlace(i), std::move(key.error()));
        if (!keys.empty() && key->time <= keys.back().time)
            return failAt("keys" + indexPlace(i) + ".time", ErrorCode::Invalid,
                          RAMURE_NOOP("the time must lie behind that of the key before"));
        keys.push_back(std::move(*key));
    }
    auto track = TrackType::fromKeys(std::move(keys));
    if (!track)
        track.error().path = "keys" + track.error().path;
    return track;
}

/// What is left of \p object is not known.
template <class TrackType> Expected<AnyTrack> readTrack(QJsonObject& object)
{
    Taker taker(object);
    auto track = readKeys<TrackType>(taker.take(keysKey));
    RAMURE_TRY(track);
    auto done = taker.name("before", track->before, extrapolationCount, extrapolationName);
    if (done)
        done = taker.name("behind", track->behind, extrapolationCount, extrapolationName);
    if (done)
        done = taker.seconds("loop", track->loop, false);
    if (done && track->loop < 0)
        done = failAt("loop", ErrorCode::Invalid, RAMURE_NOOP("a loop takes time"));
    if (done)
        done = taker.name("blend", track->blend, orientationBlendCount, orientationBlendName);
    RAMURE_TRY(done);
    object = taker.rest();
    track->settleEnds();
    return AnyTrack(std::move(*track));
}

} // namespace

QJsonObject writeTracks(const NodeAnimation& animation)
{
    QJsonObject object;
    for (const auto& [channel, track] : animation.tracks())
        object.insert(QString::fromStdString(channelKey(channel)),
                      std::visit([](const auto& held) { return writeTrack(held); }, *track));
    return object;
}

Expected<NodeAnimation> readTracks(QJsonObject& object, NodeKind kind)
{
    NodeAnimation animation;
    for (const QString& name : object.keys()) {
        const std::string key = name.toStdString();
        const auto channel = channelFromKey(key, kind);
        if (!channel)
            continue;
        const QJsonValue value = object.take(name);
        if (!value.isObject())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        QJsonObject inner = value.toObject();
        auto track = channel->isOrientation() ? readTrack<OrientationTrack>(inner) : readTrack<Track>(inner);
        if (!track)
            return failInside(key, std::move(track.error()));
        animation.set(*channel, std::move(*track));
        if (!inner.isEmpty())
            object.insert(name, inner);
    }
    return animation;
}

} // namespace ramure::json
