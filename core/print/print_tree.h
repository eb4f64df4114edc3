/// \file
/// From a tree to a mesh that a printer takes: thick enough, one piece without crossings, flat at the ground.
#pragma once

#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/print/print_options.h"
#include "core/print/print_report.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

struct PrintedTree
{
    std::shared_ptr<const TriangleMesh> mesh; ///< m at the print's size, Y up, on y = 0
    PrintReport report;
    double scale = 1.0;           ///< size of the print relative to the tree
    Index thickened = 0, cut = 0; ///< branches
    Index loose = 0;              ///< pieces that came off and were left out
    /// Counts of leaf shells, if there are any, and of the tree's leaves without one.
    Index leaves = 0, leavesLeftOut = 0;
};

/// Makes a printable tree; fruit is left out. \param foliage null: leaves are left out, too \param tree m,
/// simplified by the pipeline \param params of its mesh: its budget counts if it is below that of the
/// options. Each call gives the same bytes. Errors: those of checkPrint, printSkeleton, buildBranchMesh and
/// unitedSurface; Invalid (crossings that could not be removed); Cancelled.
Expected<PrintedTree> printTree(const Skeleton& tree, const NodeParams& params, const PrintOptions& options,
                                const Progress& progress = {}, const Foliage* foliage = nullptr);

} // namespace ramure
