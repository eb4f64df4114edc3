/// \file
/// The "tracks" of a node in a project file, by channelKey():
///
///     "tracks": {
///         "global.orientation": {"blend": "classic", "keys": [{"time": 0, "value": [1, 0, 0, 0]}]},
///         "global.translation.x": {
///             "behind": "repeat",           extrapolation; left out where "hold", likewise "before"
///             "keys": [
///                 {"mode": "LINEAR", "time": 0.5, "value": 2},
///                 {"behind": "FREE", "out": [0.1, 0.3], "time": 1, "value": 3}
///             ],
///             "loop": 5                      seconds; left out where there is none
///         }
///     }
///
/// Times are seconds, read to the nearest tick. Of a key everything but time and value is left out where it
/// has its default: mode BEZIER, easing AUTO, handle types before and behind AUTO_CLAMPED, back, amplitude,
/// period. in and out ([seconds, value], of an orientation four of them) are written of FREE and ALIGNED
/// handles; the others follow from the keys.
#pragma once

#include "core/rig/tracks/node_animation.h"
#include <QJsonObject>

namespace ramure::json {

/// Empty where there is no track.
QJsonObject writeTracks(const NodeAnimation& animation);
/// Takes the channels this kind of node has out of \p object. Errors: Invalid, path = the place inside, such
/// as "global.translation.x.keys[3].mode".
Expected<NodeAnimation> readTracks(QJsonObject& object, NodeKind kind);

} // namespace ramure::json
