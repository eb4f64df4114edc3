#include "core/qt/session/export/level_export.h"

#include "core/math/reproducible.h"
#include "core/qt/session/export/exporter.h"
#include <cmath>
#include <glm/matrix.hpp>

namespace ramure {

double nodeScale(const EvaluatedScene& scene, NodeId node)
{
    const double volume = std::abs(glm::determinant(glm::dmat3(scene.transforms(node).geometry)));
    return volume > 0.0 ? maths::pow(volume, 1.0 / 3.0) : 1.0;
}

Expected<LevelledTree> levelsOf(const Node& node, EvaluatedScene& scene, const ExportOptions& options,
                                const Progress& progress)
{
    const bool isClip = !options.clip.empty(), moves = isClip || scene.seconds() > 0.0;
    auto posed = scene.posedTree(node, moves ? Stage::Foliage : stageOfLevels(options.levels), isClip,
                                 progress.part(0.0, 0.4));
    RAMURE_TRY(posed);
    LevelledTree out{std::move(*posed), {}, {}, {}};
    const auto has = [&](ExportPart part) { return (options.parts & part) != 0; };
    const LevelParts parts{has(exportBranches), has(exportLeaves), has(exportApples), options.texture};
    const NodeParams& params = scene.params(node);
    LevelOptions wanted = options.levels;
    wanted.cards = wanted.cards && options.texture && options.write.mapSize > 0; // they are pictures
    auto levels = treeLevels(out.tree.rest, params, wanted, parts, progress.part(0.4, 1.0));
    RAMURE_TRY(levels);
    out.levels = std::move(*levels);
    out.switches = switchesOf(out.levels, options.levels, nodeScale(scene, node.id));
    out.skins.resize(out.levels.size());
    for (std::size_t i = 0; moves && i < out.levels.size(); ++i) {
        auto skins = bindLevel(out.levels[i], out.tree.rest.simplified->skeleton, params.skin.method,
                               out.tree.motion.firstLeaf);
        RAMURE_TRY(skins);
        out.skins[i] = std::move(*skins);
    }
    return out;
}

Expected<void> checkLevelExport(const ExportOptions& options, const FileFormat& format)
{
    if (!options.levels.isWanted())
        return {};
    if (options.model != ExportModel::Mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("only the finished mesh has levels of detail"));
    if (options.instances)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("levels of detail have their leaves merged: no list of instances"));
    if (options.variants && (format.holds & holdsVariants)) {
        auto error = fail(ErrorCode::Invalid,
                          RAMURE_NOOP("levels of detail have the leaves of one day: write the four seasons "
                                      "without levels, or one file of levels for each day"));
        error.value().path = "variants";
        return error;
    }
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
