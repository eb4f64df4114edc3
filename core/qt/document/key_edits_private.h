/// \file
/// What the edits of keys have in common. Internal.
#pragma once

#include "core/qt/document/key_edits.h"
#include <QCoreApplication>
#include <algorithm>

namespace ramure::keys {

inline QString stepText(const char* english)
{
    return QCoreApplication::translate("keys", english);
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

template <class TrackType>
Expected<TrackType> withAdded(const TrackType& track, const std::vector<typename TrackType::KeyKind>& added)
{
    auto all = track.keys().toVector();
    all.insert(all.end(), added.begin(), added.end());
    auto made = TrackType::fromKeys(std::move(all));
    if (!made)
        return made;
    made->before = track.before;
    made->behind = track.behind;
    made->loop = track.loop;
    made->blend = track.blend;
    made->settleEnds();
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

inline TrackEdit editOf(const TrackRef& ref, AnyTrack track)
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
        const auto track = find(document.scene(), ref);
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

/// Puts changed keys in the place of the selected ones. \param change (ref, track, indices) -> the keys, one
/// for each index, or none for a track that stays as it is. \returns the keys at their new times
template <class Change>
Expected<KeySelection> changeKeys(Document& document, const KeySelection& selection, const QString& text,
                                  GestureId gesture, Change&& change)
{
    KeySelection moved;
    auto done = eachTrack(
        document, selection, text, gesture,
        [&](const TrackRef& ref, const auto& held, const auto& indices, auto& edits) -> Expected<void> {
            using TrackType = std::decay_t<decltype(held)>;
            const std::vector<typename TrackType::KeyKind> changed = change(ref, held, indices);
            if (changed.empty())
                return {};
            TrackType track = held;
            using KeyType = typename TrackType::KeyKind;
            if (auto good = track.replace(indices, std::span<const KeyType>(changed)); !good)
                return good;
            moved[ref] = timesOf(changed);
            edits.push_back(editOf(ref, std::move(track)));
            return {};
        });
    RAMURE_TRY(done);
    return moved;
}

/// The selected keys themselves.
template <class TrackType>
std::vector<typename TrackType::KeyKind> keysAt(const TrackType& track,
                                                const std::vector<std::size_t>& indices)
{
    std::vector<typename TrackType::KeyKind> taken;
    taken.reserve(indices.size());
    for (const std::size_t index : indices)
        taken.push_back(track.keys()[index]);
    return taken;
}

/// An edit that moves no key has no selection to tell of.
inline Expected<void> withoutTimes(Expected<KeySelection> moved)
{
    RAMURE_TRY(moved);
    return {};
}

} // namespace ramure::keys
