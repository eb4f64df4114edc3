/// \file
/// What of a tree moves in the wind of a game, and how far. A trunk leans as a whole; each limb, with all
/// that grows on it, sways in a rhythm of its own; edges of leaves flutter. How far a place sways grows along
/// the bark without a jump, from nothing at the foot of the trunk, so that no fork tears.
#pragma once

#include "core/base/error.h"
#include "core/skeleton/simplify.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

/// How far a place goes in a wind of strength 1: the top of the tree, of its height; the tip of a branch, of
/// its length, beyond where its foot goes; the edge of a leaf, of the leaf's length.
inline constexpr double trunkSway = 0.1, branchSway = 0.15, leafFlutter = 0.15;
/// Phases are so many steps of a turn: a colour of 8 bits has them exactly.
inline constexpr int phaseSteps = 255;

/// An axis of the tree, from its foot on its parent to its tip.
struct WindStem
{
    Index parent = noIndex;    ///< stands before it; noIndex: a trunk
    Index order = 0;           ///< 0: a trunk
    std::uint64_t address = 0; ///< Axis::address
    glm::dvec3 foot{0.0}, tip{0.0};
    double length = 0.0;   ///< m, along it
    double footSway = 0.0; ///< m, where it starts: as far as its parent there
    double phase = 0.0;    ///< 0 to 1, of its limb: the stem of order 1 that it grows on; of a trunk 0
};

/// Of the simplified skeleton, whose numbers meshes have. Tree space, m.
struct WindTree
{
    std::vector<WindStem> stems;     ///< parents before children
    std::vector<Index> stemOf;       ///< per branch
    std::vector<double> start;       ///< m, per branch: from the foot of its stem
    std::vector<glm::dvec3> p0, p1;  ///< ends of each branch
    double base = 0.0, height = 0.0; ///< m: its lowest foot above the origin, its top above that

    /// m, of a place on a branch or beside it. Rises towards the tips, and never jumps.
    [[nodiscard]] double sway(Index branch, const glm::dvec3& place) const;
    /// m, of a place in the tree: none at its foot.
    [[nodiscard]] double lean(double y) const;
};

/// \param grown before runs were merged: axes have their addresses there. \param tree made of it.
WindTree windTree(const Skeleton& grown, const SimplifiedSkeleton& tree);

/// What a vertex does in the wind.
struct WindVertex
{
    float phase = 0.0F;   ///< of its limb, 0 to 1, k / phaseSteps
    float lean = 0.0F;    ///< m, with the trunk
    float sway = 0.0F;    ///< m, with its limb
    float flutter = 0.0F; ///< m, along its normal: the edges of leaves
    Index element = 0;    ///< core/game_wind/wind_elements.h
};

/// Of bark, and of what a cut lays open. \pre the mesh has a branch per vertex.
std::vector<WindVertex> windOfBark(const WindTree& tree, const TriangleMesh& mesh);
/// Of leaves or fruit: as many vertices each, in the order of the items. They go where their petiole stands.
/// \param flutters leaves do. \pre at least one item
std::vector<WindVertex> windOfItems(const WindTree& tree, const TriangleMesh& mesh,
                                    std::span<const FoliageItem> items, bool flutters);

} // namespace ramure
