#include "tests/support/preset_trees.h"

#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/params/presets.h"
#include "core/skeleton/simplify.h"

namespace ramure::test {

Expected<Skeleton> presetSkeleton(const PresetTree& tree)
{
    const Expected<NodeParams> params = presetParams(tree.name);
    if (!params)
        return fail(params.error());
    const Expected<Grammar> grammar = parseGrammar(params->grammar.axiom, params->grammar.rules);
    if (!grammar)
        return fail(grammar.error());
    RewriteOptions options;
    options.iterations = tree.iterations.value_or(static_cast<int>(params->grammar.iterations));
    options.stochastic = tree.stochastic.has_value();
    options.seed = tree.stochastic.value_or(1);
    const Expected<std::string> symbols = rewrite(*grammar, options);
    if (!symbols)
        return fail(symbols.error());
    Expected<Skeleton> skeleton = runTurtle(*symbols, params->turtle);
    if (!skeleton || !tree.simplified)
        return skeleton;
    return simplify(*skeleton, params->simplify.rotationThreshold).skeleton;
}

} // namespace ramure::test
