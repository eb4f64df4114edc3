/// \file
/// What the background thread computes, as functions: the recompute object knows when, these know what. Tests
/// put slow, counted or failing ones in their place.
#pragma once

#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/surface/proof/validate.h"
#include <functional>

namespace ramure {

/// Called on the background thread only, one at a time.
struct Evaluation
{
    /// All stages of one tree.
    std::function<Expected<TreeResult>(const NodeParams& params, const Progress& progress)> evaluate;
    /// A cheap picture of it; one with a report is the full result.
    std::function<Expected<TreeResult>(const NodeParams& params, const Progress& progress)> draft;
    /// The second opinion on a mesh that has its report. Empty: none is asked for.
    std::function<Expected<void>(const TriangleMesh& mesh, MeshReport& report, const Progress& progress)>
        confirm;
    /// How many trees there are, so that none pushes another one out of the cache. May be empty.
    std::function<void(std::size_t trees)> prepare;
};

/// A TreePipeline of its own, and OpenMesh.
Evaluation treeEvaluation();

} // namespace ramure
