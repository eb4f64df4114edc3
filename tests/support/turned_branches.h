/// \file
/// Branches that are turned and rolled by hand, as steps of a recipe.
#pragma once

#include "core/params/tree_edit_table.h"
#include "core/pipeline/separate_branches.h"
#include "core/pipeline/tree_context.h"
#include "core/skeleton/branch_steps.h"
#include <map>

namespace ramure::test {

/// Steps without ids that turn branches of the simplified skeleton about their starts.
inline std::vector<TreeEdit> bends(const TreeResult& tree, const NodeParams& params,
                                   const std::map<Index, glm::dvec3>& bendRad)
{
    std::vector<glm::dvec3> all(tree.simplified->skeleton.size(), glm::dvec3(0.0));
    for (const auto& [branch, bend] : bendRad)
        all[branch] = bend;
    const EditContext context = contextOf(tree, params);
    std::vector<TreeEdit> steps;
    for (TreeEdit& step : bendSteps(axesOf(*tree.skeleton), *tree.simplified, all))
        steps.push_back(*context.prepared(std::move(step), true));
    return steps;
}

/// A step without an id that rolls a branch of the simplified skeleton.
inline TreeEdit roll(const TreeResult& tree, const NodeParams& params, Index branch, double rollRad)
{
    const BranchStart start = branchStart(axesOf(*tree.skeleton), *tree.simplified, branch);
    TreeEdit step;
    step.operation = EditOperation::Roll;
    step.target.address = start.address;
    step.from = start.share;
    step.angleRad = rollRad;
    return *contextOf(tree, params).prepared(std::move(step), true);
}

} // namespace ramure::test
