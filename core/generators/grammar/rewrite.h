/// \file
/// Parallel rewriting of a string by a grammar (SPEC A1).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/generators/grammar/grammar.h"
#include <string>

namespace ramure {

/// Longest string the program makes: 64 million symbols.
inline constexpr std::size_t maxSymbols = 64'000'000;

struct RewriteOptions
{
    int iterations = 0;
    bool stochastic = false; ///< use the probabilities where a rule has them
    std::uint64_t seed = 1;
    std::size_t limit = maxSymbols;
};

/// Each iteration replaces all symbols at once. With \p options.stochastic, iteration k = 1, 2, ... draws
/// from Random(seed, RandomStream::Rewrite, k), one number per symbol that has probabilities, from left to
/// right: a change of the seed, and nothing else, draws anew. iterations <= 0 gives the axiom.
///
/// Errors: those of checkGrammar; Limit (the next generation would pass the limit: found before memory is
/// taken), Cancelled.
Expected<std::string> rewrite(const Grammar& grammar, const RewriteOptions& options,
                              const Progress& progress = {});

} // namespace ramure
