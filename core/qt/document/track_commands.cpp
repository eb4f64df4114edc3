// Tracks of nodes.
#include "core/qt/document/document_command.h"
#include "core/scene/keyed_placement.h"
#include <algorithm>

namespace ramure {

namespace {

/// Compared by what it holds: a drag that ends where it began leaves no step.
struct HeldTrack
{
    NodeAnimation::TrackPtr track;
    bool operator==(const HeldTrack& other) const
    {
        const bool none = !track || isEmpty(*track), otherNone = !other.track || isEmpty(*other.track);
        return none || otherNone ? none == otherNone : track == other.track || *track == *other.track;
    }
};

struct TrackTarget
{
    using Value = HeldTrack;

    NodeId node;
    Channel channel;

    [[nodiscard]] Value get(const Node& from) const { return {from.animation.find(channel)}; }
    void set(Node& into, Value value) const { into.animation.set(channel, std::move(value.track)); }
    void describe(Change& change) const
    {
        change.kinds |= changeTracks;
        change.firstStale = Stage::Placement;
        if (change.nodes.empty() || change.nodes.back() != node)
            addOnce(change.nodes, node);
        if (channel.part == ChannelPart::Parameter)
            addOnce(change.params, channel.param);
    }
    static void count(MemoryCount& memory, const Value& value) { memory.add(value.track); }
    bool operator==(const TrackTarget&) const = default;
};
using TrackEntry = SetCommand<TrackTarget>::Entry;

bool fits(const Channel& channel, const AnyTrack& track)
{
    return channel.isOrientation() == std::holds_alternative<OrientationTrack>(track);
}

Expected<void> checkEdit(const Scene& scene, const TrackEdit& edit)
{
    const Node& node = *scene.find(edit.node);
    auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no such track"), {node.name});
    error.value().path = channelKey(edit.channel);
    if (!hasChannel(node.kind, edit.channel))
        return error;
    if (edit.track && !fits(edit.channel, *edit.track))
        return error;
    return {};
}

/// A new key goes on as the one before it does.
template <class KeyType> void takeShape(KeyType& key, const KeyList<KeyType>& keys, KeyMode mode)
{
    key.mode = mode;
    if (keys.empty())
        return;
    const Ticks time = key.time;
    const std::size_t behind = keys.lowerBound(time + 1);
    static_cast<KeyShape&>(key) = keys[behind == 0 ? 0 : behind - 1];
    key.time = time;
}

template <class TrackType, class Value>
Expected<AnyTrack> withKey(TrackType track, Ticks time, KeyMode mode, const Value& value)
{
    typename TrackType::KeyKind key;
    key.time = time;
    key.value = value;
    takeShape(key, track.keys(), mode);
    RAMURE_TRY(track.insert(key));
    return AnyTrack(std::move(track));
}

/// Null where there is a key at this time.
Expected<NodeAnimation::TrackPtr> keyed(const Node& node, const Channel& channel, Ticks time, KeyMode mode)
{
    const NodeAnimation::TrackPtr present = node.animation.find(channel);
    Expected<AnyTrack> made;
    if (channel.isOrientation()) {
        const OrientationTrack track = present ? std::get<OrientationTrack>(*present) : OrientationTrack();
        if (track.find(time))
            return nullptr;
        made = withKey(track, time, mode,
                       track.empty() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : valueAt(track, secondsOf(time)));
    } else {
        const Track track = present ? std::get<Track>(*present) : Track();
        if (track.find(time))
            return nullptr;
        made = withKey(track, time, mode,
                       track.empty() ? restValue(node.params, channel) : valueAt(track, secondsOf(time)));
    }
    RAMURE_TRY(made);
    return std::make_shared<const AnyTrack>(std::move(*made));
}

PlacementPart placementPart(const Channel& channel)
{
    return channel.isOrientation() ? PlacementPart::Rotation
           : channel.isScale()     ? PlacementPart::Scale
                                   : PlacementPart::Translation;
}

/// The parts of the global transform that the channels are; none where they are anything else, or less.
std::vector<PlacementPart> wholeParts(const std::vector<Channel>& channels)
{
    std::vector<PlacementPart> parts;
    std::size_t expected = 0;
    for (const Channel& channel : channels) {
        if (channel.part > ChannelPart::GlobalScale)
            return {};
        if (std::find(parts.begin(), parts.end(), placementPart(channel)) != parts.end())
            continue;
        parts.push_back(placementPart(channel));
        expected += channel.isOrientation() ? 1 : 3;
    }
    return channels.size() == expected ? parts : std::vector<PlacementPart>();
}

/// Keys of the global transforms, in whole parts.
Expected<void> insertPlacementKeys(Document& document, const std::vector<NodeId>& ids,
                                   const std::vector<PlacementPart>& parts, Ticks time, KeyMode mode)
{
    std::vector<NodePlacing> places;
    for (const NodeId id : ids) {
        const Node& node = *document.scene().find(id);
        NodePlacing place{id, {node.params.tree, globalTracks(node.animation)}, true, true};
        for (const PlacementPart part : parts) {
            auto made = withPlacementKeys(place.values, time, part, mode);
            RAMURE_TRY(made);
            place.values = std::move(*made);
        }
        places.push_back(std::move(place));
    }
    return edit::placeNodes(document, places, DocumentCommand::tr("Insert Keys"));
}

} // namespace

Expected<void> edit::setTracks(Document& document, const std::vector<TrackEdit>& edits, const QString& text,
                               GestureId gesture)
{
    std::map<std::pair<NodeId, Channel>, NodeAnimation::TrackPtr> wanted;
    for (const TrackEdit& edit : edits) {
        if (auto allowed = checkEditable(document.scene(), edit.node); !allowed)
            return allowed;
        if (auto allowed = checkEdit(document.scene(), edit); !allowed)
            return allowed;
        wanted[{edit.node, edit.channel}] = edit.track;
    }
    std::vector<TrackEntry> entries;
    entries.reserve(wanted.size());
    for (auto& [place, track] : wanted)
        entries.push_back({{place.first, place.second}, {std::move(track)}});
    pushSet<TrackTarget>(document, std::move(entries), text, gesture);
    return {};
}

Expected<void> edit::insertKeys(Document& document, const std::vector<NodeId>& nodes,
                                const std::vector<Channel>& channels, Ticks time, KeyMode mode)
{
    const auto ids = editable(document.scene(), nodes);
    RAMURE_TRY(ids);
    if (const auto parts = wholeParts(channels); !parts.empty())
        return insertPlacementKeys(document, *ids, parts, time, mode);
    std::vector<TrackEdit> edits;
    for (const NodeId id : *ids) {
        const Node& node = *document.scene().find(id);
        for (const Channel& channel : channels) {
            if (!hasChannel(node.kind, channel))
                continue;
            auto track = keyed(node, channel, time, mode);
            RAMURE_TRY(track);
            if (*track)
                edits.push_back({id, channel, std::move(*track)});
        }
    }
    return setTracks(document, edits, DocumentCommand::tr("Insert Keys"));
}

} // namespace ramure
