#include "core/qt/session/export/wind_export.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr double nearPivot = 0.02; // m

const Foliage& foliageOf(std::span<const WindFoliage> levels, const ExportMesh& mesh)
{
    static const Foliage none;
    const Foliage* foliage = levels[static_cast<std::size_t>(mesh.level)].foliage;
    return foliage ? *foliage : none;
}

bool isOf(const ExportMesh& mesh, const char* part)
{
    return mesh.name.starts_with(part);
}

std::vector<WindVertex> verticesOf(const WindTree& tree, const ExportMesh& mesh,
                                   std::span<const WindFoliage> levels)
{
    const Foliage& foliage = foliageOf(levels, mesh);
    if (isOf(mesh, "leaves"))
        return windOfItems(tree, *mesh.mesh, foliage.leaves, true);
    if (isOf(mesh, "fruit"))
        return windOfItems(tree, *mesh.mesh, foliage.apples, false);
    return windOfBark(tree, *mesh.mesh);
}

/// Each level has only leaves that the one before it has: the first one's are all.
Expected<WindElements> elementsOf(const WindTree& tree, std::span<const ExportMesh> meshes,
                                  std::span<const WindFoliage> levels)
{
    for (const ExportMesh& mesh : meshes)
        if (isOf(mesh, "leaves"))
            return windElements(tree, windLeaves(*mesh.mesh, foliageOf(levels, mesh).leaves));
    return windElements(tree, {});
}

/// \param numberOf of a leaf of the whole tree its number among those that have elements.
void takeElements(std::vector<WindVertex>& vertices, const WindTree& tree, const WindElements& elements,
                  const ExportMesh& mesh, std::span<const WindFoliage> levels,
                  std::span<const Index> numberOf)
{
    if (!isOf(mesh, "leaves") || elements.leavesGoAlong) {
        for (std::size_t v = 0; v < vertices.size(); ++v)
            vertices[v].element = elements.ofStem[tree.stemOf[mesh.mesh->branch[v]]];
        return;
    }
    const WindFoliage& level = levels[static_cast<std::size_t>(mesh.level)];
    const std::size_t each = vertices.size() / level.foliage->leaves.size();
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto own = static_cast<Index>(v / each);
        const FoliageItem& leaf = level.foliage->leaves[own];
        const Index element = elements.ofLeaf[level.leafOf.empty() ? own : numberOf[level.leafOf[own]]];
        // A leaf of a coarse level that has moved to the middle of others has its pivot elsewhere.
        const bool isThere = glm::distance(elements.elements[element].pivot, leaf.position) < nearPivot;
        vertices[v].element = isThere ? element : elements.ofStem[tree.stemOf[leaf.branch]];
    }
}

std::vector<Index> numbersOf(std::span<const Index> leaves)
{
    std::vector<Index> out;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        out.resize(std::max(out.size(), std::size_t(leaves[i]) + 1), 0);
        out[leaves[i]] = static_cast<Index>(i);
    }
    return out;
}

} // namespace

Expected<void> addWind(ExportScene& out, std::size_t first, const std::string& suffix, WindProfile profile,
                       const PosedTree& posed, std::span<const WindFoliage> levels)
{
    if (profile == WindProfile::None || first == out.meshes.size())
        return {};
    if (posed.motion.bones)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("wind data are of a tree at rest: write it at time 0"));
    const WindTree tree = windTree(*posed.rest.skeleton, *posed.rest.simplified);
    const std::span<ExportMesh> meshes = std::span(out.meshes).subspan(first);
    std::vector<std::vector<WindVertex>> vertices;
    for (const ExportMesh& mesh : meshes)
        vertices.push_back(verticesOf(tree, mesh, levels));
    PivotTextures textures;
    if (profile == WindProfile::PivotPainter) {
        const auto elements = elementsOf(tree, meshes, levels);
        RAMURE_TRY(elements);
        const std::vector<Index> numberOf = numbersOf(levels.front().leafOf);
        for (std::size_t i = 0; i < meshes.size(); ++i)
            takeElements(vertices[i], tree, *elements, meshes[i], levels, numberOf);
        textures = pivotTextures(*elements);
        out.pivots.push_back({suffix, textures});
    }
    const std::vector<std::span<const WindVertex>> all(vertices.begin(), vertices.end());
    const WindSettings settings = windSettings(tree, all);
    for (std::size_t i = 0; i < meshes.size(); ++i)
        meshes[i].wind =
            std::make_shared<const WindColumns>(windColumns(profile, all[i], settings, textures));
    return {};
}

Expected<void> checkWindExport(const ExportOptions& options, const FileFormat& format)
{
    if (options.wind == WindProfile::None)
        return {};
    if ((format.holds & holdsWind) == 0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("only a GLB holds wind data"));
    if (options.model != ExportModel::Mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("only the finished mesh has wind data"));
    if (options.instances)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("wind data are of merged leaves: instances of one shape have one shape's"));
    if (!options.clip.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("wind data and an animation exclude each other"));
    return {};
}

} // namespace ramure
