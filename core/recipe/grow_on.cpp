// The tree lives on.
#include "core/recipe/edit_operations.h"

#include "core/generators/grammar/turtle.h"
#include "core/generators/growth/palm.h"
#include "core/generators/growth/standing_wood.h"
#include "core/math/stage_hash.h"
#include "core/params/node_params.h"

namespace ramure::edits {

Expected<void> growOn(EditTree& tree, const TreeEdit& edit, Index /*target*/, Index /*other*/)
{
    const Skeleton standing = tree.skeleton();
    if (!standing.loose.empty())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a tree with a limb that is about to fall cannot grow on"));
    if (tree.axisAt(palmStemAddress) != noIndex)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a palm has no other buds: it gets older by its age"));
    const NodeParams& values = *edit.values;
    if (!(values.step.growOn.years > 0.0))
        return {};
    const std::uint64_t seed = StageHash(tree.seed()).add(edit.id).add(values.step.seed).value();
    const auto later = ramure::growOn(standing, ramure::axesOf(standing), values.growth,
                                      values.step.growOn.years, seed, tree.progress());
    RAMURE_TRY(later);
    if (later->size() > maxBranches)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the step would make more branches than there may be"));
    tree.become(*later, ramure::axesOf(*later), edit.id);
    return {};
}

} // namespace ramure::edits
