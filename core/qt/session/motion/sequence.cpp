#include "core/qt/session/motion/sequence.h"

#include "core/io/formats/file_format.h"
#include "core/math/reproducible.h"
#include "core/pipeline/texture_stage.h"
#include "core/qt/session/export/exporter.h"
#include "core/qt/session/export/scene_counts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

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

/// Of a triangle of a level: without a budget, and with one, whose leaves are cards; measured.
constexpr double verticesOfSteps = 1.21, verticesOfBudgets = 1.58;

/// \param trees of which each has its budgets
static double levelTriangles(const LevelOptions& levels, double whole, double trees)
{
    double sum = 0.0;
    for (std::size_t i = 0;
         i < static_cast<std::size_t>(std::clamp<std::int64_t>(levels.count, 0, mostLevels)); ++i) {
        sum += i < levels.budgets.size() ? trees * static_cast<double>(levels.budgets[i]) : whole;
        whole *= levelStep;
    }
    return sum;
}

/// What a GLB has beyond vertices and triangles; all of it measured on six species.
namespace glb {

/// Megabytes of bark and leaves at 1024 pixels a side, by BarkFamily; and the power of the side.
constexpr double pictures[] = {0.42, 1.41, 2.41, 2.29, 2.38, 2.15, 1.64,
                               2.38, 1.80, 1.86, 1.96, 2.44, 1.67, 1.97};
constexpr double growth = 1.5;
constexpr double coordinates = 24.0;                  ///< with tangents, of a vertex
constexpr double barkSeams = 0.33, otherSeams = 0.04; ///< vertices that are there twice for the texture
constexpr double skin = 24.0, packedSkin = 1.0;       ///< of a vertex that moves
constexpr double joint = 664.0, key = 28.0;           ///< of a joint
constexpr double facesOfBranch = 26.0;
constexpr double packed = 0.22; ///< of the bytes of vertices and triangles

} // namespace glb

/// Bytes, at 1024 pixels a side: colours of bark and leaves by the kinds that the scene has.
static double pictureBytes(const Scene& scene, const ExportOptions& options)
{
    std::set<std::pair<BarkFamily, LeafShape>> kinds;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Tree && isExported(scene, options, node) && isPictured(node.params))
            kinds.emplace(node.params.bark.family, node.params.leaf.shape);
    double bytes = 0.0;
    for (const auto& [bark, leaf] : kinds)
        bytes += 1e6 * glb::pictures[static_cast<std::size_t>(bark)];
    return bytes;
}

static double windBytes(WindProfile profile)
{
    switch (profile) {
    case WindProfile::None:
        return 0.0;
    case WindProfile::Crysis:
    case WindProfile::PivotPainter:
        return 8.0;
    default:
        return 16.0;
    }
}

static double glbBytes(const Scene& scene, const ExportOptions& options, const SceneCounts& counts,
                       double vertices, double triangles)
{
    const double drawn = pictureBytes(scene, options);
    const bool hasPictures = options.texture && options.write.mapSize > 0 && drawn > 0.0;
    const FileRates rates = (*findFormat("a.glb", FormatUse::Write))->rates(false, 0.0);
    double bytes = rates.vertex + windBytes(options.wind), beside = 0.0;
    if (hasPictures) {
        const auto bark = static_cast<double>(counts.of(ScenePart::Branches).vertices);
        if (!options.levels.isWanted())
            vertices += glb::barkSeams * bark + glb::otherSeams * (vertices - bark);
        bytes += glb::coordinates;
        beside = drawn * maths::pow(options.write.mapSize / 1024.0, glb::growth);
    }
    bytes = bytes * vertices + rates.triangle * triangles;
    if (options.write.compressed)
        bytes *= glb::packed;
    if (!options.clip.empty()) {
        const double branches =
            static_cast<double>(counts.of(ScenePart::Branches).faces) / glb::facesOfBranch;
        const double joints =
            options.write.joints > 0 ? std::min<double>(options.write.joints, branches) : branches;
        bytes += (options.write.compressed ? glb::packedSkin : glb::skin) * vertices +
                 joints * (glb::joint + glb::key * static_cast<double>(options.clip.size() + 1));
    }
    return bytes + beside;
}

/// A GLB has the meshes of trees at rest once that differ only in their place: the second one has none. The
/// pipeline gives such trees the same mesh.
static TreeSource withoutRepeats(const TreeSource& rest)
{
    const auto inItsPlace = [](NodeParams params) {
        params.tree = params.local = {};
        return params;
    };
    std::map<const BranchMesh*, NodeParams> known;
    return [=](const Node& node, Stage last, const Progress& progress) mutable {
        auto tree = rest(node, last, progress);
        if (!tree || !tree->branches)
            return tree;
        NodeParams params = inItsPlace(node.params);
        const auto [first, isNew] = known.try_emplace(tree->branches.get(), params);
        if (!isNew && first->second == params) {
            tree->branches = std::make_shared<const BranchMesh>();
            tree->leaves = tree->apples = nullptr;
        }
        return tree;
    };
}

std::uint64_t estimatedFileBytes(const Scene& scene, const ExportOptions& options, const TreeSource& rest,
                                 const std::string& path)
{
    const auto format = findFormat(path, FormatUse::Write, options.write.ascii);
    if (!format || options.model != ExportModel::Mesh || options.growthFrom > 0.0)
        return 0; // leaves of other ages are not counted yet
    ExportOptions held = options;
    if (options.instances)
        held.parts &= exportBranches;
    const bool hasOnce = ((*format)->holds & holdsClip) && options.clip.empty() && !options.levels.isWanted();
    const SceneCounts counts = SceneCounter().count(scene, held, hasOnce ? withoutRepeats(rest) : rest);
    if (!counts.complete)
        return 0;
    auto vertices = static_cast<double>(counts.total().vertices);
    auto triangles = static_cast<double>(counts.total().faces);
    if (const LevelOptions& levels = options.levels; levels.isWanted()) {
        const auto trees = std::ranges::count_if(scene.nodes(), [&](const Node& node) {
            return node.kind == NodeKind::Tree && isExported(scene, options, node);
        });
        const double all = levelTriangles(levels, triangles, static_cast<double>(trees));
        vertices =
            levels.beginsWhole() ? vertices + verticesOfSteps * (all - triangles) : verticesOfBudgets * all;
        triangles = all;
    }
    if ((*format)->holds & holdsClip)
        return static_cast<std::uint64_t>(glbBytes(scene, options, counts, vertices, triangles));
    // Of the last number, counted from zero.
    const auto last = static_cast<std::int64_t>(std::ceil(std::max(vertices, 10.0))) - 1;
    const auto digits = static_cast<double>(std::to_string(last).size());
    const FileRates rates = (*format)->rates(options.texture, digits);
    return static_cast<std::uint64_t>(rates.vertex * vertices + rates.triangle * triangles);
}

} // namespace ramure
