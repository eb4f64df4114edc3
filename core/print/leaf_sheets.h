/// \file
/// The leaves of a tree at the size of a print: open sheets that become shells, each with a stalk that ends
/// inside of what is printed of the tree.
#pragma once

#include "core/print/print_skeleton.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

struct LeafSheets
{
    TriangleMesh mesh;        ///< m of the print; stalks are triangles without area
    Index leaves = 0;         ///< in it
    Index leftOut = 0;        ///< of the tree's
    double enlargement = 1.0; ///< of each
};

/// A leaf that would be smaller than leastLeafLength thicknesses is drawn so large, and there are fewer, so
/// that the crown has as much leaf as before.
inline constexpr double leastLeafLength = 4.0;
/// How far, in lengths of a leaf, its stalk may go where its own twig was cut. Farther ones are left out.
inline constexpr double mostStalk = 1.0;

struct LeafLimits
{
    double thickness = 0.0; ///< m, of the shells
    double area = 0.0; ///< m², about the most that all shells together may have: more leave some leaves out
};

/// \param foliage of the tree that \p print was made of. \param alpha m, of the tree: trunkRadius().
/// Where some are left out, it is the same part everywhere. The same leaves whenever called.
LeafSheets leafSheets(const Foliage& foliage, const Skeleton& tree, const PrintSkeleton& print, double alpha,
                      const LeafLimits& limits);

} // namespace ramure
