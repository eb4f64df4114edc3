/// \file
/// The frames of a scene: how many per second, the first and the last one, and the behaviour at the end.
/// Saved in the project. The present time belongs to the player, not to the scene.
#pragma once

#include "core/base/error.h"
#include <cstdint>

namespace ramure {

enum class PlayLoop : std::uint8_t {
    Once,     ///< stops at the last frame
    Loop,     ///< the first frame follows the last
    PingPong, ///< back and forth, the frames at the ends shown once
};

struct TimelineSettings
{
    double framesPerSecond = 24.0;
    std::int64_t firstFrame = 0;
    std::int64_t lastFrame = 250; ///< shown too; not before firstFrame
    PlayLoop loop = PlayLoop::Loop;
    bool seamless = false; ///< Loop: the last second blends into the first frame

    bool operator==(const TimelineSettings&) const = default;
    /// A frame's time in seconds. Frame 0 is at 0 s; physics rests before it.
    [[nodiscard]] double timeOf(std::int64_t frame) const { return double(frame) / framesPerSecond; }
    /// The frame that is shown at a time: the last one that has begun.
    [[nodiscard]] std::int64_t frameAt(double timeSeconds) const;
};

inline constexpr double leastFrameRate = 1.0, mostFrameRate = 240.0;
inline constexpr std::int64_t leastFrame = -1'000'000, mostFrame = 1'000'000;

/// Errors: Invalid, path = "framesPerSecond", "firstFrame" or "lastFrame".
Expected<void> checkTimeline(const TimelineSettings& settings);

/// The place that playing has reached.
struct PlayPlace
{
    std::int64_t frame = 0;
    bool ended = false; ///< Once only: there is nothing more to play
    bool operator==(const PlayPlace&) const = default;
};

/// \param travelled frames since the first frame, played forwards without end; may be negative or lie between
/// frames. (ANIMATION 4.9: floor, not fmod, so that going back works too.)
PlayPlace playedFrame(const TimelineSettings& settings, double travelled);

} // namespace ramure
