/// \file
/// Turns parameters into meshes: runs the stages in their order and keeps each result under a hash of its
/// inputs. Nothing has to be marked as changed: undo and redo find their results in the cache.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/params/stage.h"
#include "core/pipeline/texture_stage.h"
#include "core/recipe/edit_report.h"
#include "core/skeleton/sections.h"
#include "core/skeleton/simplify.h"
#include "core/surface/foliage/foliage.h"
#include "core/surface/mesh/deferred_mesh.h"
#include "core/surface/mesher/branch_mesh.h"
#include "core/surface/proof/validate.h"
#include <memory>
#include <string>

namespace ramure {

class EditContext;

/// Results of the stages; those after the one asked for are null. All are immutable and shared.
struct TreeResult
{
    std::shared_ptr<const std::string> symbols; ///< empty where no grammar grows
    std::shared_ptr<const Skeleton> grown;      ///< the result of the generator
    std::shared_ptr<const Skeleton> skeleton;   ///< with the edits of the tree; without any the same as grown
    std::shared_ptr<const EditReport> edits;    ///< what each step did; null: there are no steps
    std::shared_ptr<const EditContext> edited;  ///< the tree for edits behind those; null: there are none
    std::shared_ptr<const SimplifiedSkeleton>
        simplified;                             ///< equal to the skeleton where simplify.enabled is off
    std::shared_ptr<const SectionSet> sections; ///< sections of the simplified skeleton
    std::shared_ptr<const BranchMesh> branches; ///< branch ids refer to the simplified skeleton
    std::shared_ptr<const TriangleMesh> cuts;   ///< cutWood on the branch mesh; null: nothing was cut
    /// Texture of the branch mesh at rest.
    std::shared_ptr<const TextureStage> texture;
    /// Check of the branch mesh; includes OpenMesh's opinion only if wanted.
    std::shared_ptr<const MeshReport> report;
    /// Leaves and fruit before their day; where they have none, the same as foliage.
    std::shared_ptr<const Foliage> placed;
    /// Drafts only, in place of branches and report: open tubes to look at.
    std::shared_ptr<const TriangleMesh> draftTubes;
    std::shared_ptr<const Foliage> foliage;
    DeferredMesh leaves, apples; ///< merged; of a draft of plants' leaves cards
    double sourceSeconds = 0.0;  ///< time that its source took when it grew; 0: not known, or frozen
    double seconds = 0.0;        ///< time this evaluation took, cache hits included
};

/// Most triangles that a branch mesh may have by estimate: twice its cross-sections times their points.
inline constexpr std::size_t maxMeshFaces = 50'000'000;

class TreePipeline
{
public:
    TreePipeline();
    ~TreePipeline();
    TreePipeline(const TreePipeline&) = delete;
    TreePipeline& operator=(const TreePipeline&) = delete;

    /// Runs the stages up to \p last that are not in the cache. Not thread-safe: one pipeline per thread.
    /// Errors: those of checkParams and of the stages, path = the key of the parameter that caused it, if
    /// any; Limit if the mesh would have more than maxMeshFaces (found before memory is taken); Cancelled.
    /// Failures are not cached.
    Expected<TreeResult> evaluate(const NodeParams& params, Stage last = Stage::Foliage,
                                  const Progress& progress = {});
    /// Computes a cheap preview of the same parameters: everything but the mesh and its report. draftTubes
    /// stands in their place, with fewer cross-sections if there are very many branches. If the mesh is in
    /// the cache, the full result is returned. Errors as above.
    Expected<TreeResult> evaluateDraft(const NodeParams& params, const Progress& progress = {});
    /// Most results kept per stage (default 8, at least 1); the oldest go first.
    void setCacheSize(std::size_t perStage);
    /// Most memory kept per stage (default 256 MiB), texture coordinates and cuts included: the oldest
    /// results go first, and the newest always stays.
    void setCacheBudget(std::size_t bytesPerStage);

private:
    struct Cache;
    std::unique_ptr<Cache> m_cache;
};

} // namespace ramure
