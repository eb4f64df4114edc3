/// \file
/// Steps of a recipe that turn single branches of the simplified skeleton: what inverse kinematics and the
/// treatment of collisions make.
#pragma once

#include "core/params/tree_edit.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/simplify.h"
#include <span>
#include <vector>

namespace ramure {

/// Where a branch begins on its axis.
struct BranchStart
{
    std::uint64_t address = 0; ///< address of the axis
    double share = 0.0;        ///< share of the axis's length
};
/// \param drawn axes of the skeleton that \p simplified was made of. \param branch of \p simplified
BranchStart branchStart(const TreeAxes& drawn, const SimplifiedSkeleton& simplified, Index branch);

/// Bend steps that turn branches about their starts. Each step's rotation refers to the tree before any of
/// these steps, in tree space (EditContext::prepared), and the steps stand in the order in which they must
/// act: those of tips first. \param bendRad one per branch of \p simplified, axis times angle in tree space,
/// each before the bends of the branches below it. Branches that do not turn, or are too short to be named,
/// have no step.
std::vector<TreeEdit> bendSteps(const TreeAxes& drawn, const SimplifiedSkeleton& simplified,
                                std::span<const glm::dvec3> bendRad);

} // namespace ramure
