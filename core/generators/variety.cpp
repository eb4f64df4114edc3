#include "core/generators/variety.h"

#include "core/generators/grammar/grammar.h"
#include "core/generators/parametric/parametric_grammar.h"
#include "core/params/tree_edit_table.h"
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

bool varies(const WeberPennParams& params)
{
    const auto any = [](const WeberPennLevel& level) {
        return level.lengthV != 0.0 || level.curveV > 0.0 || level.downAngleV > 0.0 || level.rotateV != 0.0 ||
               level.baseSplits > 0 || level.segSplits > 0.0;
    };
    const auto end = params.level.begin() + params.levels;
    return params.scaleV != 0.0 || std::any_of(params.level.begin(), end, any);
}

} // namespace

bool variesByChance(const NodeParams& params)
{
    const auto draws = [](const TreeEdit& step) {
        return step.enabled && std::ranges::any_of(stepParams(step.operation), [](const ParamDef* def) {
                   return (def->flags & paramSeed) != 0;
               });
    };
    if (std::ranges::any_of(params.edits, draws))
        return true;
    if (params.generator.kind == TreeGenerator::Drawn)
        return false;
    if (params.generator.kind == TreeGenerator::Colonisation ||
        params.generator.kind == TreeGenerator::Growth)
        return true;
    if (params.generator.kind == TreeGenerator::WeberPenn)
        return varies(params.weberPenn);
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

NodeParams reseeded(NodeParams params, std::int64_t seed)
{
    if (params.generator.kind == TreeGenerator::Grammar)
        params.grammar.stochastic = true;
    params.grammar.seed = seed;
    params.foliage.seed = seed;
    return params;
}

} // namespace ramure
