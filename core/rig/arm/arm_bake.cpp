#include "core/rig/arm/arm_bake.h"

#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// The angles at all frames, by angle.
struct Samples
{
    std::vector<Ticks> ticks;
    std::vector<double> seconds;
    std::vector<std::vector<double>> angles;
};

Expected<ArmBakeRange> checkedRange(const ArmBakeOptions& options, const TimelineSettings& timeline)
{
    const ArmBakeRange range =
        options.range.value_or(ArmBakeRange{timeline.firstFrame, timeline.lastFrame, 1});
    if (range.firstFrame < leastFrame || range.lastFrame > mostFrame || range.lastFrame < range.firstFrame)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the last frame must not stand before the first one"));
    if (range.every < 1)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there must be at least one frame from key to key"));
    return range;
}

Expected<Samples> sampled(const NodeParams& params, const NodeAnimation& animation,
                          const TimelineSettings& timeline, const ArmBakeRange& range,
                          const Progress& progress)
{
    ArmDriver driver = armDriver(params, animation);
    Samples samples;
    samples.angles.resize(2 * params.joints.size());
    const auto frames = double(range.lastFrame - range.firstFrame + 1);
    for (std::int64_t frame = range.firstFrame;;) {
        const double seconds = timeline.timeOf(frame);
        const auto moment = driver.momentAt(seconds, {progress.stop, {}});
        RAMURE_TRY(moment);
        samples.ticks.push_back(ticksOf(seconds));
        samples.seconds.push_back(seconds);
        for (std::size_t i = 0; i < samples.angles.size(); ++i) {
            std::vector<double>& own = samples.angles[i];
            const double angle = moment->angles[i];
            // The shorter way; exactly the angle where that is no way round.
            const double way = own.empty() ? 0.0 : angle - own.back();
            own.push_back(own.empty() || std::abs(way) <= std::numbers::pi ? angle
                                                                           : own.back() + wrappedAngle(way));
        }
        if (samples.ticks.size() % 64 == 1)
            progress.report(double(frame - range.firstFrame) / frames);
        if (frame == range.lastFrame)
            return samples;
        frame += std::min(range.every, range.lastFrame - frame);
    }
}

Track trackOf(const Samples& samples, const std::vector<double>& values, double tolerance)
{
    std::vector<Key> keys;
    for (const std::size_t i : neededPoints(samples.seconds, values, tolerance)) {
        Key key;
        key.time = samples.ticks[i];
        key.mode = KeyMode::Linear;
        key.value = values[i];
        keys.push_back(key);
    }
    return Track::fromKeys(std::move(keys)).value_or(Track());
}

void keyTarget(NodeAnimation& animation, const glm::dvec3& target, Ticks time)
{
    const ParamId id = paramId(*findParam("arm.target"));
    for (std::uint8_t c = 0; c < 3; ++c) {
        const Channel channel{ChannelPart::Parameter, c, id};
        if (animation.find(channel))
            continue;
        Key key;
        key.time = time;
        key.mode = KeyMode::Linear;
        key.value = target[c];
        animation.set(channel, AnyTrack(Track::fromKeys({key}).value_or(Track())));
    }
}

} // namespace

std::vector<std::size_t> neededPoints(std::span<const double> times, std::span<const double> values,
                                      double tolerance)
{
    if (values.empty())
        return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (*most == *least)
        return {0};
    std::vector<unsigned char> needed(values.size(), tolerance == 0.0 ? 1 : 0);
    needed.front() = needed.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open;
    if (tolerance > 0.0)
        open.emplace_back(0, values.size() - 1);
    while (!open.empty()) {
        const auto span = open.back();
        open.pop_back();
        const double slope =
            (values[span.second] - values[span.first]) / (times[span.second] - times[span.first]);
        double farthest = tolerance;
        std::size_t worst = span.first;
        for (std::size_t i = span.first + 1; i < span.second; ++i) {
            const double away =
                std::abs(values[i] - values[span.first] - slope * (times[i] - times[span.first]));
            if (away > farthest) {
                farthest = away;
                worst = i;
            }
        }
        if (worst == span.first)
            continue;
        needed[worst] = 1;
        open.emplace_back(span.first, worst);
        open.emplace_back(worst, span.second);
    }
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < needed.size(); ++i)
        if (needed[i])
            indices.push_back(i);
    return indices;
}

Expected<NodeAnimation> bakeArm(const NodeParams& params, const NodeAnimation& animation,
                                const TimelineSettings& timeline, const ArmBakeOptions& options,
                                const Progress& progress)
{
    RAMURE_TRY(checkArm(params.joints));
    if (!params.arm.follows)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the arm follows no target: there is no motion to bake"));
    if (!std::isfinite(options.toleranceRad) || options.toleranceRad < 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a tolerance must not be negative"));
    const auto range = checkedRange(options, timeline);
    RAMURE_TRY(range);
    const auto samples = sampled(params, animation, timeline, *range, progress.part(0.0, 0.95));
    RAMURE_TRY(samples);
    NodeAnimation baked = animation;
    for (std::size_t i = 0; i < samples->angles.size(); ++i) {
        const Channel channel{ChannelPart::Joint, static_cast<std::uint8_t>(i / 2),
                              static_cast<ParamId>(jointAngleNumber(i % 2 == 0))};
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        if (!baked.find(channel))
            baked.set(channel, AnyTrack(trackOf(*samples, samples->angles[i], options.toleranceRad)));
    }
    if (options.target)
        keyTarget(baked, params.arm.target, samples->ticks.front());
    progress.report(1.0);
    return baked;
}

} // namespace ramure
