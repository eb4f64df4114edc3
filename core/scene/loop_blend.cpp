#include "core/scene/loop_blend.h"

#include <algorithm>

namespace ramure {

LoopBlend loopBlend(const TimelineSettings& settings, double timeSeconds)
{
    if (!settings.seamless || settings.loop != PlayLoop::Loop)
        return {};
    const double round = double(settings.lastFrame - settings.firstFrame + 1);
    const double length = std::min(settings.framesPerSecond, 0.5 * round);
    const double frame = timeSeconds * settings.framesPerSecond;
    const double end = double(settings.lastFrame + 1);
    if (!(frame > end - length && frame <= end))
        return {};
    const double share = (frame - (end - length)) / length;
    return {share * share * (3.0 - 2.0 * share), timeSeconds - round / settings.framesPerSecond};
}

} // namespace ramure
