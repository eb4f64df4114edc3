// What is known of selected keys.
#include "core/qt/document/key_edits.h"

#include <algorithm>
#include <cmath>

namespace ramure {

NodeAnimation::TrackPtr keys::find(const Scene& scene, const TrackRef& ref)
{
    const Node* node = scene.find(ref.node);
    return node ? node->animation.find(ref.channel) : nullptr;
}

KeySelection keys::existing(const Scene& scene, const KeySelection& selection)
{
    KeySelection there;
    for (const auto& entry : selection) { // no binding: lambdas below use both
        const auto& ref = entry.first;
        const auto& times = entry.second;
        const auto track = find(scene, ref);
        if (!track)
            continue;
        std::vector<Ticks> kept;
        std::visit(
            [&](const auto& held) {
                for (const Ticks time : times)
                    if (held.find(time))
                        kept.push_back(time);
            },
            *track);
        if (!kept.empty())
            there.emplace(ref, std::move(kept));
    }
    return there;
}

std::size_t keys::count(const KeySelection& selection)
{
    std::size_t all = 0;
    for (const auto& [ref, times] : selection)
        all += times.size();
    return all;
}

std::optional<std::pair<Ticks, Ticks>> keys::spanOf(const KeySelection& selection)
{
    std::optional<std::pair<Ticks, Ticks>> span;
    for (const auto& [ref, times] : selection) {
        if (times.empty())
            continue;
        if (!span)
            span = {times.front(), times.back()};
        span = {std::min(span->first, times.front()), std::max(span->second, times.back())};
    }
    return span;
}

std::vector<Ticks> keys::timesOf(const Scene& scene, std::span<const NodeId> nodes)
{
    std::vector<Ticks> times;
    for (const NodeId id : nodes)
        if (const Node* node = scene.find(id))
            for (const auto& [channel, track] : node->animation.tracks())
                std::visit(
                    [&](const auto& held) {
                        for (const auto& key : held.keys())
                            times.push_back(key.time);
                    },
                    *track);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

Ticks keys::ticksOfFrame(const TimelineSettings& settings, double frame)
{
    return ticksOf(std::clamp(frame / settings.framesPerSecond, -1e6, 1e6));
}

Ticks keys::snapped(Ticks time, double stepsPerSecond)
{
    return ticksOf(std::round(secondsOf(time) * stepsPerSecond) / stepsPerSecond);
}

std::optional<Ticks> keys::nextTime(const Scene& scene, const std::vector<TrackRef>& tracks, Ticks time,
                                    bool forward)
{
    std::optional<Ticks> next;
    for (const TrackRef& ref : tracks) {
        const auto track = find(scene, ref);
        if (!track)
            continue;
        std::visit(
            [&](const auto& held) {
                const std::size_t at = held.lowerBound(forward ? time + 1 : time);
                if (forward ? at == held.size() : at == 0)
                    return;
                const Ticks found = held.keys()[forward ? at : at - 1].time;
                if (!next || (forward ? found < *next : found > *next))
                    next = found;
            },
            *track);
    }
    return next;
}

} // namespace ramure
