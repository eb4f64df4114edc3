/// \file
/// Parallel rewriting of a string by a grammar (SPEC A1).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/grammar/grammar.h"
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

/// Errors: Limit (the next generation would pass the limit: found before memory is taken), Cancelled.
Expected<std::string> rewrite(const Grammar& grammar, const RewriteOptions& options,
                              const Progress& progress = {});

} // namespace ramure
