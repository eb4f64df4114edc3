#include "core/session/sequence.h"

#include "core/session/moving_source.h"
#include "core/session/scene_counts.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace ramure {

static tl::unexpected<Error> bad(const char* path, ErrorCode code, const char* text,
                                 std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().path = path;
    return error;
}

Expected<void> checkSequence(const FrameSequence& frames)
{
    if (frames.first < 0 || frames.first > mostFrame)
        return bad("first", ErrorCode::Invalid, RAMURE_NOOP("frames of a sequence are numbered from 0 on"));
    if (frames.last < frames.first || frames.last > mostFrame)
        return bad("last", ErrorCode::Invalid, RAMURE_NOOP("the last frame lies before the first"));
    if (frames.step < 1)
        return bad("step", ErrorCode::Invalid, RAMURE_NOOP("the step must be at least one frame"));
    if (frames.count() > mostSequenceFrames)
        return bad("last", ErrorCode::Limit, RAMURE_NOOP("a sequence has at most %1 frames"),
                   {std::to_string(mostSequenceFrames)});
    return {};
}

std::string numberedFile(const std::string& path, std::int64_t frame)
{
    constexpr std::size_t digits = 4;
    std::string number = std::to_string(frame);
    if (number.size() < digits)
        number.insert(0, digits - number.size(), '0');
    const std::size_t dot = path.find_last_of("./\\");
    const bool hasEnding = dot != std::string::npos && path[dot] == '.';
    std::string out = path.substr(0, hasEnding ? dot : path.size());
    out.append(1, '_').append(number);
    return hasEnding ? out.append(path, dot, std::string::npos) : out;
}

/// The check of a mesh takes as long as the mesh, and no file holds its report.
static TreeSource withoutReport(const TreeSource& source)
{
    return [source](const Node& node, Stage last, const Progress& progress) {
        auto tree = source(node, last, progress);
        if (tree)
            tree->report.reset();
        return tree;
    };
}

Expected<void> exportSequence(const Scene& scene, const ExportOptions& options, const FrameSequence& frames,
                              const TreeSource& rest, const std::string& path, const Progress& progress)
{
    if (auto fine = checkSequence(frames); !fine)
        return fine;
    MovingSource moving(withoutReport(rest), scene.timeline());
    const auto count = static_cast<double>(frames.count());
    for (std::int64_t i = 0; i < frames.count(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const std::int64_t frame = frames.frame(i);
        const double from = static_cast<double>(i) / count;
        ExportOptions now = options;
        now.timeSeconds = frames.timeOf(frame);
        now.arms = &moving.arms();
        if (auto written = exportScene(scene, now, moving.at(now.timeSeconds), numberedFile(path, frame),
                                       progress.part(from, from + 1.0 / count));
            !written)
            return written;
    }
    return {};
}

namespace {

/// Bytes of a vertex and of a triangle, from what core/io writes: numbers of a text have as many digits as
/// their count.
struct FileRates
{
    double vertex = 0.0, triangle = 0.0;
};

FileRates ratesOf(const ExportOptions& options, bool ply, double vertices)
{
    // Of the last number, counted from zero.
    const auto last = static_cast<std::int64_t>(std::ceil(std::max(vertices, 10.0))) - 1;
    const auto digits = static_cast<double>(std::to_string(last).size());
    if (!ply)
        return {options.texture ? 90.0 : 62.0, 3.0 * ((options.texture ? 3.0 : 2.0) * digits + 3.0) + 2.0};
    if (options.ply.ascii)
        return {75.0, 3.0 * (digits + 1.0) + 2.0 + (options.texture ? 60.0 : 0.0)};
    return {35.0, options.texture ? 38.0 : 13.0};
}

} // namespace

std::uint64_t estimatedFileBytes(const Scene& scene, const ExportOptions& options, const TreeSource& rest,
                                 const std::string& path)
{
    if (options.model != ExportModel::Mesh)
        return 0;
    const SceneCounts counts = SceneCounter().count(scene, options, rest);
    if (!counts.complete)
        return 0;
    const auto vertices = static_cast<double>(counts.total().vertices);
    const auto triangles = static_cast<double>(counts.total().faces);
    std::string ending = path.size() > 4 ? path.substr(path.size() - 4) : std::string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const FileRates rates = ratesOf(options, ending == ".ply", vertices);
    return static_cast<std::uint64_t>(rates.vertex * vertices + rates.triangle * triangles);
}

} // namespace ramure
