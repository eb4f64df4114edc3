/// \file
/// Adds a key to a track, for the gizmo, fields that make keys and auto-key.
#pragma once

#include "core/rig/tracks/node_animation.h"

namespace ramure {

/// The track with a key of this value at this time; it goes on as the key before it does, the first one as
/// \p mode says. Error: that of the track's insert(), for values that are not finite.
template <class TrackType, class Value>
Expected<NodeAnimation::TrackPtr> withKey(const NodeAnimation::TrackPtr& present, Ticks time,
                                          const Value& value,
                                          KeyMode mode = typename TrackType::KeyKind().mode)
{
    TrackType track = present ? std::get<TrackType>(*present) : TrackType();
    typename TrackType::KeyKind key;
    key.mode = mode;
    if (!track.empty()) {
        const std::size_t behind = track.lowerBound(time + 1);
        key = track.keys()[behind == 0 ? 0 : behind - 1];
    }
    key.time = time;
    key.value = value;
    RAMURE_TRY(track.insert(key));
    return std::make_shared<const AnyTrack>(std::move(track));
}

} // namespace ramure
