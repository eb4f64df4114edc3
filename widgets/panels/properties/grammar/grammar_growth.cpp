#include "widgets/panels/properties/grammar/grammar_growth.h"

#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include <algorithm>
#include <array>

namespace ramure {
namespace {

using Counts = std::array<double, 256>;

Counts countsOf(const std::string& text)
{
    Counts counts{};
    for (const char symbol : text)
        ++counts[static_cast<unsigned char>(symbol)];
    return counts;
}

double sum(const Counts& counts)
{
    double all = 0.0;
    for (const double count : counts)
        all += count;
    return all;
}

/// How many of each symbol the next generation has, without chance.
Counts nextCounts(const Grammar& grammar, const Counts& counts)
{
    Counts next = counts;
    for (const Rule& rule : grammar.rules)
        next[static_cast<unsigned char>(rule.symbol)] -= counts[static_cast<unsigned char>(rule.symbol)];
    for (const Rule& rule : grammar.rules) {
        const double times = counts[static_cast<unsigned char>(rule.symbol)];
        const Counts made = countsOf(rule.defaultText);
        for (std::size_t symbol = 0; symbol < made.size(); ++symbol)
            next[symbol] += times * made[symbol];
    }
    return next;
}

Expected<std::vector<Generation>> modulesOf(const GrammarParams& params, int last)
{
    const auto grammar = parseParametric(params);
    RAMURE_TRY(grammar);
    std::vector<Generation> generations;
    for (int i = 0; i <= last; ++i) {
        auto word = derive(
            *grammar, {i, params.stochastic, static_cast<std::uint64_t>(params.seed), longestGeneration});
        if (!word && word.error().code != ErrorCode::Limit)
            break;
        Generation& generation = generations.emplace_back();
        generation.atLeast = !word;
        generation.symbols = static_cast<double>(word ? word->modules.size() : longestGeneration);
        if (!word)
            break;
        generation.text = lettersOf(*word);
        generation.word = std::move(*word);
    }
    return generations;
}

} // namespace

Expected<std::vector<Generation>> generationsOf(const GrammarParams& params)
{
    const auto last = static_cast<int>(std::clamp<std::int64_t>(params.iterations, 0, mostGenerations));
    if (params.dialect == GrammarDialect::Parametric)
        return modulesOf(params, last);
    const auto grammar = parseGrammar(params.axiom, params.rules);
    RAMURE_TRY(grammar);
    const bool byChance = params.stochastic && std::ranges::any_of(grammar->rules, [](const Rule& rule) {
                              return !rule.probabilities.empty();
                          });
    std::vector<Generation> generations;
    Counts counts = countsOf(grammar->axiom);
    for (int i = 0; i <= last; ++i) {
        if (i > 0)
            counts = nextCounts(*grammar, counts);
        Generation generation;
        const bool before = generations.empty() || generations.back().text;
        RewriteOptions options;
        options.iterations = i;
        options.stochastic = byChance;
        options.seed = static_cast<std::uint64_t>(params.seed);
        options.limit = longestGeneration;
        // By chance each generation is drawn anew from the axiom; the limit keeps that cheap.
        const auto text =
            before ? rewrite(*grammar, options) : Expected<std::string>(fail(ErrorCode::Limit, ""));
        if (text && text->size() <= longestGeneration) {
            generation.symbols = static_cast<double>(text->size());
            generation.text = *text;
        } else if (byChance) {
            generation.symbols = static_cast<double>(longestGeneration);
            generation.atLeast = true;
        } else {
            generation.symbols = sum(counts);
        }
        generations.push_back(std::move(generation));
        if (generations.back().atLeast)
            break;
    }
    return generations;
}

} // namespace ramure
