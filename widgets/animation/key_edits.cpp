#include "widgets/animation/key_edits.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

QString stepText(const char* english)
{
    return QCoreApplication::translate("keys", english);
}

void scaleHandle(Handle& handle, double factor)
{
    handle.dt *= factor;
}

void scaleHandles(Key& key, double factor)
{
    scaleHandle(key.in, factor);
    scaleHandle(key.out, factor);
}

void scaleHandles(OrientationKey& key, double factor)
{
    for (std::size_t i = 0; i < key.in.size(); ++i) {
        scaleHandle(key.in[i], factor);
        scaleHandle(key.out[i], factor);
    }
}

Easing reversed(Easing easing, KeyMode mode)
{
    const bool endsIn = mode == KeyMode::Back || mode == KeyMode::Bounce || mode == KeyMode::Elastic;
    switch (easing) {
    case Easing::In:
        return Easing::Out;
    case Easing::Out:
        return Easing::In;
    case Easing::Auto:
        return endsIn ? Easing::In : Easing::Out;
    case Easing::InOut:
        break;
    }
    return easing;
}

/// Which keys of a track are meant.
template <class TrackType>
std::vector<std::size_t> indicesOf(const TrackType& track, const std::vector<Ticks>& times)
{
    std::vector<std::size_t> indices;
    indices.reserve(times.size());
    for (const Ticks time : times)
        if (const auto index = track.find(time))
            indices.push_back(*index);
    return indices;
}

/// The way from each key to the next belongs to the later one when time runs backwards.
template <class KeyType>
void takeWayBefore(KeyType& key, const std::vector<KeyType>& all, std::size_t index, bool beforeIsSelected)
{
    std::swap(key.in, key.out);
    std::swap(key.before, key.behind);
    if (!beforeIsSelected)
        return;
    const KeyShape& way = all[index - 1];
    key.mode = way.mode;
    key.easing = reversed(way.easing, way.mode);
    key.back = way.back;
    key.amplitude = way.amplitude;
    key.period = way.period;
}

template <class KeyType>
std::vector<KeyType> retimed(const std::vector<KeyType>& all, const std::vector<std::size_t>& indices,
                             const Retiming& retiming)
{
    std::vector<KeyType> changed;
    changed.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        KeyType key = all[indices[i]];
        key.time = retiming.of(key.time);
        if (retiming.factor != 1.0)
            scaleHandles(key, retiming.factor);
        if (retiming.factor < 0.0)
            takeWayBefore(key, all, indices[i], i > 0 && indices[i - 1] + 1 == indices[i]);
        changed.push_back(key);
    }
    return changed;
}

template <class TrackType>
Expected<TrackType> withAdded(const TrackType& track, const std::vector<typename TrackType::KeyKind>& added)
{
    auto all = track.keys();
    all.insert(all.end(), added.begin(), added.end());
    auto made = TrackType::fromKeys(std::move(all));
    if (!made)
        return made;
    made->before = track.before;
    made->behind = track.behind;
    made->loop = track.loop;
    made->blend = track.blend;
    return made;
}

template <class KeyType> std::vector<Ticks> timesOf(const std::vector<KeyType>& keys)
{
    std::vector<Ticks> times;
    times.reserve(keys.size());
    for (const KeyType& key : keys)
        times.push_back(key.time);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

TrackEdit editOf(const TrackRef& ref, AnyTrack track)
{
    return {ref.node, ref.channel, std::make_shared<const AnyTrack>(std::move(track))};
}

/// Makes of each track with selected keys another one. \p make: (ref, track, indices, edits) ->
/// Expected<void>.
template <class Make>
Expected<void> eachTrack(Document& document, const KeySelection& selection, const QString& text,
                         GestureId gesture, Make&& make)
{
    std::vector<TrackEdit> edits;
    for (const auto& entry : selection) { // no binding: lambdas below use both
        const auto& ref = entry.first;
        const auto& times = entry.second;
        const auto track = keys::find(document.scene(), ref);
        if (!track)
            continue;
        auto done = std::visit(
            [&](const auto& held) -> Expected<void> {
                const auto indices = indicesOf(held, times);
                return indices.empty() ? Expected<void>() : make(ref, held, indices, edits);
            },
            *track);
        if (!done)
            return done;
    }
    return edit::setTracks(document, edits, text, gesture);
}

} // namespace

Ticks Retiming::of(Ticks time) const
{
    if (factor == 1.0)
        return time + offset;
    // Beyond the range of times tracks refuse them; this keeps the number within a tick.
    const double most = 2.0 * double(mostTicks);
    return pivot + std::llround(std::clamp(double(time - pivot) * factor, -most, most)) + offset;
}

NodeAnimation::TrackPtr keys::find(const Scene& scene, const TrackRef& ref)
{
    const Node* node = scene.find(ref.node);
    return node ? node->animation.find(ref.channel) : nullptr;
}

KeySelection keys::existing(const Scene& scene, const KeySelection& selection)
{
    KeySelection there;
    for (const auto& entry : selection) { // no binding: lambdas below use both
        const auto& ref = entry.first;
        const auto& times = entry.second;
        const auto track = find(scene, ref);
        if (!track)
            continue;
        std::vector<Ticks> kept;
        std::visit(
            [&](const auto& held) {
                for (const Ticks time : times)
                    if (held.find(time))
                        kept.push_back(time);
            },
            *track);
        if (!kept.empty())
            there.emplace(ref, std::move(kept));
    }
    return there;
}

std::size_t keys::count(const KeySelection& selection)
{
    std::size_t all = 0;
    for (const auto& [ref, times] : selection)
        all += times.size();
    return all;
}

std::optional<std::pair<Ticks, Ticks>> keys::spanOf(const KeySelection& selection)
{
    std::optional<std::pair<Ticks, Ticks>> span;
    for (const auto& [ref, times] : selection) {
        if (times.empty())
            continue;
        if (!span)
            span = {times.front(), times.back()};
        span = {std::min(span->first, times.front()), std::max(span->second, times.back())};
    }
    return span;
}

Ticks keys::ticksOfFrame(const TimelineSettings& settings, double frame)
{
    return ticksOf(std::clamp(frame / settings.framesPerSecond, -1e6, 1e6));
}

Ticks keys::snapped(Ticks time, double stepsPerSecond)
{
    return ticksOf(std::round(secondsOf(time) * stepsPerSecond) / stepsPerSecond);
}

std::optional<Ticks> keys::nextTime(const Scene& scene, const std::vector<TrackRef>& tracks, Ticks time,
                                    bool forward)
{
    std::optional<Ticks> next;
    for (const TrackRef& ref : tracks) {
        const auto track = find(scene, ref);
        if (!track)
            continue;
        std::visit(
            [&](const auto& held) {
                const std::size_t at = held.lowerBound(forward ? time + 1 : time);
                if (forward ? at == held.size() : at == 0)
                    return;
                const Ticks found = held.keys()[forward ? at : at - 1].time;
                if (!next || (forward ? found < *next : found > *next))
                    next = found;
            },
            *track);
    }
    return next;
}

Expected<KeySelection> keys::retime(Document& document, const KeySelection& selection,
                                    const Retiming& retiming, const QString& text)
{
    KeySelection moved;
    auto done = eachTrack(document, selection, text, 0,
                          [&](const TrackRef& ref, auto held, const auto& indices, auto& edits) {
                              const auto changed = retimed(held.keys(), indices, retiming);
                              using KeyType = typename decltype(held)::KeyKind;
                              auto good = held.replace(indices, std::span<const KeyType>(changed));
                              if (good) {
                                  moved[ref] = timesOf(changed);
                                  edits.push_back(editOf(ref, std::move(held)));
                              }
                              return good;
                          });
    if (!done)
        return fail(std::move(done.error()));
    return moved;
}

Expected<KeySelection> keys::duplicate(Document& document, const KeySelection& selection,
                                       const Retiming& retiming)
{
    KeySelection copies;
    auto done = eachTrack(
        document, selection, stepText(QT_TRANSLATE_NOOP("keys", "Duplicate Keys")), 0,
        [&](const TrackRef& ref, const auto& held, const auto& indices, auto& edits) -> Expected<void> {
            const auto added = retimed(held.keys(), indices, retiming);
            auto made = withAdded(held, added);
            if (!made)
                return fail(std::move(made.error()));
            copies[ref] = timesOf(added);
            edits.push_back(editOf(ref, std::move(*made)));
            return {};
        });
    if (!done)
        return fail(std::move(done.error()));
    return copies;
}

Expected<KeySelection> keys::snap(Document& document, const KeySelection& selection, double stepsPerSecond,
                                  const QString& text)
{
    KeySelection moved;
    auto done = eachTrack(document, selection, text, 0,
                          [&](const TrackRef& ref, auto held, const auto& indices, auto& edits) {
                              using KeyType = typename decltype(held)::KeyKind;
                              std::vector<KeyType> changed;
                              for (const std::size_t index : indices) {
                                  changed.push_back(held.keys()[index]);
                                  changed.back().time = snapped(changed.back().time, stepsPerSecond);
                              }
                              auto good = held.replace(indices, std::span<const KeyType>(changed));
                              if (good) {
                                  moved[ref] = timesOf(changed);
                                  edits.push_back(editOf(ref, std::move(held)));
                              }
                              return good;
                          });
    if (!done)
        return fail(std::move(done.error()));
    return moved;
}

Expected<void> keys::insert(Document& document, const std::vector<TrackRef>& tracks, Ticks time)
{
    std::vector<TrackEdit> edits;
    for (const TrackRef& ref : tracks) {
        const auto track = find(document.scene(), ref);
        if (!track)
            continue;
        auto done = std::visit(
            [&](auto held) -> Expected<void> {
                if (held.find(time))
                    return {};
                typename decltype(held)::KeyKind key;
                const std::size_t at = held.lowerBound(time);
                static_cast<KeyShape&>(key) = held.keys()[at == 0 ? 0 : at - 1];
                key.time = time;
                key.value = valueAt(held, secondsOf(time));
                auto good = held.insert(key);
                if (good)
                    edits.push_back(editOf(ref, std::move(held)));
                return good;
            },
            *track);
        if (!done)
            return done;
    }
    return edit::setTracks(document, edits, stepText(QT_TRANSLATE_NOOP("keys", "Insert Keys")));
}

Expected<void> keys::remove(Document& document, const KeySelection& selection)
{
    return eachTrack(document, selection, stepText(QT_TRANSLATE_NOOP("keys", "Delete Keys")), 0,
                     [](const TrackRef& ref, auto held, const auto& indices, auto& edits) -> Expected<void> {
                         held.erase(indices);
                         edits.push_back(editOf(ref, std::move(held)));
                         return {};
                     });
}

Expected<void> keys::reshape(Document& document, const KeySelection& selection,
                             const std::function<void(KeyShape&)>& change, const QString& text)
{
    return eachTrack(document, selection, text, 0,
                     [&](const TrackRef& ref, auto held, const auto& indices, auto& edits) {
                         using KeyType = typename decltype(held)::KeyKind;
                         std::vector<KeyType> changed;
                         for (const std::size_t index : indices) {
                             changed.push_back(held.keys()[index]);
                             change(changed.back());
                         }
                         auto good = held.replace(indices, std::span<const KeyType>(changed));
                         if (good)
                             edits.push_back(editOf(ref, std::move(held)));
                         return good;
                     });
}

Expected<void> keys::changeValues(Document& document, const KeySelection& selection,
                                  const std::function<double(const TrackRef&, double)>& change,
                                  const QString& text, GestureId gesture)
{
    return eachTrack(document, selection, text, gesture,
                     [&](const TrackRef& ref, auto held, const auto& indices, auto& edits) -> Expected<void> {
                         using KeyType = typename decltype(held)::KeyKind;
                         if constexpr (std::is_same_v<KeyType, Key>) {
                             std::vector<Key> changed;
                             for (const std::size_t index : indices) {
                                 changed.push_back(held.keys()[index]);
                                 changed.back().value = change(ref, changed.back().value);
                             }
                             if (auto good = held.replace(indices, std::span<const Key>(changed)); !good)
                                 return good;
                             edits.push_back(editOf(ref, std::move(held)));
                         }
                         return {};
                     });
}

Expected<void> keys::changeOrientations(Document& document, const KeySelection& selection,
                                        const std::function<glm::dquat(const glm::dquat&)>& change,
                                        const QString& text, GestureId gesture)
{
    return eachTrack(document, selection, text, gesture,
                     [&](const TrackRef& ref, auto held, const auto& indices, auto& edits) -> Expected<void> {
                         using KeyType = typename decltype(held)::KeyKind;
                         if constexpr (std::is_same_v<KeyType, OrientationKey>) {
                             std::vector<OrientationKey> changed;
                             for (const std::size_t index : indices) {
                                 changed.push_back(held.keys()[index]);
                                 changed.back().value = change(changed.back().value);
                             }
                             if (auto good = held.replace(indices, std::span<const OrientationKey>(changed));
                                 !good)
                                 return good;
                             edits.push_back(editOf(ref, std::move(held)));
                         }
                         return {};
                     });
}

Expected<KeySelection> keys::shift(Document& document, const KeySelection& selection, Ticks offset,
                                   const std::map<TrackRef, double>& values, const QString& text)
{
    KeySelection moved;
    auto done = eachTrack(document, selection, text, 0,
                          [&](const TrackRef& ref, auto held, const auto& indices, auto& edits) {
                              using KeyType = typename decltype(held)::KeyKind;
                              auto changed = retimed(held.keys(), indices, {0, 1.0, offset});
                              const auto value = values.find(ref);
                              if constexpr (std::is_same_v<KeyType, Key>)
                                  for (Key& key : changed)
                                      key.value += value == values.end() ? 0.0 : value->second;
                              auto good = held.replace(indices, std::span<const KeyType>(changed));
                              if (good) {
                                  moved[ref] = timesOf(changed);
                                  edits.push_back(editOf(ref, std::move(held)));
                              }
                              return good;
                          });
    if (!done)
        return fail(std::move(done.error()));
    return moved;
}

Expected<void> keys::replace(Document& document, const TrackRef& ref, const Key& key, const QString& text,
                             GestureId gesture)
{
    return eachTrack(
        document, {{ref, {key.time}}}, text, gesture,
        [&](const TrackRef& place, auto held, const auto& indices, auto& edits) -> Expected<void> {
            if constexpr (std::is_same_v<typename decltype(held)::KeyKind, Key>) {
                if (auto good = held.replace(indices, std::span<const Key>(&key, 1)); !good)
                    return good;
                edits.push_back(editOf(place, std::move(held)));
            }
            return {};
        });
}

Expected<void> keys::extrapolate(Document& document, const KeySelection& selection, bool before, bool behind,
                                 Extrapolation extrapolation)
{
    return eachTrack(document, selection, stepText(QT_TRANSLATE_NOOP("keys", "Change Extrapolation")), 0,
                     [&](const TrackRef& ref, auto held, const auto&, auto& edits) -> Expected<void> {
                         if (before)
                             held.before = extrapolation;
                         if (behind)
                             held.behind = extrapolation;
                         edits.push_back(editOf(ref, std::move(held)));
                         return {};
                     });
}

KeyClip keys::copied(const Scene& scene, const KeySelection& selection)
{
    KeyClip clip;
    for (const auto& entry : selection) { // no binding: lambdas below use both
        const auto& ref = entry.first;
        const auto& times = entry.second;
        const auto track = find(scene, ref);
        if (!track)
            continue;
        std::visit(
            [&](const auto& held) {
                using TrackType = std::decay_t<decltype(held)>;
                std::vector<typename TrackType::KeyKind> taken;
                for (const std::size_t index : indicesOf(held, times))
                    taken.push_back(held.keys()[index]);
                if (auto made = TrackType::fromKeys(std::move(taken)); made && !made->empty())
                    clip.tracks.emplace_back(ref, std::move(*made));
            },
            *track);
    }
    for (std::size_t i = 0; i < clip.tracks.size(); ++i) {
        const Ticks first = keyShape(clip.tracks[i].second, 0).time;
        clip.first = i == 0 ? first : std::min(clip.first, first);
    }
    return clip;
}

namespace {

/// Pastes one track of the clip into one channel.
template <class TrackType>
Expected<void> pasteInto(const Scene& scene, const TrackRef& ref, const TrackType& clip, Ticks offset,
                         std::vector<TrackEdit>& edits, KeySelection& pasted)
{
    const auto present = keys::find(scene, ref);
    auto added = clip.keys();
    for (auto& key : added)
        key.time += offset;
    auto made = withAdded(present ? std::get<TrackType>(*present) : TrackType(), added);
    if (!made)
        return fail(std::move(made.error()));
    pasted[ref] = timesOf(added);
    edits.push_back(editOf(ref, std::move(*made)));
    return {};
}

std::vector<NodeId> targetsOf(const KeyClip& clip, const TrackRef& ref, const std::vector<NodeId>& targets)
{
    const NodeId first = clip.tracks.front().first.node;
    const bool oneNode = std::all_of(clip.tracks.begin(), clip.tracks.end(),
                                     [first](const auto& entry) { return entry.first.node == first; });
    return oneNode && !targets.empty() ? targets : std::vector<NodeId>{ref.node};
}

} // namespace

Expected<KeySelection> keys::paste(Document& document, const KeyClip& clip,
                                   const std::vector<NodeId>& targets, Ticks offset)
{
    KeySelection pasted;
    std::vector<TrackEdit> edits;
    for (const auto& [from, track] : clip.tracks)
        for (const NodeId id : targetsOf(clip, from, targets)) {
            const Node* node = document.scene().find(id);
            if (!node || !hasChannel(node->kind, from.channel))
                continue;
            const TrackRef ref{id, from.channel};
            auto done = std::visit(
                [&](const auto& held) {
                    return pasteInto(document.scene(), ref, held, offset, edits, pasted);
                },
                track);
            if (!done)
                return fail(std::move(done.error()));
        }
    if (edits.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("no selected node has tracks for these keys"));
    if (auto done = edit::setTracks(document, edits, stepText(QT_TRANSLATE_NOOP("keys", "Paste Keys")));
        !done)
        return fail(std::move(done.error()));
    return pasted;
}

} // namespace ramure
