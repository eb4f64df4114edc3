// Placements and global tracks of nodes, as one step.
#include "core/qt/document/document_command.h"

namespace ramure {

namespace {

/// Tracks compared by what they hold: a drag that ends where it began leaves no step.
struct PlacedValue
{
    NodeTransform values;
    bool operator==(const PlacedValue& other) const
    {
        const auto same = [](const NodeAnimation::TrackPtr& a, const NodeAnimation::TrackPtr& b) {
            return a == b || (a && b && *a == *b);
        };
        return values.placement == other.values.placement &&
               std::equal(values.tracks.begin(), values.tracks.end(), other.values.tracks.begin(), same);
    }
};

struct PlaceTarget
{
    using Value = PlacedValue;

    NodeId node;
    bool keys;   ///< the tracks change
    bool places; ///< the placement changes

    [[nodiscard]] Value get(const Node& from) const
    {
        return {{from.params.tree, globalTracks(from.animation)}};
    }
    void set(Node& into, Value value) const
    {
        into.params.tree = value.values.placement;
        for (std::size_t i = 0; i < value.values.tracks.size(); ++i)
            into.animation.set(globalChannel(i), std::move(value.values.tracks[i]));
    }
    void describe(Change& change) const
    {
        change.firstStale = Stage::Placement;
        change.nodes.push_back(node);
        if (keys)
            change.kinds |= changeTracks;
        if (!places)
            return;
        change.kinds |= changeParams;
        for (const char* key : {"tree.translation", "tree.rotation", "tree.scale"})
            addOnce(change.params, paramId(*findParam(key)));
    }
    static void count(MemoryCount& memory, const Value& value)
    {
        for (const NodeAnimation::TrackPtr& track : value.values.tracks)
            memory.add(track);
    }
    bool operator==(const PlaceTarget&) const = default;
};

Expected<void> checkPlacing(const Scene& scene, const NodePlacing& place)
{
    if (auto allowed = checkEditable(scene, place.node); !allowed)
        return allowed;
    NodeParams params;
    params.tree = place.values.placement;
    for (const char* key : {"tree.translation", "tree.rotation", "tree.scale"})
        if (auto good = checkValue(*findParam(key), findParam(key)->get(params)); !good)
            return good;
    for (std::size_t i = 0; i < place.values.tracks.size(); ++i) {
        const auto& track = place.values.tracks[i];
        if (track && globalChannel(i).isOrientation() != std::holds_alternative<OrientationTrack>(*track))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no such track"),
                        {scene.find(place.node)->name});
    }
    return {};
}

} // namespace

Expected<void> edit::placeNodes(Document& document, const std::vector<NodePlacing>& places,
                                const QString& text, GestureId gesture)
{
    std::map<NodeId, const NodePlacing*> wanted; // of a node named twice the last counts
    for (const NodePlacing& place : places) {
        if (auto allowed = checkPlacing(document.scene(), place); !allowed)
            return allowed;
        wanted[place.node] = &place;
    }
    std::vector<SetCommand<PlaceTarget>::Entry> entries;
    entries.reserve(wanted.size());
    for (const auto& [node, place] : wanted)
        entries.push_back({{node, place->keys, !place->keys || place->placed}, {place->values}});
    pushSet<PlaceTarget>(document, std::move(entries), text, gesture);
    return {};
}

} // namespace ramure
