/// \file
/// Where the steps of a turtle are after its grammar has changed, for suites that follow edits.
#pragma once

#include "core/base/index.h"
#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include "core/params/node_params.h"
#include <string>
#include <vector>

namespace ramure::test {

inline bool isDrawn(char symbol)
{
    return std::string_view("+-/\\^_[]").find(symbol) == std::string_view::npos;
}

/// By step of the turtle before: the step after that stands for it; noIndex: it is gone.
using StepMap = std::vector<Index>;

/// One iteration more: what a symbol became outside brackets.
inline StepMap afterOneMore(const NodeParams& params, const std::string& symbols)
{
    StepMap map;
    Index at = 0;
    for (const char symbol : symbols) {
        if (!isDrawn(symbol))
            continue;
        const auto grammar = parseGrammar(std::string(1, symbol), params.grammar.rules);
        RewriteOptions once;
        once.iterations = 1;
        const std::string became = *rewrite(*grammar, once);
        Index found = noIndex;
        int depth = 0;
        for (const char c : became) {
            depth += c == '[' ? 1 : c == ']' ? -1 : 0;
            if (isDrawn(c) && depth == 0 && found == noIndex)
                found = at;
            at += isDrawn(c) ? 1 : 0;
        }
        map.push_back(found);
    }
    return map;
}

inline StepMap shifted(Index steps, Index from, Index by)
{
    StepMap map;
    for (Index i = 0; i < steps; ++i)
        map.push_back(i < from ? i : i + by);
    return map;
}

} // namespace ramure::test
