/// \file
/// The check of meshes that `validate` prints and `export` writes beside its files or insists on.
#pragma once

#include "app/cli/input.h"
#include "core/mesh/mesh_analysis.h"
#include "core/mesh/texture_report.h"
#include <QJsonObject>
#include <optional>
#include <vector>

namespace ramure::cli {

/// One tree's branches before its placement, or a file's objects together.
struct CheckedMesh
{
    std::string name; ///< of the tree; empty for a file
    MeshReport report;
    MeshAnalysis analysis;                ///< without crossings unless they were asked for
    std::optional<TextureReport> texture; ///< of a tree, if it was asked for
    BudgetFit budget = BudgetFit::NotAsked;
    Index targetTriangles = 0; ///< of a tree, as its parameters say; 0 = none
};

/// Is the mesh closed, manifold and oriented, does OpenMesh agree, and has a tree as many pieces as roots;
/// its quality and its hash. \p crossings: also which triangles run through each other.
/// \param source gives the trees. \param hidden trees that are not shown, too. \param texture also how the
/// texture coordinates of trees fit.
/// Errors: those of the trees; Cancelled.
Expected<std::vector<CheckedMesh>> checkMeshes(const Input& input, const TreeSource& source, bool crossings,
                                               bool hidden, const Progress& progress, bool texture = false);

/// Moves colliding branches of all trees apart (core/pipeline/separate_branches.h); says on the standard
/// error how far it came. Errors: Invalid for a mesh file; those of separateBranches.
Expected<void> separateTrees(Input& input, TreePipeline& pipeline, const Progress& progress);

/// All figures added up; valid where all are.
MeshReport sumOf(const std::vector<CheckedMesh>& all);
/// Of one mesh its object; of several the sums, and "trees".
QJsonObject jsonOf(const std::vector<CheckedMesh>& all, bool crossings);

} // namespace ramure::cli
