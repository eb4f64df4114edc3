/// \file
/// Loops without a seam: towards its end the motion goes over into that of one round earlier.
#pragma once

#include "core/rig/tracks/timeline_settings.h"

namespace ramure {

/// How far the motion at a time is on its way into the loop's next round.
struct LoopBlend
{
    double weight = 0.0; ///< 0: not at all .. 1: it is the motion of the earlier time
    double earlierSeconds = 0.0;
};

/// Tells how a seamless loop blends. Over the last second before the first frame comes again, or over the
/// second half of a shorter loop, the motion goes over into that of one round earlier, so that the frame
/// behind the last one is the first one. The weight is 0 for all other settings and times.
LoopBlend loopBlend(const TimelineSettings& settings, double timeSeconds);

} // namespace ramure
