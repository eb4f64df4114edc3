#include "core/skeleton/branch_steps.h"

namespace ramure {

BranchStart branchStart(const TreeAxes& drawn, const SimplifiedSkeleton& simplified, Index branch)
{
    const Index piece = simplified.skeleton.source[branch];
    const Axis& axis = drawn.axes[drawn.axisOf[piece]];
    return {axis.address, axis.length > 0.0 ? drawn.start[piece] / axis.length : 0.0};
}

std::vector<TreeEdit> bendSteps(const TreeAxes& drawn, const SimplifiedSkeleton& simplified,
                                std::span<const glm::dvec3> bendRad)
{
    constexpr double tip = 1.0 - 1e-9; // nothing is above it
    std::vector<TreeEdit> steps;
    for (auto branch = static_cast<Index>(bendRad.size()); branch-- > 0;) { // children stand behind parents
        const BranchStart start = branchStart(drawn, simplified, branch);
        if (bendRad[branch] == glm::dvec3(0.0) || start.share >= tip)
            continue;
        TreeEdit step;
        step.operation = EditOperation::Bend;
        step.target.address = start.address;
        step.from = start.share;
        step.to = start.share;
        step.rotation = bendRad[branch];
        steps.push_back(std::move(step));
    }
    return steps;
}

} // namespace ramure
