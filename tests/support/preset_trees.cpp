#include "tests/support/preset_trees.h"

#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/generators/parametric/module_turtle.h"
#include "core/presets/presets.h"
#include "core/skeleton/simplify.h"

namespace ramure::test {
namespace {

Expected<Skeleton> moduleSkeleton(const NodeParams& params, const PresetTree& tree)
{
    const auto grammar = parseParametric(params.grammar);
    if (!grammar)
        return fail(grammar.error());
    const auto word = derive(*grammar, {tree.iterations.value_or(static_cast<int>(params.grammar.iterations)),
                                        tree.stochastic.has_value(), tree.stochastic.value_or(1)});
    if (!word)
        return fail(word.error());
    auto skeleton = runModuleTurtle(*word, params.turtle, {{0.0, 0.0, 0.0}, 1});
    if (!skeleton || !tree.simplified)
        return skeleton;
    return simplify(*skeleton, params.simplify.rotationThreshold).skeleton;
}

} // namespace

Expected<Skeleton> presetSkeleton(const PresetTree& tree)
{
    const Expected<NodeParams> params = presetParams(tree.name);
    if (!params)
        return fail(params.error());
    if (params->grammar.dialect == GrammarDialect::Parametric)
        return moduleSkeleton(*params, tree);
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
