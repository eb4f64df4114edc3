/// \file
/// What several benchmarks work on, made once.
#pragma once

#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/presets/presets.h"
#include "core/skeleton/simplify.h"
#include <cstdio>
#include <cstdlib>

namespace ramure::bench {

template <class T> T need(Expected<T> value)
{
    if (value)
        return std::move(*value);
    std::fprintf(stderr, "%s\n", value.error().message().c_str());
    std::abort();
}

/// The preset's grammar with so many iterations.
struct Growth
{
    NodeParams params;
    Grammar grammar;
    RewriteOptions options;

    Growth(const char* preset, int iterations)
        : params(need(presetParams(preset)))
        , grammar(need(parseGrammar(params.grammar.axiom, params.grammar.rules)))
        , options{iterations}
    {
    }
    [[nodiscard]] std::string symbols() const { return need(rewrite(grammar, options)); }
    [[nodiscard]] Skeleton skeleton() const { return need(runTurtle(symbols(), params.turtle)); }
    [[nodiscard]] Skeleton simplified() const { return simplify(skeleton(), 1e-4).skeleton; }
};

} // namespace ramure::bench
