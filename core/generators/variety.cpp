#include "core/generators/variety.h"

#include "core/generators/grammar/grammar.h"
#include "core/generators/parametric/parametric_grammar.h"
#include <algorithm>

namespace ramure {
namespace {

bool chooses(const Rule& rule)
{
    const std::string* outcome = nullptr;
    for (std::size_t i = 0; i < rule.probabilities.size(); ++i) {
        if (rule.probabilities[i] <= 0.0)
            continue;
        if (outcome && *outcome != rule.replacements[i])
            return true;
        outcome = &rule.replacements[i];
    }
    return false;
}

} // namespace

bool variesByChance(const NodeParams& params)
{
    if (params.grammar.dialect == GrammarDialect::Parametric) {
        const auto grammar = parseParametric(params.grammar);
        const bool varies = params.variation.angle != 0.0 || params.variation.length != 0.0;
        return grammar && (varies || (params.grammar.iterations > 0 && grammar->usesChance));
    }
    const auto grammar = parseGrammar(params.grammar.axiom, params.grammar.rules);
    if (!grammar)
        return false;
    return params.variation != VariationParams{0.0, 0.0, 0.0} ||
           (params.grammar.iterations > 0 && std::ranges::any_of(grammar->rules, chooses));
}

} // namespace ramure
