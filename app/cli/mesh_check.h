/// \file
/// The check of meshes that `validate` prints and `export` writes beside its files or insists on.
#pragma once

#include "app/cli/input.h"
#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/check/texture_report.h"
#include "core/surface/check/verdict.h"
#include <QJsonObject>
#include <functional>
#include <optional>
#include <vector>

namespace ramure::cli {

/// One tree's branches or one other node's mesh, in its own space or where it stands in the world
/// (MeshChecks::placed); or a file's objects together.
struct CheckedMesh
{
    std::string name; ///< name of the node; empty for a file
    MeshReport report;
    MeshAnalysis analysis;                ///< without crossings unless they were asked for
    std::optional<TextureReport> texture; ///< only for a tree, and only if it was asked for
    BudgetFit budget = BudgetFit::NotAsked;
    Index targetTriangles = 0; ///< triangle budget in a tree's parameters; 0 = none
    NodeKind kind = NodeKind::Tree;
    bool isOpen = false; ///< a terrain or a plane: valid with a boundary
    /// Valid in its own space, but not where it stands (MeshChecks::placed).
    bool isSpoiltByPlace = false;
    bool crossingsKnown = false; ///< MeshChecks::crossings

    [[nodiscard]] MeshVerdict verdict() const
    {
        return verdictOn(report, crossingsKnown ? &analysis.crossings : nullptr);
    }
};

struct MeshChecks
{
    double timeSeconds = 0.0;
    bool crossings = false; ///< also which triangles run through each other
    bool hidden = false;    ///< nodes that are not shown, too
    bool texture = false;   ///< also how the texture coordinates of trees fit
    /// The meshes where they stand in the world, as they are exported: far from its origin, numbers of single
    /// precision bring vertices together. Crossings are those before the placement, at their place in the
    /// world; depths are metres of the node itself.
    bool placed = false;
};

/// Checks whether each mesh is closed, manifold and oriented, whether OpenMesh agrees, and whether a tree has
/// as many pieces as roots. Adds its quality and its hash. Open surfaces (isOpenSurface) may have a boundary.
/// Errors: those of EvaluatedScene; Cancelled.
Expected<std::vector<CheckedMesh>> checkMeshes(const Input& input, Evaluator& evaluator,
                                               const MeshChecks& checks, const Progress& progress);

/// Checks the bark of all trees in a scene that is about to be written, level by level and in its place.
/// Errors: those of checkMesh.
Expected<std::vector<CheckedMesh>> checkBarks(const ExportScene& scene);

/// Moves colliding branches of all trees apart (core/pipeline/separate_branches.h) and tells the result.
/// Errors: Invalid for a mesh file; those of separateBranches.
Expected<void> separateTrees(Input& input, TreePipeline& pipeline, const Progress& progress,
                             const std::function<void(const Error&)>& tell = &printNote);

/// All figures added up; valid where all are.
MeshReport sumOf(const std::vector<CheckedMesh>& all);
/// The worst of them.
MeshVerdict verdictOn(const std::vector<CheckedMesh>& all);
/// "closed, but 26 pairs of triangles run through each other".
QString verdictText(MeshVerdict verdict, std::uint64_t crossings);
std::uint64_t crossingsOf(const std::vector<CheckedMesh>& all);
/// Are these trees alone, or a file?
bool isOfTrees(const std::vector<CheckedMesh>& all);
/// Returns the object of one mesh. For several it returns the sums, and "trees", or "nodes" if not all are
/// trees.
QJsonObject jsonOf(const std::vector<CheckedMesh>& all, bool crossings);

} // namespace ramure::cli
