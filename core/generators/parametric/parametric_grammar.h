/// \file
/// The parametric dialect: modules with numbers, in the language of Prusinkiewicz and Lindenmayer, "The
/// Algorithmic Beauty of Plants" (1990), chapters 1 and 2, in the spelling of L-Py.
///
///     rule      = [ label ":" ] [ context "<" ] module [ ">" context ] [ ":" condition ] "->" outcomes
///     outcomes  = modules | weight ":" modules { "|" weight ":" modules }
///     module    = letter [ "(" ... ")" ]       names in front of the arrow, expressions behind it
///     context   = module | "*"                 * stands for any, as it does for a condition
///     ignored   = [ "#" ] "ignore" [ ":" ] letters        no neighbours in contexts; "consider": all others
///     define    = "#define" name expression    a constant among the rules
///     constants = lines of: name "=" expression, or define
///
/// One rule a line. ~(name, size) names an organ: leaf, fruit or flower.
///
/// A letter is one of A-Z a-z 0-9 + - & ^ \ / | $ ! % ~ [ ]. The first rule whose module, contexts and
/// condition fit is used; a module fits where it has as many numbers. A context is the one module before it
/// on the way from the root, or the next one after it on the same branch: brackets and ignored modules are
/// skipped. Comments begin with #, or stand between /* and */.
///
/// As books print them are read: labels of rules such as p1, arrows, the minus, comparison and multiplication
/// signs of typography, = for ==, one & and one | in conditions, Greek letters in names.
#pragma once

#include "core/generators/parametric/expression.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include <array>
#include <optional>
#include <vector>

namespace ramure {

/// A module as it was written: behind the arrow, or in the axiom.
struct ModuleSource
{
    char name = 0;
    std::uint8_t numbers = 0;       ///< count of its numbers
    std::optional<OrganKind> organ; ///< kind of ~(name, size)
    TextPlace place;
};

/// A module of a word; of an array of millions.
struct Module
{
    std::uint32_t firstNumber = 0; ///< index into ModuleWord::numbers
    std::uint16_t source = 0;      ///< index into ParametricGrammar::sources
    std::uint8_t birth = 0;        ///< the round that made it, 0: the axiom
    char name = 0;
};

/// A replacement for a module.
struct Production
{
    /// A number that must be computed.
    struct Computed
    {
        std::uint32_t number;
        Expression expression;
    };
    double weight = 1.0;
    std::vector<Module> modules; ///< firstNumber counts from the production's own
    std::vector<double> numbers; ///< numbers that are constant; 0 in place of the others
    std::vector<Computed> computed;
};

/// A module in front of the arrow.
struct ModulePattern
{
    char name = 0;
    std::size_t numbers = 0;
};

struct ParametricRule
{
    ModulePattern module;
    std::optional<ModulePattern> left, right;
    /// Its parameters, like those of the productions, come from the module, the left and the right context.
    Expression condition;
    std::vector<Production> productions; ///< at least one
    double weights = 1.0;                ///< their sum
    std::size_t likeliest = 0;           ///< the production without chance
};

struct ParametricGrammar
{
    std::vector<ModuleSource> sources;
    Production axiom;
    std::vector<ParametricRule> rules;                      ///< as the author wrote them
    std::array<std::vector<const ParametricRule*>, 128> of; ///< rules by the module's letter
    Constants constants;
    std::array<bool, 128> isIgnored{}; ///< by letter: contexts skip it
    bool usesOrder = false, usesContext = false, usesChance = false;

    ParametricGrammar() = default;
    ParametricGrammar(ParametricGrammar&&) = default; // `of` points into `rules`
    ParametricGrammar& operator=(ParametricGrammar&&) = default;
    ParametricGrammar(const ParametricGrammar&) = delete;
    ParametricGrammar& operator=(const ParametricGrammar&) = delete;
};

/// Most numbers of one module, and most modules in all texts of a grammar together.
inline constexpr std::size_t mostModuleNumbers = 16;
inline constexpr std::size_t mostSources = 65535;

/// Errors (Syntax / Invalid / Limit), path = "grammar.axiom", "grammar.rules" or "grammar.constants", with
/// line and column: what was expected there, and what to write instead of something that other programs
/// understand; a context of several modules; a name that means nothing or two
/// things; brackets that do not match, or have a rule; negative or all-zero weights; a constant that is no
/// finite number.
Expected<ParametricGrammar> parseParametric(const GrammarParams& params);
/// The constants alone, with those among the rules. Errors as above.
Expected<Constants> parseConstants(const GrammarParams& params);

/// Whether \p letter may be a module.
bool isModuleLetter(char letter);

} // namespace ramure
