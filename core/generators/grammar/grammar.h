/// \file
/// A grammar: axiom and rules, and the text form in which users write rules.
///
/// Text form. One rule a line, a label of two or more letters and digits may stand in front of it; blank
/// lines and lines that begin with # are skipped. Spaces and tabs never count, neither around the parts nor
/// inside a replacement (`A -> B B` is `A -> BB`).
///
///     rule         = [ label ":" ] symbol "->" right-hand side       an arrow of typography will do
///     right side   = text                                  the default; empty deletes the symbol
///                  | choice { "|" choice }                 where the line has a `:` or a `|`
///     choice       = number ":" text | "default:" text
///
/// A stochastic rule lists probabilities (normalised by their sum) with their texts; `default:` gives what
/// deterministic rewriting uses, and may stand anywhere in the list; without it the default is the first
/// text. Any byte but a line feed may be a symbol (so a letter outside ASCII is several symbols). A backquote
/// takes the next character as it is: `` `| `` `` `: `` `` `# `` `` `` ` `` and `` `  `` (a space). A
/// backslash is the turtle's symbol and needs no escape. An escaped bracket is a bracket all the same.
#pragma once

#include "core/base/error.h"
#include "core/generators/grammar/grammar_note.h"
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

struct Rule
{
    char symbol = 0;
    std::string defaultText;
    std::vector<double> probabilities;     ///< as written, not normalised; empty = none given
    std::vector<std::string> replacements; ///< same length
    bool operator==(const Rule&) const = default;
};

struct Grammar
{
    std::string axiom;
    std::vector<Rule> rules; ///< at most one per symbol
    bool operator==(const Grammar&) const = default;
};

/// Parses the text form of the rules. Errors (Syntax / Invalid, with line and column): no arrow, no symbol,
/// two rules for one symbol, a choice without a number, negative, non-finite or all-zero probabilities,
/// unfinished escape. Brackets are not looked at.
Expected<std::vector<Rule>> parseRules(std::string_view text);
/// The axiom with escapes resolved and blanks removed, line feeds too. Error (Syntax, with line and column):
/// an unfinished escape. Brackets are not looked at.
Expected<std::string> parseAxiom(std::string_view text);
/// Both; and unbalanced brackets in the axiom or in any replacement are an error with line and column. Every
/// error has path = "grammar.axiom" or "grammar.rules".
/// \param notes where not null, gets remarks on symbols that grow branches though they look like others
/// (core/generators/grammar/lookalikes.h), and on comments that other programs read as commands; also on an
/// error, as far as the text was read. Symbols that are escaped or have a rule get none.
Expected<Grammar> parseGrammar(std::string_view axiom, std::string_view rules, GrammarNotes* notes = nullptr);
/// The same for a grammar built in code, and lists of different length. Here line = number of the rule (none
/// for the axiom) and column = position in the text concerned.
Expected<void> checkGrammar(const Grammar& grammar);

} // namespace ramure
