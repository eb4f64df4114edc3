#include "core/session/sequence.h"

#include "core/io/formats/file_format.h"
#include "core/math/reproducible.h"
#include "core/pipeline/texture_stage.h"
#include "core/session/scene_counts.h"

#include <algorithm>
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
    Evaluator evaluator(withoutReport(rest), scene.timeline());
    const auto count = static_cast<double>(frames.count());
    for (std::int64_t i = 0; i < frames.count(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const std::int64_t frame = frames.frame(i);
        const double from = static_cast<double>(i) / count;
        if (auto written = exportScene(evaluator.at(scene, frames.timeOf(frame)), options,
                                       numberedFile(path, frame), progress.part(from, from + 1.0 / count));
            !written)
            return written;
    }
    return {};
}

/// Of a triangle of a level, whose leaves are simple; measured.
constexpr double verticesOfLevels = 1.35;
/// Of the bytes of a GLB without its pictures; measured.
constexpr double compressedShare = 0.2;

static double levelTriangles(const LevelOptions& levels, double whole)
{
    double sum = 0.0;
    for (std::size_t i = 0;
         i < static_cast<std::size_t>(std::clamp<std::int64_t>(levels.count, 0, mostLevels)); ++i) {
        sum += i < levels.budgets.size() ? static_cast<double>(levels.budgets[i]) : whole;
        whole *= levelStep;
    }
    return sum;
}

/// Of bark and leaves, where the file holds them itself: by measure, finer pictures are smoother ones.
static double pictureBytes(const Scene& scene, const ExportOptions& options, const FileFormat& format,
                           double vertices)
{
    constexpr double bytes = 5400.0, growth = 0.9, tangent = 16.0;
    const bool isInside =
        (format.holds & holdsTexture) && (format.holds & holdsObjects) && *format.beside == '\0';
    const bool isWanted = options.texture && options.write.mapSize > 0;
    const auto hasPictures = [&](const Node& node) {
        return node.kind == NodeKind::Tree && isExported(scene, options, node) && isPictured(node.params);
    };
    return isInside && isWanted && std::ranges::any_of(scene.nodes(), hasPictures)
               ? bytes * maths::pow(options.write.mapSize, growth) + tangent * vertices
               : 0.0;
}

std::uint64_t estimatedFileBytes(const Scene& scene, const ExportOptions& options, const TreeSource& rest,
                                 const std::string& path)
{
    const auto format = findFormat(path, FormatUse::Write, options.write.ascii);
    if (!format || options.model != ExportModel::Mesh)
        return 0;
    ExportOptions held = options;
    if (options.instances)
        held.parts &= exportBranches;
    const SceneCounts counts = SceneCounter().count(scene, held, rest);
    if (!counts.complete)
        return 0;
    auto vertices = static_cast<double>(counts.total().vertices);
    auto triangles = static_cast<double>(counts.total().faces);
    if (options.levels.isWanted()) {
        triangles = levelTriangles(options.levels, triangles);
        vertices = verticesOfLevels * triangles;
    }
    // Of the last number, counted from zero.
    const auto last = static_cast<std::int64_t>(std::ceil(std::max(vertices, 10.0))) - 1;
    const auto digits = static_cast<double>(std::to_string(last).size());
    const FileRates rates = (*format)->rates(options.texture, digits);
    const double share = options.write.compressed ? compressedShare : 1.0;
    return static_cast<std::uint64_t>(share * (rates.vertex * vertices + rates.triangle * triangles) +
                                      pictureBytes(scene, options, **format, vertices));
}

} // namespace ramure
