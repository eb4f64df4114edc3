#include "core/qt/session/export/growth_export.h"

#include "core/base/number_text.h"
#include "core/lod/growth_leaves.h"
#include "core/lod/growth_mesh.h"
#include <cmath>

namespace ramure {
namespace {

/// Of the triangles of the bark, those of the leaves of each age.
constexpr double leafShare = 0.5;

ExportShapes timesOf(const GrowthMesh& growth, const ExportOptions& options)
{
    ExportShapes out;
    for (const GrowthKey& key : growth.keys)
        out.seconds.push_back(static_cast<float>((key.age - growth.keys.front().age) / options.growthSpeed));
    out.at.assign(growth.keys.size(), noIndex);
    return out;
}

std::string nameOf(const GrowthKey& key)
{
    return numberText(std::round(100.0 * key.age) / 100.0) + " years";
}

std::shared_ptr<const ExportShapes> barkShapes(GrowthMesh& growth, ExportShapes shapes)
{
    for (Index k = 0; k + 1 < growth.keys.size(); ++k) {
        GrowthKey& key = growth.keys[k];
        shapes.at[k] = k;
        shapes.shapes.push_back({nameOf(key), std::move(key.positions), std::move(key.normals)});
    }
    return std::make_shared<const ExportShapes>(std::move(shapes));
}

/// Leaves of the last age are open where nobody plays the file, others closed.
void addLeaves(ExportScene& out, ExportMesh like, const GrowthLeaves& leaves, ExportShapes shapes, Index key,
               const NodeParams& params)
{
    const bool isLast = key + 1 == shapes.at.size();
    like.material = materialIn(out, leavesMaterial(*leaves.foliage, params.leafPictures));
    like.pieces = static_cast<Index>(leaves.foliage->leaves.size());
    like.mesh = leaves.mesh;
    if (isLast) {
        shapes.at.assign(shapes.at.size(), 0);
        shapes.at.back() = noIndex;
        shapes.shapes = {{"closed", leaves.closed, {}}};
    } else {
        shapes.at[key] = 0;
        shapes.shapes = {{"open", leaves.mesh->positions, {}}};
        auto closed = std::make_shared<TriangleMesh>(*leaves.mesh);
        closed->positions = leaves.closed;
        like.mesh = std::move(closed);
    }
    like.shapes = std::make_shared<const ExportShapes>(std::move(shapes));
    out.meshes.push_back(std::move(like));
}

} // namespace

Expected<void> addGrowth(ExportScene& out, Index node, const std::string& suffix, const NodeParams& params,
                         const ExportOptions& options, const Progress& progress)
{
    const GrowthMeshOptions wanted{options.growthFrom, options.growthKeys, options.growthTriangles,
                                   options.texture};
    auto growth = growthMesh(params, wanted, progress.part(0.0, 0.4));
    RAMURE_TRY(growth);
    const ExportShapes times = timesOf(*growth, options);
    std::vector<double> ages;
    for (const GrowthKey& key : growth->keys)
        ages.push_back(key.age);
    if (options.write.tell)
        options.write.tell(
            fail(ErrorCode::Limit,
                 RAMURE_NOOP("%1 key shapes: between two of them no living branch is more than %2 m "
                             "from its place"),
                 {numberText(ages.size()), numberText(std::ceil(100.0 * growth->error) / 100.0)})
                .value());
    ExportMesh bark;
    bark.name = "branches" + suffix;
    bark.node = node;
    if (options.parts & exportBranches) {
        bark.mesh = growth->bark;
        bark.material = materialIn(out, barkMaterial(params.bark, params.barkPictures));
        bark.shapes = barkShapes(*growth, times);
        out.meshes.push_back(bark);
    }
    if (!(options.parts & exportLeaves))
        return {};
    const auto triangles = static_cast<std::int64_t>(leafShare * double(options.growthTriangles));
    const auto leaves = growthLeaves(params, ages, triangles, options.texture, progress.part(0.4, 1.0));
    RAMURE_TRY(leaves);
    ExportMesh like;
    like.node = node;
    for (Index k = 0; k < leaves->size(); ++k)
        if ((*leaves)[k].mesh) {
            like.name = "leaves" + suffix + " " + numberText(std::round(ages[k])) + " years";
            addLeaves(out, like, (*leaves)[k], times, k, params);
        }
    return {};
}

Expected<void> checkGrowthExport(const ExportOptions& options, const FileFormat& format)
{
    if (options.growthFrom == 0.0)
        return {};
    const auto refused = [](const char* text) {
        return fail(Error{ErrorCode::Invalid, text, {}, {}, "growth"});
    };
    if (!(format.holds & holdsShapes))
        return refused(RAMURE_NOOP("this format cannot hold a tree that grows as one mesh"));
    if (options.model != ExportModel::Mesh)
        return refused(RAMURE_NOOP("only the finished mesh can grow as one mesh"));
    if (options.instances || options.variants || options.levels.isWanted() || !options.clip.empty() ||
        options.wind != WindProfile::None)
        return refused(RAMURE_NOOP("a tree that grows as one mesh has no levels, instances, seasons, wind or "
                                   "clip besides"));
    return {};
}

} // namespace ramure
