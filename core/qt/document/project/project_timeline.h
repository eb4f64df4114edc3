/// \file
/// The "timeline" of a project file: framesPerSecond, firstFrame, lastFrame, loop ("once", "loop",
/// "pingPong"), seamless (true or false); defaults are left out.
#pragma once

#include "core/base/error.h"
#include "core/rig/tracks/timeline_settings.h"
#include <QJsonObject>

namespace ramure::json {

/// Empty where all is default.
QJsonObject writeTimeline(const TimelineSettings& settings);
/// Takes what it knows out of \p object. Errors: Invalid, path = the key inside.
Expected<TimelineSettings> readTimeline(QJsonObject& object);

} // namespace ramure::json
