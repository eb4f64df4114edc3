/// \file
/// --time, --frames, --wind-loop and --fps: at which moments a command looks at trees that move.
#pragma once

#include "app/cli/input.h"
#include <optional>
#include <vector>

namespace ramure::cli {

struct Moments
{
    double timeSeconds = 0.0;
    /// Frames of a sequence, in their order; empty: one moment.
    std::vector<std::int64_t> frames;
    double framesPerSecond = 24.0;

    /// The timeline of the project; with --seamless the frames form a loop without a seam.
    TimelineSettings timeline;

    /// --wind-loop: the last frame is the first one again, as programs want it that play a clip round and
    /// round.
    bool closes = false;

    [[nodiscard]] bool isSequence() const { return !frames.empty(); }
    [[nodiscard]] double timeOf(std::int64_t frame) const { return double(frame) / framesPerSecond; }
};

enum class MomentOptions { One, Sequence };
void addMomentOptions(CommandLine& line, MomentOptions kind);
/// The frame rate is that of the project unless --fps says another. Errors: Invalid (no number, no range,
/// more than 100,000 frames, a mesh file as input).
Expected<Moments> momentsOf(const CommandLine& line, const Input& input);

/// See core/qt/session/motion/sequence.h.
QString numberedFile(const QString& file, std::int64_t frame);

} // namespace ramure::cli
