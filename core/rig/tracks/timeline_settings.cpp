#include "core/rig/tracks/timeline_settings.h"

#include <algorithm>
#include <cmath>

namespace ramure {

std::int64_t TimelineSettings::frameAt(double timeSeconds) const
{
    // A frame's own time must give that frame, whatever the division rounded.
    const double frames = std::clamp(timeSeconds * framesPerSecond, double(leastFrame), double(mostFrame));
    const double nearest = std::round(frames);
    return static_cast<std::int64_t>(std::abs(frames - nearest) < 1e-6 ? nearest : std::floor(frames));
}

static tl::unexpected<Error> bad(const char* path, const char* text, std::vector<std::string> args = {})
{
    auto error = fail(ErrorCode::Invalid, text, std::move(args));
    error.value().path = path;
    return error;
}

Expected<void> checkTimeline(const TimelineSettings& settings)
{
    if (!(settings.framesPerSecond >= leastFrameRate && settings.framesPerSecond <= mostFrameRate))
        return bad("framesPerSecond", RAMURE_NOOP("there must be 1 to 240 frames a second"));
    for (const auto& [path, frame] :
         {std::pair{"firstFrame", settings.firstFrame}, std::pair{"lastFrame", settings.lastFrame}})
        if (frame < leastFrame || frame > mostFrame)
            return bad(path, RAMURE_NOOP("a frame must lie between %1 and %2"),
                       {std::to_string(leastFrame), std::to_string(mostFrame)});
    if (settings.lastFrame < settings.firstFrame)
        return bad("lastFrame", RAMURE_NOOP("the last frame lies before the first"));
    return {};
}

PlayPlace playedFrame(const TimelineSettings& settings, double travelled)
{
    const std::int64_t span = settings.lastFrame - settings.firstFrame;
    if (span == 0 || !std::isfinite(travelled))
        return {settings.firstFrame, settings.loop == PlayLoop::Once};
    const auto modulo = [travelled](double period) {
        return travelled - period * std::floor(travelled / period);
    };
    const auto shown = [&](double from) {
        return settings.firstFrame +
               std::clamp(static_cast<std::int64_t>(std::floor(from)), std::int64_t(0), span);
    };
    switch (settings.loop) {
    case PlayLoop::Once:
        return {shown(std::clamp(travelled, 0.0, double(span))), travelled >= double(span)};
    case PlayLoop::Loop:
        return {shown(modulo(double(span + 1))), false};
    case PlayLoop::PingPong: {
        const double way = modulo(2.0 * double(span));
        return {way < double(span) ? shown(way)
                                   : settings.lastFrame - (shown(way - double(span)) - settings.firstFrame),
                false};
    }
    }
    return {settings.firstFrame, true};
}

} // namespace ramure
