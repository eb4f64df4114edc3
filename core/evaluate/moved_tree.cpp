// A whole tree in one motion, for files and pictures.
#include "core/evaluate/tree_run.h"

#include "core/surface/proof/validate.h"
#include <utility>

namespace ramure {
namespace {

/// Moves one end of each branch with its bone.
Skeleton movedSkeleton(const Skeleton& rest, std::span<const RigidTransform> bones,
                       std::span<const Index> boneOf)
{
    Skeleton now = rest;
    for (Index b = 0; b < rest.size(); ++b) {
        const RigidTransform& bone = bones[boneOf.empty() ? b : boneOf[b]];
        now.p0[b] = bone.point(rest.p0[b]);
        now.p1[b] = bone.point(rest.p1[b]);
    }
    return now;
}

SectionSet movedSections(const SectionSet& rest, std::span<const RigidTransform> bones)
{
    SectionSet now = rest;
    for (std::size_t i = 0; i < now.sections.size(); ++i) {
        const RigidTransform& bone = bones[i / rest.perBranch];
        CrossSection& section = now.sections[i];
        section.centre = bone.point(section.centre);
        section.frame = {bone.direction(section.frame.tangent), bone.direction(section.frame.normal),
                         bone.direction(section.frame.binormal)};
    }
    return now;
}

Foliage movedFoliage(const Foliage& rest, const NodeMotion& motion)
{
    Foliage now = rest;
    const std::vector<RigidTransform>& bones = *motion.bones;
    const auto move = [](FoliageItem& item, const RigidTransform& bone) {
        item.position = bone.point(item.position);
        item.orientation = bone.rotation * item.orientation;
    };
    const std::size_t leaves = motion.firstLeaf == noIndex ? bones.size() : motion.firstLeaf;
    for (std::size_t i = 0; i < now.apples.size();
         ++i) // each has a bone of its own, and may lie on the ground
        move(now.apples[i], bones[leaves - now.apples.size() + i]);
    for (std::size_t i = 0; i < now.leaves.size(); ++i)
        move(now.leaves[i], bones[motion.firstLeaf == noIndex ? now.leaves[i].branch : motion.firstLeaf + i]);
    return now;
}

/// Null stays null.
DeferredMesh movedPiece(const DeferredMesh& mesh, const std::shared_ptr<const Skin>& skin,
                        const NodeMotion& motion)
{
    if (!mesh)
        return {};
    return std::make_shared<const TriangleMesh>(deformed(*mesh, *skin, *motion.bones, motion.method));
}

/// The meshes of a result and its report, deformed.
Expected<void> moveMeshes(TreeResult& tree, const NodeMotion& motion, const Progress& progress)
{
    auto moved = std::make_shared<BranchMesh>(*tree.branches);
    moved->mesh = deformed(tree.branches->mesh, *motion.branches, *motion.bones, motion.method);
    if (tree.report) {
        auto report = validateMesh(moved->mesh, progress);
        RAMURE_TRY(report);
        tree.report = std::make_shared<const MeshReport>(std::move(*report));
    }
    tree.branches = std::move(moved);
    if (tree.cuts)
        tree.cuts = std::make_shared<const TriangleMesh>(
            deformed(*tree.cuts, bindRigidly(*tree.cuts), *motion.bones, SkinMethod::Rigid));
    tree.leaves = movedPiece(tree.leaves, motion.leaves, motion);
    tree.apples = movedPiece(tree.apples, motion.apples, motion);
    return {};
}

} // namespace

Expected<TreeResult> movedTree(TreeResult tree, const NodeMotion& motion, const Progress& progress)
{
    const std::span<const RigidTransform> bones = *motion.bones;
    RAMURE_TRY(moveMeshes(tree, motion, progress));
    if (tree.skeleton)
        tree.skeleton = std::make_shared<const Skeleton>(
            movedSkeleton(*tree.skeleton, bones, tree.simplified->mergedInto));
    auto simplified = std::make_shared<SimplifiedSkeleton>(*tree.simplified);
    simplified->skeleton = movedSkeleton(tree.simplified->skeleton, bones, {});
    tree.simplified = std::move(simplified);
    if (tree.sections)
        tree.sections = std::make_shared<const SectionSet>(movedSections(*tree.sections, bones));
    if (tree.foliage)
        tree.foliage = std::make_shared<const Foliage>(movedFoliage(*tree.foliage, motion));
    return tree;
}

} // namespace ramure
