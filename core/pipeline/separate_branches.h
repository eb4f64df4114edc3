/// \file
/// Moves branches that collide apart (SPEC A9). From each pair the thinner one, or its parent, is turned
/// about its start, as little as possible. Its twigs follow, and lengths stay.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/surface/check/mesh_analysis.h"
#include <span>
#include <vector>

namespace ramure {

struct SeparateOptions
{
    int rounds = 12;          ///< at most so many meshes are built and looked at
    double clearance = 0.15;  ///< free space between two branches, as a share of their added radii
    double mostTurnRad = 0.7; ///< most turn of one branch in one round
    unsigned threads = 0;     ///< threads that search for crossings; their number does not change the result
};

struct Separation
{
    std::vector<TreeEdit> steps; ///< bends, for the end of the recipe; without ids
    std::size_t before = 0;      ///< pairs of branches that collided
    std::vector<Collision> rest; ///< and still do; never more than before
};

/// Turns branches, builds the mesh and searches for crossings again, as long as this improves the tree: fewer
/// pairs, no more crossings at forks than before, and a valid mesh. A round that made things worse is taken
/// back in part or as a whole. Errors: those of the pipeline and of analyseMesh; Cancelled.
Expected<Separation> separateBranches(TreePipeline& pipeline, const NodeParams& params,
                                      const SeparateOptions& options = {}, const Progress& progress = {});

/// The parameters with these steps, which need no ids, at the end of the recipe.
NodeParams withSteps(NodeParams params, std::span<const TreeEdit> steps);

} // namespace ramure
