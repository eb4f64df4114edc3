#include "core/generators/grammar/variety.h"

#include "core/generators/grammar/grammar.h"
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
    const auto grammar = parseGrammar(params.grammar.axiom, params.grammar.rules);
    if (!grammar)
        return false;
    return params.variation != VariationParams{0.0, 0.0, 0.0} ||
           (params.grammar.iterations > 0 && std::ranges::any_of(grammar->rules, chooses));
}

} // namespace ramure
