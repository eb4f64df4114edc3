// Grammar text: the first line is the axiom, the rest are the rules.
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/grammar_text.h"

using namespace ramure;

namespace {

void grow(const Grammar& grammar, bool stochastic)
{
    RewriteOptions options{3, stochastic, 7};
    options.limit = 20'000;
    const auto symbols = rewrite(grammar, options);
    if (!symbols)
        return fuzz::claimGoodError(symbols.error());
    fuzz::claim(symbols->size() <= options.limit, "the limit of symbols holds");
    const auto again = rewrite(grammar, options);
    fuzz::claim(again && *again == *symbols, "rewriting gives the same twice");
    const auto skeleton = runTurtle(*symbols, TurtleParams());
    if (!skeleton)
        return fuzz::claimGoodError(skeleton.error());
    fuzz::claim(!skeleton->empty(), "a skeleton has branches");
    for (Index i = 0; i < skeleton->size(); ++i)
        fuzz::claim(skeleton->parent[i] == noIndex || skeleton->parent[i] < i,
                    "parents stand before children");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = fuzz::textOf(data, size);
    const std::size_t feed = std::min(text.find('\n'), text.size());
    const std::string_view rules = text.substr(std::min(feed + 1, text.size()));
    const auto grammar = parseGrammar(text.substr(0, feed), rules);
    if (!grammar) {
        fuzz::claimGoodError(grammar.error());
        return 0;
    }
    fuzz::claim(checkGrammar(*grammar).has_value(), "what was parsed passes the check");
    const auto again = parseRules(test::formatRules(grammar->rules));
    fuzz::claim(again && *again == grammar->rules, "rules written and parsed are the same");
    grow(*grammar, false);
    grow(*grammar, true);
    return 0;
}
