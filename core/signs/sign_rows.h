/// \file
/// The measures behind the table of signs, some at a time. Internal to the signs.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/signs/tree_signs.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/mesher/branch_mesh.h"
#include <string_view>

namespace ramure::signs {

using Rows = std::vector<TreeSign>;

/// A sign whose value is known, against its band.
TreeSign measured(TreeSign sign, double value);
TreeSign absent(TreeSign sign, std::string note);

/// Collars of limbs, twins, the flare of the foot and its lobes.
void addWood(Rows& rows, const BranchMesh& mesh, const NodeParams& params);
/// Tips under their weight, as the step "sag" lets them drop, against the formula of a beam. \param tree as
/// grown
Expected<void> addSag(Rows& rows, const Skeleton& tree, const NodeParams& params, const Progress& progress);
/// The balance of the crown, its answer to light from one side, a stem that leaned, and shoots at cuts. Of
/// trees that do not grow by years all are not modelled.
Expected<void> addGrowth(Rows& rows, const NodeParams& params, std::string_view latin,
                         const Progress& progress);

/// The spread of the blades of a shoot, how leaves differ in lightness and hue, and how much of the sky the
/// crown leaves free for its leaf area. Absent of trees without leaves of a plant.
Expected<void> addFoliage(Rows& rows, const NodeParams& params, TreePipeline& pipeline,
                          const Progress& progress);

} // namespace ramure::signs
