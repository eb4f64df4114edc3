#include "core/generators/sources.h"

#include "core/generators/colonisation/colonisation.h"
#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/parametric/module_turtle.h"
#include "core/generators/parametric/parametric_grammar.h"
#include "core/generators/tree_life.h"
#include "core/generators/weber_penn/weber_penn.h"
#include <algorithm>

namespace ramure {
namespace {

std::uint64_t seedOf(const NodeParams& params)
{
    return static_cast<std::uint64_t>(params.grammar.seed);
}

tl::unexpected<Error> blame(Error error, const char* path)
{
    if (error.path.empty() && error.code != ErrorCode::Cancelled)
        error.path = path;
    return fail(std::move(error));
}

Expected<GrownSymbols> growModules(const GrammarParams& params, const Progress& progress)
{
    const auto grammar = parseParametric(params);
    RAMURE_TRY(grammar);
    DeriveOptions options;
    options.iterations = static_cast<int>(params.iterations);
    options.stochastic = params.stochastic;
    options.seed = static_cast<std::uint64_t>(params.seed);
    auto word = derive(*grammar, options, progress);
    if (!word)
        return blame(std::move(word.error()), "grammar.iterations");
    std::string letters = lettersOf(*word);
    return GrownSymbols{std::move(letters), std::move(*word), {}};
}

Expected<GrownSymbols> grammarSymbols(const NodeParams& all, const Progress& progress)
{
    const GrammarParams& params = all.grammar;
    if (params.dialect == GrammarDialect::Parametric)
        return growModules(params, progress);
    const auto grammar = parseGrammar(params.axiom, params.rules);
    RAMURE_TRY(grammar);
    RewriteOptions options;
    options.iterations = static_cast<int>(params.iterations);
    options.stochastic = params.stochastic;
    options.seed = seedOf(all);
    auto symbols = rewrite(*grammar, options, progress);
    if (!symbols)
        return blame(std::move(symbols.error()), "grammar.iterations");
    return GrownSymbols{std::move(*symbols), {}, {}};
}

Expected<Skeleton> grammarSkeleton(const GrownSymbols& grown, const NodeParams& params,
                                   const Progress& progress)
{
    const GrammarParams& grammar = params.grammar;
    const TurtleChance chance{grammar.stochastic ? params.variation : VariationParams{0.0, 0.0, 0.0},
                              seedOf(params)};
    if (grammar.dialect == GrammarDialect::Parametric)
        return runModuleTurtle(grown.word, params.turtle, chance, progress);
    auto skeleton = runTurtle(grown.letters, params.turtle, chance, progress);
    if (skeleton)
        return skeleton;
    Error error = std::move(skeleton.error());
    if (error.code == ErrorCode::Limit)
        return blame(std::move(error), "grammar.iterations");
    // The axiom and each rule are balanced: only rules for brackets themselves can have done this. The column
    // counts the rewritten string, which the message says in words; beside a path it would point into the
    // wrong text.
    const bool isBracket = error.column > 0;
    error.column = 0;
    return blame(std::move(error), isBracket ? "grammar.rules" : "grammar.axiom");
}

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

bool grammarVaries(const NodeParams& params)
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

/// A seedling of one shoot is the least that there is.
constexpr double leastAge = 0.25;

Expected<GrownSymbols> growYears(const NodeParams& all, const Progress& progress)
{
    auto life = beginLife(all, progress);
    RAMURE_TRY(life);
    if (auto grown = life->growTo(historyYears(all), progress); !grown)
        return fail(std::move(grown.error()));
    return GrownSymbols{{}, {}, std::make_shared<const GrowthHistory>(std::move(*life).take())};
}

Expected<Skeleton> cutAge(const GrowthHistory& history, double age)
{
    Skeleton tree = skeletonAtAge(history, std::max(age, leastAge));
    if (!tree.empty())
        return tree;
    return blame(fail(ErrorCode::Invalid,
                      RAMURE_NOOP("the tree has died at the age of %1 years for want of light"),
                      {std::to_string(history.diedAt)})
                     .value(),
                 "growth.age");
}

constexpr auto always = [](const NodeParams& /*params*/) { return true; };

constexpr Source sources[] = {
    {EditOperation::Grammar, grammarSkeleton, grammarVaries, grammarSymbols},
    {EditOperation::WeberPenn,
     [](const GrownSymbols& /*none*/, const NodeParams& params, const Progress& progress) {
         return growWeberPenn(params.weberPenn, seedOf(params), progress);
     },
     [](const NodeParams& params) { return varies(params.weberPenn); }},
    {EditOperation::Colonisation,
     [](const GrownSymbols& /*none*/, const NodeParams& params, const Progress& progress) {
         return growColonisation(params.colonisation, seedOf(params), progress);
     },
     always},
    {EditOperation::Growth,
     [](const GrownSymbols& grown, const NodeParams& params, const Progress& /*quick*/) {
         return cutAge(*grown.history, params.growth.age);
     },
     always, growYears},
    {EditOperation::Draw,
     [](const GrownSymbols& /*none*/, const NodeParams& /*params*/,
        const Progress& /*quick*/) -> Expected<Skeleton> { return Skeleton(); },
     [](const NodeParams& /*params*/) { return false; }},
};

} // namespace

const Source& sourceOf(const NodeParams& params)
{
    return *std::ranges::find(sources, params.generator.kind, &Source::operation);
}

Expected<GrownSymbols> growSymbols(const NodeParams& params, const Progress& progress)
{
    const Source& source = sourceOf(params);
    return source.symbols ? source.symbols(params, progress) : GrownSymbols{};
}

Expected<Skeleton> growSkeleton(const GrownSymbols& grown, const NodeParams& params, const Progress& progress)
{
    return sourceOf(params).skeleton(grown, params, progress);
}

} // namespace ramure
