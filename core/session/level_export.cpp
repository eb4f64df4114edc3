#include "core/session/level_export.h"

#include "core/math/box.h"
#include "core/math/reproducible.h"
#include <algorithm>

namespace ramure {
namespace {

/// m: of a level whose details nobody sees.
constexpr double leastDetail = 1e-9;

Box boxOf(const TreeLevel& level)
{
    Box box;
    for (const auto& mesh : {level.bark, level.leaves, level.apples})
        if (mesh)
            for (const glm::vec3& p : mesh->positions)
                box.add(glm::dvec3(p));
    return box;
}

} // namespace

std::vector<double> coverageOf(const std::vector<TreeLevel>& levels)
{
    const Box box = boxOf(levels.front());
    const glm::dvec3 size = box.size();
    std::vector<double> coverage(levels.size(), 0.0);
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        const double pixel = std::max(levels[i + 1].detail, leastDetail);
        const double area = size.y / pixel * std::max(size.x, size.z) / pixel;
        coverage[i] = std::min(area / (levelScreenWidth * levelScreenHeight), i > 0 ? coverage[i - 1] : 1.0);
    }
    return coverage;
}

std::vector<double> distancesOf(const std::vector<TreeLevel>& levels, double fovRad)
{
    const double pixelsPerRatio = levelScreenHeight / (2.0 * maths::tan(0.5 * fovRad));
    std::vector<double> distances(levels.size(), 0.0);
    for (std::size_t i = 1; i < levels.size(); ++i)
        distances[i] = std::max(distances[i - 1], std::max(levels[i].detail, leastDetail) * pixelsPerRatio);
    return distances;
}

Expected<LevelledTree> levelsOf(const Node& node, EvaluatedScene& scene, const ExportOptions& options,
                                const Progress& progress)
{
    const bool isClip = !options.clip.empty(), moves = isClip || scene.seconds() > 0.0;
    auto posed = scene.posedTree(node, moves ? Stage::Foliage : stageOfLevels(options.levels), isClip,
                                 progress.part(0.0, 0.4));
    if (!posed)
        return fail(std::move(posed.error()));
    LevelledTree out{std::move(*posed), {}, {}, {}};
    const auto has = [&](ExportPart part) { return (options.parts & part) != 0; };
    const LevelParts parts{has(exportBranches), has(exportLeaves), has(exportApples), options.texture};
    const NodeParams& params = scene.params(node);
    auto levels = treeLevels(out.tree.rest, params, options.levels, parts, progress.part(0.4, 1.0));
    if (!levels)
        return fail(std::move(levels.error()));
    out.levels = std::move(*levels);
    out.coverage = coverageOf(out.levels);
    out.skins.resize(out.levels.size());
    for (std::size_t i = 0; moves && i < out.levels.size(); ++i) {
        auto skins = bindLevel(out.levels[i], out.tree.rest.simplified->skeleton, params.skin.method,
                               out.tree.motion.firstLeaf);
        if (!skins)
            return fail(std::move(skins.error()));
        out.skins[i] = std::move(*skins);
    }
    return out;
}

Expected<void> checkLevelExport(const ExportOptions& options)
{
    if (!options.levels.isWanted())
        return {};
    if (options.model != ExportModel::Mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("only the finished mesh has levels of detail"));
    if (options.instances)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("levels of detail have their leaves merged: no list of instances"));
    return checkLevels(options.levels);
}

std::string levelFile(const std::string& path, int level)
{
    const std::size_t name = path.find_last_of('/') + 1, dot = path.find_last_of('.');
    const std::size_t end = dot == std::string::npos || dot <= name ? path.size() : dot;
    return path.substr(0, end) + "_LOD" + std::to_string(level) + path.substr(end);
}

std::vector<std::string> exportFiles(const ExportOptions& options, const std::string& path)
{
    const auto format = findFormat(path, FormatUse::Write, options.write.ascii);
    if (!options.levels.isWanted() || !format || ((*format)->holds & holdsLevels))
        return {path};
    std::vector<std::string> files;
    for (int level = 0; level < static_cast<int>(options.levels.count); ++level)
        files.push_back(levelFile(path, level));
    return files;
}

Expected<void> writeLevels(const FileFormat& format, const std::string& path, const ExportScene& scene,
                           const WriteOptions& options, const Progress& progress)
{
    const int last = lastLevel(scene);
    for (int level = 0; level <= last; ++level) {
        const double count = last + 1.0;
        if (auto written = format.write(levelFile(path, level), levelOf(scene, level), options,
                                        progress.part(level / count, (level + 1) / count));
            !written)
            return written;
    }
    return {};
}

} // namespace ramure
