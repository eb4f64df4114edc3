#include "core/lod/level_skins.h"

#include <algorithm>
#include <limits>

namespace ramure {
namespace {

/// The branch of a run that is nearest to a point.
Index memberAt(const PrunedTree& wood, const Skeleton& tree, Index branch, const glm::dvec3& point)
{
    const std::span<const Index> run = wood.run(branch);
    Index nearest = run.front();
    double least = std::numeric_limits<double>::max();
    for (const Index member : run) {
        if (run.size() == 1)
            break;
        const glm::dvec3 way = tree.p1[member] - tree.p0[member], away = point - tree.p0[member];
        const double square = glm::dot(way, way);
        const double part = square > 0.0 ? std::clamp(glm::dot(away, way) / square, 0.0, 1.0) : 0.0;
        const glm::dvec3 left = away - part * way;
        if (const double distance = glm::dot(left, left); distance < least) {
            least = distance;
            nearest = member;
        }
    }
    return nearest;
}

void append(Skin& skin, Index vertex, const SkinInfluence& influence)
{
    if (skin.runs.empty() || !(skin.runs.back().influence == influence))
        skin.runs.push_back({vertex, influence});
}

/// The skin of the level's own skeleton, told in branches of the tree.
Skin retold(const Skin& own, const TreeLevel& level, const Skeleton& tree)
{
    Skin out;
    out.vertices = own.vertices;
    out.bones = tree.size();
    for (std::size_t r = 0; r < own.runs.size(); ++r) {
        const Index end = r + 1 < own.runs.size() ? own.runs[r + 1].firstVertex : own.vertices;
        for (Index v = own.runs[r].firstVertex; v < end; ++v) {
            SkinInfluence influence = own.runs[r].influence;
            const glm::dvec3 point(level.bark->positions[v]);
            for (Index& bone : influence.bone)
                bone = memberAt(level.wood, tree, bone, point);
            append(out, v, influence);
        }
    }
    return out;
}

/// Each piece of a mesh of equal pieces follows a bone.
template <class BoneOf> Skin pieces(const TriangleMesh& mesh, std::size_t count, const BoneOf& boneOf)
{
    Skin out;
    out.vertices = mesh.vertexCount();
    const Index each = out.vertices / static_cast<Index>(count);
    for (Index i = 0; i < count; ++i) {
        const Index bone = boneOf(i);
        append(out, i * each, {{bone, bone, bone}, {1.0F, 0.0F, 0.0F}});
        out.bones = std::max(out.bones, bone + 1);
    }
    return out;
}

std::shared_ptr<const Skin> shared(Skin skin)
{
    return std::make_shared<const Skin>(std::move(skin));
}

} // namespace

Expected<LevelSkins> bindLevel(const TreeLevel& level, const Skeleton& tree, SkinMethod method,
                               Index firstLeaf)
{
    LevelSkins out;
    if (level.branches) {
        const auto own = bindBranches(*level.branches, level.wood.skeleton, method != SkinMethod::Rigid);
        RAMURE_TRY(own);
        out.bark = shared(retold(*own, level, tree));
    }
    if (level.leaves)
        out.leaves = shared(pieces(*level.leaves, level.leafOf.size(), [&](Index i) {
            return firstLeaf == noIndex ? level.foliage->leaves[i].branch : firstLeaf + level.leafOf[i];
        }));
    if (level.apples)
        out.apples = shared(pieces(*level.apples, level.appleOf.size(),
                                   [&](Index i) { return tree.size() + level.appleOf[i]; }));
    return out;
}

} // namespace ramure
