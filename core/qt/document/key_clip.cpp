// Keys in the clipboard.
#include "core/qt/document/key_edits_private.h"

namespace ramure {

KeyClip keys::copied(const Scene& scene, const KeySelection& selection)
{
    KeyClip clip;
    for (const auto& entry : selection) { // no binding: lambdas below use both
        const auto& ref = entry.first;
        const auto& times = entry.second;
        const auto track = keys::find(scene, ref);
        if (!track)
            continue;
        std::visit(
            [&](const auto& held) {
                using TrackType = std::decay_t<decltype(held)>;
                auto made = TrackType::fromKeys(keys::keysAt(held, keys::indicesOf(held, times)));
                if (made && !made->empty())
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
    auto added = clip.keys().toVector();
    for (auto& key : added)
        key.time += offset;
    auto made = keys::withAdded(present ? std::get<TrackType>(*present) : TrackType(), added);
    RAMURE_TRY(made);
    pasted[ref] = keys::timesOf(added);
    edits.push_back(keys::editOf(ref, std::move(*made)));
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
            RAMURE_TRY(done);
        }
    if (edits.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("no selected node has tracks for these keys"));
    RAMURE_TRY(edit::setTracks(document, edits, keys::stepText(QT_TRANSLATE_NOOP("keys", "Paste Keys"))));
    return pasted;
}

} // namespace ramure
