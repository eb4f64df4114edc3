#include "core/generators/variety.h"

#include "core/generators/sources.h"
#include "core/params/tree_edit_table.h"
#include <algorithm>

namespace ramure {

bool variesByChance(const NodeParams& params)
{
    const auto draws = [](const TreeEdit& step) {
        return step.enabled && std::ranges::any_of(stepParams(step.operation), [](const ParamDef* def) {
                   return (def->flags & paramSeed) != 0;
               });
    };
    return std::ranges::any_of(params.edits, draws) || sourceOf(params).varies(params);
}

NodeParams reseeded(NodeParams params, std::int64_t seed)
{
    if (params.generator.kind == EditOperation::Grammar)
        params.grammar.stochastic = true;
    params.grammar.seed = seed;
    params.foliage.seed = seed;
    return params;
}

} // namespace ramure
