/// \file
/// Rewriting of modules (core/generators/parametric/parametric_grammar.h): all at once, round by round.
#pragma once

#include "core/base/progress.h"
#include "core/generators/parametric/parametric_grammar.h"

namespace ramure {

/// Modules in their order, and the numbers that they carry, module by module.
struct ModuleWord
{
    std::vector<Module> modules;
    std::vector<double> numbers;
    std::vector<ModuleSource> sources; ///< table for Module::source
    /// Keys for random choices: a hash of the way from the axiom through the productions.
    std::vector<std::uint64_t> keys;

    [[nodiscard]] std::size_t numbersOf(const Module& module) const { return sources[module.source].numbers; }
    /// "A(1, 0.5)"
    [[nodiscard]] std::string text(const Module& module) const;
};

/// Most modules of a word, and most numbers: a fifth of a gigabyte.
inline constexpr std::size_t mostModules = 16'000'000;

struct DeriveOptions
{
    int iterations = 0;
    bool stochastic = false; ///< false: the heaviest outcome, and the middle of every rand()
    std::uint64_t seed = 1;
    std::size_t limit = mostModules;
};

/// Derives the word. Random choices for a module depend on the seed, the round and its key alone. A module
/// without a fitting rule stays. A module % removes the rest of its branch in the next round. Errors: Invalid
/// with the place of the expression (a condition or a number is not finite); Limit (more than options.limit
/// modules or numbers, found before the memory is taken); Cancelled.
Expected<ModuleWord> derive(const ParametricGrammar& grammar, const DeriveOptions& options,
                            const Progress& progress = {});

/// One letter a module.
std::string lettersOf(const ModuleWord& word);

} // namespace ramure
