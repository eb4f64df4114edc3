#include "core/pipeline/tree_context.h"

namespace ramure {

EditContext contextOf(const TreeResult& tree, const NodeParams& params)
{
    auto known = tree.edited ? tree.edited->upTo(params.edits) : std::nullopt;
    return known ? std::move(*known) : EditContext(*tree.grown, params.edits, nullptr, treeSeed(params));
}

} // namespace ramure
