#include "core/lod/growth_leaves.h"

#include "core/lod/tree_levels.h"
#include "core/surface/foliage/foliage_texture.h"

namespace ramure {
namespace {

/// All leaves of a tree, or as many as the triangles allow.
Expected<GrowthLeaves> leavesOf(const TreeResult& tree, const NodeParams& params, std::int64_t triangles,
                                bool texture, const Progress& progress)
{
    GrowthLeaves out;
    if (!tree.leaves || tree.leaves->empty())
        return out;
    if (tree.leaves->faceCount() <= triangles) {
        TriangleMesh leaves = *tree.leaves;
        if (texture)
            addLeafTexture(leaves, tree.foliage->form);
        out.mesh = std::make_shared<const TriangleMesh>(std::move(leaves));
        out.foliage = tree.foliage;
        return out;
    }
    LevelOptions one;
    one.count = 1;
    one.budgets = {triangles};
    const auto levels = treeLevels(tree, params, one, {false, true, false, texture}, progress);
    if (!levels && levels.error().code == ErrorCode::Limit && triangles > 2 * leastBudget)
        return leavesOf(tree, params, triangles / 2, texture, progress); // its shapes leave a gap there
    RAMURE_TRY(levels);
    out.mesh = levels->front().leaves;
    out.foliage = levels->front().foliage;
    return out;
}

/// All vertices of a leaf where it stands.
void close(GrowthLeaves& leaves)
{
    if (!leaves.mesh)
        return;
    const std::size_t each = leaves.mesh->positions.size() / leaves.foliage->leaves.size();
    for (std::size_t v = 0; v < leaves.mesh->positions.size(); ++v)
        leaves.closed.emplace_back(leaves.foliage->leaves[v / each].position);
}

} // namespace

Expected<std::vector<GrowthLeaves>> growthLeaves(const NodeParams& params, std::span<const double> ages,
                                                 std::int64_t triangles, bool texture,
                                                 const Progress& progress)
{
    TreePipeline pipeline;
    std::vector<GrowthLeaves> out;
    for (const double age : ages) {
        const double done = double(out.size()) / double(ages.size());
        const Progress part = progress.part(done, done + 1.0 / double(ages.size()));
        NodeParams then = params;
        then.growth.age = age;
        const auto tree = pipeline.evaluate(then, Stage::Foliage, part);
        RAMURE_TRY(tree);
        auto leaves = leavesOf(*tree, then, triangles, texture, part);
        RAMURE_TRY(leaves);
        close(*leaves);
        out.push_back(std::move(*leaves));
    }
    return out;
}

} // namespace ramure
