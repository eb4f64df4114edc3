#include "core/pipeline/freeze.h"

#include "core/params/tree_edit_table.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/skeleton/packed_skeleton.h"
#include <algorithm>

namespace ramure {

Expected<std::vector<TreeEdit>> frozenBehind(const NodeParams& tree, std::size_t count,
                                             const Progress& progress)
{
    if (count < stepsFrozen(tree.edits))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a step behind it is frozen already"));
    NodeParams lower = tree;
    lower.edits.resize(std::min(count, lower.edits.size()));
    const auto made = TreePipeline().evaluate(lower, Stage::Skeleton, progress);
    RAMURE_TRY(made);
    TreeEdit step = newStep(EditOperation::Frozen);
    step.frozen = SharedValue<FrozenTree>(FrozenTree{packSkeleton(*made->skeleton)});
    step.id = newEditId(tree.edits, step);
    std::vector<TreeEdit> steps = tree.edits;
    steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(lower.edits.size()), std::move(step));
    return steps;
}

} // namespace ramure
