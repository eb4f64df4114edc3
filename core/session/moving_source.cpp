#include "core/session/moving_source.h"

#include "core/rig/physics/physics_cache.h"
#include "core/rig/physics/pose_blend.h"
#include "core/rig/pose/skin.h"
#include "core/scene/loop_blend.h"
#include "core/rig/physics/animated_physics.h"

#include <algorithm>
#include <cmath>

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

Foliage movedFoliage(const Foliage& rest, std::span<const RigidTransform> bones)
{
    Foliage now = rest;
    for (std::vector<FoliageItem>* items : {&now.leaves, &now.apples})
        for (FoliageItem& item : *items) {
            const RigidTransform& bone = bones[item.branch];
            item.position = bone.point(item.position);
            item.orientation = bone.rotation * item.orientation;
        }
    return now;
}

} // namespace

struct MovingSource::Run
{
    struct Bound
    {
        std::shared_ptr<const void> mesh;
        bool smooth = false;
        Skin skin;
    };
    /// Binds a mesh once for all frames.
    template <class Bind>
    Expected<const Skin*> skinOf(Bound& bound, const std::shared_ptr<const void>& mesh, bool smooth,
                                 const Bind& bind)
    {
        if (bound.mesh == mesh && bound.smooth == smooth)
            return &bound.skin;
        auto skin = bind();
        if (!skin)
            return fail(std::move(skin.error()));
        bound = {mesh, smooth, std::move(*skin)};
        return &bound.skin;
    }
    Expected<void> moveMeshes(TreeResult& tree, const Foliage& foliage, SkinMethod method,
                              const Progress& progress);
    Expected<void> poseAt(double timeSeconds, const LoopBlend& blend, const Progress& progress);

    Bound branches, leaves, apples;
    std::shared_ptr<const SimplifiedSkeleton> skeleton;
    std::unique_ptr<PhysicsCache> cache;
    Pose pose, earlier;
    std::int64_t scripted = -1; ///< steps whose animated parameters the run has been told
};

MovingSource::MovingSource(TreeSource rest, const TimelineSettings& timeline)
    : m_rest(std::move(rest))
    , m_timeline(timeline)
    , m_arms(timeline)
{
}

MovingSource::~MovingSource() = default;

TreeSource MovingSource::at(double timeSeconds)
{
    return [this, timeSeconds](const Node& node, Stage last, const Progress& progress) {
        const auto make = [&](const Node& now) {
            return timeSeconds <= 0.0 ? m_rest(now, last, progress) : moved(now, last, timeSeconds, progress);
        };
        if (!node.animation.movesParams())
            return make(node);
        Node now = node;
        now.params = paramsAt(node.params, node.animation, timeSeconds);
        return make(now);
    };
}

/// The meshes of a result and its report, deformed.
Expected<void> MovingSource::Run::moveMeshes(TreeResult& tree, const Foliage& foliage, SkinMethod method,
                                             const Progress& progress)
{
    const bool smooth = method != SkinMethod::Rigid;
    const Skeleton& rest = skeleton->skeleton;
    const std::span<const RigidTransform> bones = pose.bones;
    const std::shared_ptr<const BranchMesh> restMesh = tree.branches;
    const auto skin =
        skinOf(branches, restMesh, smooth, [&] { return bindBranches(*restMesh, rest, smooth); });
    if (!skin)
        return fail(skin.error());
    auto moved = std::make_shared<BranchMesh>(*restMesh);
    moved->mesh = deformed(restMesh->mesh, **skin, bones, method);
    if (tree.report) {
        auto report = validateMesh(moved->mesh, progress);
        if (!report)
            return fail(std::move(report.error()));
        tree.report = std::make_shared<const MeshReport>(std::move(*report));
    }
    tree.branches = std::move(moved);
    tree.restBranches = restMesh;
    struct Piece
    {
        std::shared_ptr<const TriangleMesh>* mesh;
        const std::vector<FoliageItem>* items;
        Bound* bound;
    };
    for (const Piece& piece :
         {Piece{&tree.leaves, &foliage.leaves, &leaves}, Piece{&tree.apples, &foliage.apples, &apples}}) {
        const std::shared_ptr<const TriangleMesh> mesh = *piece.mesh;
        if (!mesh)
            continue;
        const auto pieceSkin = skinOf(*piece.bound, mesh, smooth, [&] {
            return bindFoliage(*mesh, *piece.items, *restMesh, rest, smooth);
        });
        if (!pieceSkin)
            return fail(pieceSkin.error());
        *piece.mesh = std::make_shared<const TriangleMesh>(deformed(*mesh, **pieceSkin, bones, method));
    }
    return {};
}

/// In the seam of a loop the run goes back for the pose of the round before.
Expected<void> MovingSource::Run::poseAt(double timeSeconds, const LoopBlend& blend, const Progress& progress)
{
    if (blend.weight > 0.0) {
        if (auto there = cache->seek(cache->stepAt(blend.earlierSeconds), progress.part(0.0, 0.5)); !there)
            return there;
        cache->pose(earlier);
    }
    if (auto there = cache->seek(cache->stepAt(timeSeconds), progress.part(0.5, 1.0)); !there)
        return there;
    cache->pose(pose);
    if (blend.weight > 0.0)
        blendPose(cache->physics().body(), earlier, blend.weight, pose);
    return {};
}

Expected<TreeResult> MovingSource::moved(const Node& node, Stage last, double timeSeconds,
                                         const Progress& progress)
{
    // Apples weigh: they must be known even where nobody asked for them.
    auto tree = m_rest(node, std::max(last, Stage::Foliage), progress.part(0.0, 0.4));
    if (!tree)
        return tree;
    std::unique_ptr<Run>& run = m_runs[node.id];
    if (!run || run->skeleton != tree->simplified) {
        run = std::make_unique<Run>();
        run->skeleton = tree->simplified;
        run->cache = std::make_unique<PhysicsCache>(
            makeTreeBody(tree->simplified->skeleton, tree->foliage.get(), node.params.turtle.alpha),
            node.params.physics);
    }
    if (!std::isfinite(timeSeconds) || timeSeconds > run->cache->timeAt(maxPhysicsSteps))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the time lies beyond what the physics counts"));
    const std::int64_t step = run->cache->stepAt(timeSeconds);
    if (movesPhysics(node.animation)) {
        scriptSteps(*run->cache, node.params.physics, node.animation, run->scripted + 1, step);
        run->scripted = std::max(run->scripted, step);
    }
    if (auto there = run->poseAt(timeSeconds, loopBlend(m_timeline, timeSeconds), progress.part(0.4, 0.9));
        !there)
        return fail(std::move(there.error()));
    const std::span<const RigidTransform> bones = run->pose.bones;
    const std::shared_ptr<const Foliage> foliage = tree->foliage;
    if (tree->branches)
        if (auto done = run->moveMeshes(*tree, *foliage, node.params.skin.method, progress.part(0.9, 1.0));
            !done)
            return fail(std::move(done.error()));
    if (tree->skeleton)
        tree->skeleton = std::make_shared<const Skeleton>(
            movedSkeleton(*tree->skeleton, bones, run->skeleton->mergedInto));
    auto simplified = std::make_shared<SimplifiedSkeleton>(*run->skeleton);
    simplified->skeleton = movedSkeleton(run->skeleton->skeleton, bones, {});
    tree->simplified = std::move(simplified);
    if (tree->sections)
        tree->sections = std::make_shared<const SectionSet>(movedSections(*tree->sections, bones));
    tree->foliage = std::make_shared<const Foliage>(movedFoliage(*foliage, bones));
    return tree;
}

} // namespace ramure
