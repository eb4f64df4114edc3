#include "core/scene/keyed_placement.h"

#include "core/math/finite.h"
#include "core/rig/tracks/euler.h"
#include "core/rig/tracks/keyed_track.h"
#include <algorithm>

namespace ramure {
namespace {

constexpr std::size_t turnTrack = 3, scaleTracks = 4; ///< of GlobalTracks

bool has(const GlobalTracks& tracks, std::size_t first, std::size_t last)
{
    return std::any_of(tracks.begin() + std::ptrdiff_t(first), tracks.begin() + std::ptrdiff_t(last) + 1,
                       [](const auto& track) { return track != nullptr; });
}

double number(const NodeAnimation::TrackPtr& track, double seconds, double rest)
{
    return track ? valueAt(std::get<Track>(*track), seconds) : rest;
}

/// The global track at a time.
struct Moved
{
    glm::dvec3 translation{0.0}, scale{1.0};
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
};

Moved movedAt(const GlobalTracks& tracks, double seconds)
{
    Moved moved;
    for (int c = 0; c < 3; ++c) {
        moved.translation[c] = number(tracks[std::size_t(c)], seconds, 0.0);
        moved.scale[c] = number(tracks[scaleTracks + std::size_t(c)], seconds, 1.0);
    }
    if (tracks[turnTrack])
        moved.turn = valueAt(std::get<OrientationTrack>(*tracks[turnTrack]), seconds);
    return moved;
}

template <class TrackType, class Value>
Expected<void> putKey(NodeAnimation::TrackPtr& track, Ticks time, const Value& value, KeyMode mode)
{
    auto changed = withKey<TrackType>(track, time, value, mode);
    RAMURE_TRY(changed);
    track = std::move(*changed);
    return {};
}

/// All keys further by this much.
void shiftKeys(NodeAnimation::TrackPtr& track, double by)
{
    std::vector<Key> keys = std::get<Track>(*track).keys().toVector();
    std::vector<std::size_t> all(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        all[i] = i;
        keys[i].value += by;
    }
    Track shifted = std::get<Track>(*track);
    if (shifted.replace(all, keys))
        track = std::make_shared<const AnyTrack>(std::move(shifted));
}

/// The placement becomes keys, from its translation up to the part, as far as that moves nothing.
Expected<void> takeOver(NodeTransform& values, Ticks time, PlacementPart part, KeyMode mode)
{
    PlacementParams& own = values.placement;
    GlobalTracks& tracks = values.tracks;
    if (has(tracks, turnTrack, tracks.size() - 1))
        return {}; // something stands between the placement and the track's translation
    if (own.translation != glm::dvec3(0.0)) {
        for (int c = 0; c < 3; ++c) {
            auto& track = tracks[std::size_t(c)];
            if (track)
                shiftKeys(track, own.translation[c]);
            else if (auto good = putKey<Track>(track, time, own.translation[c], mode); !good)
                return good;
        }
        own.translation = glm::dvec3(0.0);
    }
    if (part >= PlacementPart::Rotation && own.rotation != glm::dvec3(0.0)) {
        auto good = putKey<OrientationTrack>(tracks[turnTrack], time, orientationOf(own.rotation), mode);
        if (!good)
            return good;
        own.rotation = glm::dvec3(0.0);
    }
    if (part == PlacementPart::Scale && own.scale != glm::dvec3(1.0)) {
        for (int c = 0; c < 3; ++c)
            if (auto good = putKey<Track>(tracks[scaleTracks + std::size_t(c)], time, own.scale[c], mode);
                !good)
                return good;
        own.scale = glm::dvec3(1.0);
    }
    return {};
}

Expected<void> putThree(NodeTransform& values, std::size_t first, Ticks time, const glm::dvec3& value,
                        std::optional<int> component, KeyMode mode)
{
    for (int c = 0; c < 3; ++c)
        if (!component || *component == c)
            if (auto good = putKey<Track>(values.tracks[first + std::size_t(c)], time, value[c], mode); !good)
                return good;
    return {};
}

/// Where the placement's translation ends up.
glm::dvec3 carried(const Moved& moved, const PlacementParams& own)
{
    return moved.turn * (moved.scale * own.translation);
}

} // namespace

PlacementParams placementAt(const NodeTransform& values, double seconds, bool angles)
{
    const Moved moved = movedAt(values.tracks, seconds);
    PlacementParams now = values.placement;
    now.translation = moved.translation + carried(moved, values.placement);
    now.scale = moved.scale * values.placement.scale;
    if (angles && values.tracks[turnTrack]) {
        glm::dvec3 near = values.placement.rotation;
        if (near == glm::dvec3(0.0)) { // as curves show it
            const auto& track = std::get<OrientationTrack>(*values.tracks[turnTrack]);
            const std::size_t behind = track.lowerBound(ticksOf(seconds) + 1);
            near = anglesOfKeys(track)[behind == 0 ? 0 : behind - 1];
        }
        now.rotation = anglesOf(moved.turn * orientationOf(values.placement.rotation), near);
    }
    return now;
}

Expected<NodeTransform> withPlacementKeys(const NodeTransform& values, Ticks time, PlacementPart part,
                                          KeyMode mode)
{
    NodeTransform made = values;
    RAMURE_TRY(takeOver(made, time, part, mode));
    const Moved moved = movedAt(made.tracks, secondsOf(time));
    const auto hasKey = [time](const NodeAnimation::TrackPtr& track) {
        return track && std::visit([time](const auto& held) { return bool(held.find(time)); }, *track);
    };
    Expected<void> good;
    for (int c = 0; c < 3 && good && part != PlacementPart::Rotation; ++c) {
        const bool scales = part == PlacementPart::Scale;
        auto& track = made.tracks[(scales ? scaleTracks : 0) + std::size_t(c)];
        if (!hasKey(track))
            good = putKey<Track>(track, time, scales ? moved.scale[c] : moved.translation[c], mode);
    }
    if (part == PlacementPart::Rotation && !hasKey(made.tracks[turnTrack]))
        good = putKey<OrientationTrack>(made.tracks[turnTrack], time, moved.turn, mode);
    RAMURE_TRY(good);
    return made;
}

Expected<NodeTransform> withPlacementSet(const NodeTransform& values, Ticks time, PlacementPart part,
                                         const glm::dvec3& wanted, std::optional<int> component)
{
    if (!isFinite(wanted))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("must be a finite number"));
    NodeTransform made = values;
    const KeyMode mode = KeyMode::Bezier;
    RAMURE_TRY(takeOver(made, time, part, mode));
    const Moved before = movedAt(made.tracks, secondsOf(time));
    const glm::dvec3 origin = before.translation + carried(before, made.placement);
    Moved now = before;
    Expected<void> good;
    if (part == PlacementPart::Translation) {
        now.translation += wanted - origin;
        good = putThree(made, 0, time, now.translation, component, mode);
    } else {
        if (part == PlacementPart::Rotation) {
            now.turn = orientationOf(wanted) * glm::conjugate(orientationOf(made.placement.rotation));
            good = putKey<OrientationTrack>(made.tracks[turnTrack], time, now.turn, mode);
        } else {
            for (int c = 0; c < 3; ++c) {
                if (made.placement.scale[c] == 0.0)
                    return fail(ErrorCode::Invalid, RAMURE_NOOP("the placement's own scale is 0"));
                now.scale[c] = wanted[c] / made.placement.scale[c];
            }
            good = putThree(made, scaleTracks, time, now.scale, component, mode);
        }
        const glm::dvec3 stays = origin - carried(now, made.placement);
        if (good && made.placement.translation != glm::dvec3(0.0))
            good = putThree(made, 0, time, stays, {}, mode); // the origin stays where it is
    }
    RAMURE_TRY(good);
    return made;
}

} // namespace ramure
