/// \file
/// Writes rules as text, for round trips through parseRules().
#pragma once

#include "core/base/number_text.h"
#include "core/generators/grammar/grammar.h"

namespace ramure::test {

inline void appendSymbol(std::string& out, char symbol, std::string_view special)
{
    if (symbol == ' ' || symbol == '\t' || symbol == '\r' || symbol == '`' ||
        special.find(symbol) != std::string_view::npos)
        out += '`';
    out += symbol;
}

inline void appendText(std::string& out, const std::string& text)
{
    if (!text.empty())
        out += ' ';
    for (const char symbol : text)
        appendSymbol(out, symbol, "|:");
}

/// The text form of rules; parseRules(formatRules(r)) gives r back for all r that checkGrammar accepts.
inline std::string formatRules(const std::vector<Rule>& rules)
{
    std::string out;
    for (const Rule& rule : rules) {
        appendSymbol(out, rule.symbol, "#");
        out += " ->";
        for (std::size_t i = 0; i < rule.probabilities.size(); ++i) {
            out += i == 0 ? " " : " | ";
            out += numberText(rule.probabilities[i]);
            out += ':';
            appendText(out, rule.replacements[i]);
        }
        const bool hasChoices = !rule.probabilities.empty();
        if (hasChoices && rule.defaultText != rule.replacements.front())
            out += " | default:";
        if (!hasChoices || rule.defaultText != rule.replacements.front())
            appendText(out, rule.defaultText);
        out += '\n';
    }
    return out;
}

} // namespace ramure::test
