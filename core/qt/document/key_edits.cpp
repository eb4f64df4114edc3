#include "core/qt/document/key_edits_private.h"

namespace ramure {

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
    return withoutTimes(
        changeKeys(document, selection, text, 0, [&](const TrackRef&, const auto& held, const auto& indices) {
            auto changed = keysAt(held, indices);
            for (auto& key : changed)
                change(key);
            return changed;
        }));
}

Expected<void> keys::changeValues(Document& document, const KeySelection& selection,
                                  const std::function<double(const TrackRef&, double)>& change,
                                  const QString& text, GestureId gesture)
{
    return withoutTimes(changeKeys(document, selection, text, gesture,
                                   [&](const TrackRef& ref, const auto& held, const auto& indices) {
                                       auto changed = keysAt(held, indices);
                                       if constexpr (std::is_same_v<std::decay_t<decltype(held)>, Track>)
                                           for (Key& key : changed)
                                               key.value = change(ref, key.value);
                                       else
                                           changed.clear();
                                       return changed;
                                   }));
}

Expected<void> keys::changeOrientations(Document& document, const KeySelection& selection,
                                        const std::function<glm::dquat(const glm::dquat&)>& change,
                                        const QString& text, GestureId gesture)
{
    return withoutTimes(changeKeys(
        document, selection, text, gesture, [&](const TrackRef&, const auto& held, const auto& indices) {
            auto changed = keysAt(held, indices);
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, OrientationTrack>)
                for (OrientationKey& key : changed)
                    key.value = change(key.value);
            else
                changed.clear();
            return changed;
        }));
}

Expected<void> keys::replace(Document& document, const TrackRef& ref, const Key& key, const QString& text,
                             GestureId gesture)
{
    return withoutTimes(changeKeys(document, {{ref, {key.time}}}, text, gesture,
                                   [&](const TrackRef&, const auto& held, const auto&) {
                                       using KeyType = typename std::decay_t<decltype(held)>::KeyKind;
                                       std::vector<KeyType> changed;
                                       if constexpr (std::is_same_v<KeyType, Key>)
                                           changed.push_back(key);
                                       return changed;
                                   }));
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
                         held.settleEnds();
                         edits.push_back(editOf(ref, std::move(held)));
                         return {};
                     });
}

} // namespace ramure
