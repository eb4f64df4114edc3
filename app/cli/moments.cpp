#include "app/cli/moments.h"

#include "core/qt/session/motion/sequence.h"
#include <cmath>

namespace ramure::cli {
namespace {

constexpr double mostSeconds = 1e6;

Expected<double> numberOf(const CommandLine& line, const char* option, double least, double most)
{
    bool isNumber = false;
    const double value = line.value(option).toDouble(&isNumber);
    if (isNumber && value >= least && value <= most)
        return value;
    return fail(ErrorCode::Invalid, "--%1 \"%2\": a number from %3 to %4 expected",
                {option, line.value(option).toStdString(), QString::number(least).toStdString(),
                 QString::number(most).toStdString()});
}

Expected<std::vector<std::int64_t>> framesOf(const QString& text)
{
    const QStringList parts = text.split(u':');
    std::vector<std::int64_t> numbers;
    for (const QString& part : parts) {
        bool whole = false;
        const qlonglong value = part.toLongLong(&whole);
        if (!whole || value < 0 || value > mostFrame)
            numbers.clear();
        else
            numbers.push_back(value);
        if (numbers.empty())
            break;
    }
    const bool fits = numbers.size() == std::size_t(parts.size()) &&
                      (numbers.size() == 2 || numbers.size() == 3) && numbers[1] >= numbers[0] &&
                      (numbers.size() == 2 || numbers[2] > 0);
    if (!fits)
        return fail(ErrorCode::Invalid,
                    "--frames \"%1\": FIRST:LAST or FIRST:LAST:STEP expected, whole numbers from 0 on",
                    {text.toStdString()});
    const std::int64_t step = numbers.size() == 3 ? numbers[2] : 1;
    if ((numbers[1] - numbers[0]) / step >= mostSequenceFrames)
        return fail(ErrorCode::Limit, "--frames \"%1\": more than %2 frames",
                    {text.toStdString(), std::to_string(mostSequenceFrames)});
    std::vector<std::int64_t> frames;
    for (std::int64_t frame = numbers[0]; frame <= numbers[1]; frame += step)
        frames.push_back(frame);
    return frames;
}

/// Frames of a loop and the first one again. \param from when it begins.
Expected<void> closeLoop(Moments& moments, double from, double seconds)
{
    const auto first = static_cast<std::int64_t>(std::ceil(from * moments.framesPerSecond));
    const auto count = std::max<std::int64_t>(2, std::llround(seconds * moments.framesPerSecond));
    if (count >= mostSequenceFrames || first + count > mostFrame)
        return fail(ErrorCode::Limit, "--wind-loop \"%1\": more than %2 frames",
                    {QString::number(seconds).toStdString(), std::to_string(mostSequenceFrames)});
    for (std::int64_t frame = first; frame <= first + count; ++frame)
        moments.frames.push_back(frame);
    moments.timeline = {moments.framesPerSecond, first, first + count - 1, PlayLoop::Loop, true};
    moments.closes = true;
    return {};
}

} // namespace

void addMomentOptions(CommandLine& line, MomentOptions kind)
{
    line.add({QStringLiteral("time")},
             QStringLiteral(
                 "The trees as their physics has moved them after so many seconds; 0, at rest, without it."),
             QStringLiteral("SECONDS"));
    if (kind == MomentOptions::One)
        return;
    line.add(
        {QStringLiteral("frames")},
        QStringLiteral(
            "A file for each frame FIRST, FIRST + STEP … LAST; the number goes before the file's ending."),
        QStringLiteral("FIRST:LAST[:STEP]"));
    line.add({QStringLiteral("fps")},
             QStringLiteral("Frames per second, 1 to 240; without it those of the project."),
             QStringLiteral("RATE"));
    line.add(
        {QStringLiteral("seamless")},
        QStringLiteral("With --frames: they are a loop whose last second blends into its first frame, as "
                       "the editor's \"Seamless loop\"; without it the project says so."));
}

Expected<Moments> momentsOf(const CommandLine& line, const Input& input)
{
    Moments moments;
    const bool moving = line.has("time") || line.has("frames") || line.has("wind-loop");
    if (moving && !input.scene())
        return fail(ErrorCode::Invalid, "--time, --frames and --wind-loop need a tree: the input is a mesh");
    if (line.has("time") && line.has("frames"))
        return fail(ErrorCode::Invalid, "--time or --frames, not both");
    if (input.scene())
        moments.timeline = input.scene()->timeline();
    moments.framesPerSecond = moments.timeline.framesPerSecond;
    if (line.has("time")) {
        const auto time = numberOf(line, "time", 0.0, mostSeconds);
        RAMURE_TRY(time);
        moments.timeSeconds = *time;
    }
    if (line.has("fps")) {
        const auto rate = numberOf(line, "fps", leastFrameRate, mostFrameRate);
        RAMURE_TRY(rate);
        moments.framesPerSecond = *rate;
    }
    if (line.has("frames")) {
        auto frames = framesOf(line.value("frames"));
        RAMURE_TRY(frames);
        moments.frames = std::move(*frames);
    }
    if (line.has("wind-loop")) {
        constexpr double settled = 2.0; // s: the wind has taken hold of what was at rest
        if (line.has("frames") || line.has("seamless"))
            return fail(ErrorCode::Invalid,
                        "--wind-loop chooses its frames itself: no --frames, no --seamless");
        const auto seconds = numberOf(line, "wind-loop", 0.1, 3600.0);
        RAMURE_TRY(seconds);
        const double from = line.has("time") ? moments.timeSeconds : settled;
        RAMURE_TRY(closeLoop(moments, from, *seconds));
        return moments;
    }
    if (!line.has("seamless"))
        return moments;
    if (!moments.isSequence())
        return fail(ErrorCode::Invalid, "--seamless needs --frames: one moment is no loop");
    moments.timeline = {moments.framesPerSecond, moments.frames.front(), moments.frames.back(),
                        PlayLoop::Loop, true};
    return moments;
}

QString numberedFile(const QString& file, std::int64_t frame)
{
    return pathText(ramure::numberedFile(systemPath(file), frame));
}

} // namespace ramure::cli
