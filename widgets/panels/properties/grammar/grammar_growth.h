/// \file
/// The generations of a grammar: their lengths, and the strings of those that are short enough to read.
#pragma once

#include "core/base/error.h"
#include "core/generators/parametric/derive.h"
#include "core/params/node_params.h"
#include <optional>
#include <string>
#include <vector>

namespace ramure {

struct Generation
{
    double symbols = 0.0;            ///< exact below 2^53
    bool atLeast = false;            ///< only a lower bound is known: it is drawn by chance, and too long
    std::optional<std::string> text; ///< where it has no more than the limit
    ModuleWord word;                 ///< of the parametric dialect: one module a letter of the text
};

inline constexpr int mostGenerations = 24;
inline constexpr std::size_t longestGeneration = 20'000; ///< symbols

/// Generations 0 (the axiom) to \p params.iterations, at most mostGenerations after the axiom. A few
/// milliseconds: no string is longer than longestGeneration; beyond it symbols are counted, not written.
/// In the parametric dialect the generation that is too long is the last one. Errors: those of parseGrammar
/// or parseParametric; where a number is not finite, those generations that there are before.
Expected<std::vector<Generation>> generationsOf(const GrammarParams& params);

} // namespace ramure
