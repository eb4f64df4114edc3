#include "core/qt/session/export/level_export.h"

#include "core/lod/collision_chain.h"
#include "core/math/reproducible.h"
#include "core/qt/session/export/exporter.h"
#include <algorithm>
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
    auto levels = treeLevels(out.tree.rest, params, options.levels, parts, progress.part(0.4, 1.0));
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

LevelOptions levelsIn(const FileFormat& format, const ExportOptions& options)
{
    constexpr int pictured = holdsTexture | holdsObjects;
    LevelOptions out = options.levels;
    if ((format.holds & pictured) == pictured && options.texture && options.write.mapSize > 0)
        return out;
    const auto most = static_cast<std::size_t>(std::max<std::int64_t>(out.count - 1, 0));
    for (std::vector<double>* switches : {&out.distances, &out.shares})
        if (out.billboard && switches->size() > most)
            switches->resize(most);
    out.cards = out.billboard = false;
    return out;
}

void tellLevel(ExportMesh& mesh, const LevelledTree& tree, std::size_t level)
{
    mesh.isLevel = true;
    mesh.level = static_cast<int>(level);
    mesh.coverage = tree.switches.coverage[level];
    mesh.share = level > 0 ? tree.switches.shares[level] : 0.0;
    mesh.distance = tree.switches.distances[level];
    mesh.name += "_LOD" + std::to_string(level);
}

bool isOneFile(const FileFormat& format, const ExportOptions& options)
{
    return (format.holds & holdsLevels) != 0 && !options.levelFiles;
}

void addCollision(ExportScene& out, Index node, std::size_t first, const Skeleton& skeleton,
                  const ExportOptions& options)
{
    if (options.collision == CollisionNames::None || first == out.meshes.size())
        return;
    const std::string name = out.meshes[first].name;
    const Index material = materialIn(out, Material{"collision", glm::u8vec3(200, 60, 200)});
    int number = 0;
    for (TriangleMesh& piece : collisionChain(skeleton)) {
        std::string digits = std::to_string(number++);
        digits.insert(0, 2 - std::min<std::size_t>(digits.size(), 2), '0');
        ExportMesh mesh{{}, node, std::make_shared<const TriangleMesh>(std::move(piece)), material};
        mesh.name = std::string(name).append("_").append(digits);
        if (options.collision == CollisionNames::Godot)
            mesh.name += "-convcolonly";
        else
            mesh.name.insert(0, options.collision == CollisionNames::Unity ? "COL_" : "UCX_");
        mesh.isLevel = options.levelFiles && options.levels.isWanted(); // in the file of the finest alone
        out.meshes.push_back(std::move(mesh));
    }
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
    if (!options.levels.isWanted() || !format || isOneFile(**format, options))
        return {path};
    std::vector<std::string> files;
    const auto count = static_cast<int>(levelsIn(**format, options).total());
    for (int level = 0; level < count; ++level)
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
