/// \file
/// Meshes of one tree for less and less triangles: fewer sides and cross-sections, fewer twigs, fewer and
/// larger leaves. The bark of each is one closed mesh, built and proved as the tree's own is; texture
/// coordinates are in the same tiles and on the same pictures.
#pragma once

#include "core/lod/leaf_sprays.h"
#include "core/lod/level_options.h"
#include "core/lod/level_twigs.h"
#include "core/pipeline/tree_pipeline.h"

namespace ramure {

/// What of a tree its levels hold.
struct LevelParts
{
    bool branches = true, leaves = true, apples = true;
    bool texture = true; ///< with texture coordinates
};

struct TreeLevel
{
    /// The mesh in tree space, at rest; null if there is none. The bark's numbers of branches are those of
    /// the level's own skeleton, those of leaves and fruit the tree's.
    std::shared_ptr<const BranchMesh> branches;
    std::shared_ptr<const TriangleMesh>
        bark; ///< the mesh of the branches, with its texture and the tree's numbers
    std::shared_ptr<const TriangleMesh> leaves, apples;
    /// cutWood on the branches, with the tree's numbers; null: nothing was cut. Its triangles are beside the
    /// budget.
    std::shared_ptr<const TriangleMesh> cuts;
    PrunedTree wood;
    std::shared_ptr<const Foliage> foliage;  ///< what is left of it, enlarged
    std::shared_ptr<const CardAtlas> sprays; ///< whose pictures the leaves show; null: they are leaves
    /// Of the last level, in the place of all other meshes: crossed cards, and what they show. Null: none.
    std::shared_ptr<const TriangleMesh> billboard;
    std::shared_ptr<const CardAtlas> billboardAtlas;
    std::vector<Index> leafOf, appleOf; ///< of each of these its number in the tree's foliage
    double leafScale = 1.0;             ///< by how much the leaves have grown
    double leafArea = 0.0;              ///< m²
    /// m: how large the details are in which it differs from the level before, such as a leaf or the cluster
    /// that it stands for; where that is a pixel, one may take its place. 0: the first level. How alike the
    /// two are there: each pixel is covered by a share of 0..1, as antialiasing shows it; the sum of the
    /// lesser of both over that of the greater (intersection over union of fuzzy sets), the least of several
    /// views round the tree.
    double detail = 0.0;

    [[nodiscard]] std::int64_t triangles() const;
};

/// What treeLevels() needs of the tree.
inline Stage stageOfLevels(const LevelOptions& options)
{
    return options.beginsWhole() ? Stage::Foliage : Stage::Simplified;
}

/// The finest first, as many as the options say, and the billboard after them if they ask for it; each within
/// levelSlack of its budget, its leaves within as much of the area of all. The same parameters and budgets
/// give the same bytes; a level keeps only twigs and leaves that the one before it has. \param tree up to
/// stageOfLevels(), at rest. Errors: those of checkLevels, of the mesher and of foliage; Limit (a budget that
/// this tree cannot keep, with what it can); Invalid (the bark does not pass its proof); Cancelled.
Expected<std::vector<TreeLevel>> treeLevels(const TreeResult& tree, const NodeParams& params,
                                            const LevelOptions& options, const LevelParts& parts = {},
                                            const Progress& progress = {});

} // namespace ramure
