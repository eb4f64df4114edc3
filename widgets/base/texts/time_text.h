/// \file
/// Frames as the user wants to read and type them: numbers, seconds, or timecode.
#pragma once

#include "core/rig/tracks/timeline_settings.h"
#include <QString>
#include <optional>

namespace ramure {

enum class TimeDisplay { Frames, Seconds, Timecode };

/// "48", "2.00 s", or "00:00:02:00" (hours, minutes, seconds, frames; frame rates that are not whole count as
/// the next whole number, without dropping frames). Locale's decimal sign.
QString timeText(std::int64_t frame, double framesPerSecond, TimeDisplay display);
/// Reads a frame from a text. Units may be left out and timecode shortened from the left ("2:00"). A text in
/// another display's form is understood, too ("2 s", "48 f"). Returns nothing if it is no time.
std::optional<std::int64_t> frameFromText(const QString& text, double framesPerSecond, TimeDisplay display);

} // namespace ramure
