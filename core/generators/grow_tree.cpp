#include "core/generators/grow_tree.h"

#include "core/generators/colonisation/colonisation.h"
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/parametric/module_turtle.h"
#include "core/generators/shape_test.h"
#include "core/generators/weber_penn/weber_penn.h"
#include "core/params/tree_edit_table.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

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

bool growsByGrammar(const NodeParams& params)
{
    return params.generator.kind == TreeGenerator::Grammar;
}

} // namespace

double historyYears(const NodeParams& params)
{
    constexpr double step = 10.0;
    return std::min(step * std::max(std::ceil(params.growth.age / step), 1.0), maxGrowthAge);
}

bool canLiveOn(const TreeEdit& edit)
{
    // What falls hangs on its stump until then; what a graft has made never grew.
    return (infoOf(edit.operation).fields & editYear) && !edit.falls && edit.target.maker == 0;
}

double growthYears(const NodeParams& params)
{
    const bool grows = params.generator.kind == TreeGenerator::Growth && stepsFrozen(params.edits) == 0;
    return grows ? std::max(std::floor(params.growth.age), 1.0) : 0.0;
}

/// Null: it has no inside.
static std::shared_ptr<const GrowthShape> shapeOf(const EditShape& shape)
{
    const auto kept = std::make_shared<const EditShape>(shape);
    const auto test = std::make_shared<const ShapeTest>(*kept);
    if (!test->check())
        return nullptr;
    return std::make_shared<const GrowthShape>(
        [kept, test](const glm::dvec3& at) { return test->contains(at); });
}

GrowthCuts growthCuts(const NodeParams& params)
{
    GrowthCuts cuts;
    if (growthYears(params) <= 0.0)
        return cuts;
    for (const TreeEdit& edit : params.edits)
        if (edit.enabled && edit.year > 0.0 && canLiveOn(edit) &&
            (edit.operation != EditOperation::Prune || params.growth.habit == GrowthHabit::Branching)) {
            GrowthCut cut{edit.target.address, 0.0, std::max(int(edit.year), 1), edit.id, {}};
            if (edit.operation == EditOperation::Cut)
                cut.share = edit.at;
            if (edit.operation == EditOperation::Prune && !(cut.within = shapeOf(edit.shape)))
                continue; // the recipe says why it cannot
            cuts.push_back(std::move(cut));
        }
    return cuts;
}

Expected<GrowthRun> beginLife(const NodeParams& params, const Progress& progress)
{
    const auto seed = static_cast<std::uint64_t>(params.grammar.seed);
    return GrowthRun::begin(params.growth, seed, growthCuts(params), progress);
}

const char* sizeKey(const NodeParams& params)
{
    if (params.generator.kind == TreeGenerator::Growth)
        return "growth.age";
    if (params.generator.kind == TreeGenerator::Colonisation)
        return "colonisation.points";
    if (params.generator.kind == TreeGenerator::Drawn)
        return "generator.kind";
    return growsByGrammar(params) ? "grammar.iterations" : "weberPenn.levels";
}

Expected<GrownSymbols> growSymbols(const NodeParams& all, const Progress& progress)
{
    if (all.generator.kind == TreeGenerator::Growth)
        return growYears(all, progress);
    if (!growsByGrammar(all))
        return GrownSymbols{};
    const GrammarParams& params = all.grammar;
    if (params.dialect == GrammarDialect::Parametric)
        return growModules(params, progress);
    const auto grammar = parseGrammar(params.axiom, params.rules);
    RAMURE_TRY(grammar);
    RewriteOptions options;
    options.iterations = static_cast<int>(params.iterations);
    options.stochastic = params.stochastic;
    options.seed = static_cast<std::uint64_t>(params.seed);
    auto symbols = rewrite(*grammar, options, progress);
    if (!symbols)
        return blame(std::move(symbols.error()), "grammar.iterations");
    return GrownSymbols{std::move(*symbols), {}, {}};
}

Expected<Skeleton> growSkeleton(const GrownSymbols& grown, const NodeParams& params, const Progress& progress)
{
    const GrammarParams& grammar = params.grammar;
    const auto seed = static_cast<std::uint64_t>(grammar.seed);
    if (params.generator.kind == TreeGenerator::WeberPenn)
        return growWeberPenn(params.weberPenn, seed, progress);
    if (params.generator.kind == TreeGenerator::Colonisation)
        return growColonisation(params.colonisation, seed, progress);
    if (params.generator.kind == TreeGenerator::Drawn)
        return Skeleton();
    if (grown.history)
        return cutAge(*grown.history, params.growth.age);
    const TurtleChance chance{grammar.stochastic ? params.variation : VariationParams{0.0, 0.0, 0.0}, seed};
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

} // namespace ramure
