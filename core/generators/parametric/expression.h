/// \file
/// Arithmetic, for grammars and for number fields: text becomes a list of steps for a stack of numbers.
///
///     expression = or
///     or         = and { "||" and }                     one bar will do, and one & for "and"
///     and        = comparison { "&&" comparison }
///     comparison = sum [ ("<" | "<=" | ">" | ">=" | "==" | "=" | "!=") sum ]
///     sum        = product { ("+" | "-") product }
///     product    = unary { ("*" | "/") unary }
///     unary      = { "-" | "+" | "!" } power
///     power      = value [ "^" unary ]
///     value      = number | name | "(" or ")" | function "(" or { "," or } ")"
///
/// Functions: min, max (two or more numbers), abs, sqrt, sin, cos, tan (degrees), rand(a, b). Names:
/// parameters of the rule's modules, constants, `order` (brackets around the module), `age` (rounds since it
/// came). True is 1, and everything but 0 is true.
///
/// In a number field there are units behind values, and pi; no comparison, rand, order or age.
#pragma once

#include "core/generators/parametric/text_scanner.h"
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace ramure {

/// The values of a grammar's constants by name.
using Constants = std::map<std::string, double, std::less<>>;

/// The inputs of an evaluation.
struct ExpressionInputs
{
    const double* parameters = nullptr;
    double order = 0.0, age = 0.0;
    bool byChance = false; ///< false: rand() gives the middle
    std::uint64_t seed = 1;
    std::uint64_t key = 0; ///< rand() depends on seed, key and its own number alone
};

class Expression
{
public:
    enum class Op : std::uint8_t {
        Constant,
        Parameter,
        Order,
        Age,
        Negate,
        Not,
        Truth,
        SkipIfFalse, ///< a false number stays, and the next steps are left out; a true one goes
        SkipIfTrue,
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Equal,
        NotEqual,
        Min,
        Max,
        Abs,
        Sqrt,
        Sin,
        Cos,
        Tan,
        Rand,
    };
    struct Step
    {
        Op op;
        /// Number of a parameter or of a rand(), or target of a skip. In a constant the parser keeps flags
        /// here: it has a unit, it is made of pi.
        std::uint32_t index = 0;
        double value = 0.0; ///< a constant's value; in a product the constant factor
    };

    /// Not finite where a number on the way to a comparison or the result is not.
    [[nodiscard]] double value(const ExpressionInputs& inputs) const
    {
        if (m_isProduct)
            return inputs.parameters[m_steps[0].index] * m_steps[1].value;
        return m_steps.size() == 1 && m_steps[0].op == Op::Parameter ? inputs.parameters[m_steps[0].index]
                                                                     : run(inputs);
    }
    [[nodiscard]] bool isConstant() const { return m_steps.size() == 1 && m_steps[0].op == Op::Constant; }
    /// No condition was written.
    [[nodiscard]] bool empty() const { return m_steps.empty(); }
    [[nodiscard]] const TextPlace& place() const { return m_place; }

private:
    friend class ExpressionParser;
    [[nodiscard]] double run(const ExpressionInputs& inputs) const;

    std::vector<Step> m_steps;
    TextPlace m_place;
    bool m_isProduct = false; ///< a parameter times a constant, as most are
};

struct UnitName
{
    std::string_view name; ///< "cm"; capitals do not count
    double factor;         ///< to the unit of the program
    bool isMeasure;        ///< false: the number stays a plain one, 50 % is 0.5
};

/// How a number field reads numbers.
struct FieldUnits
{
    std::vector<UnitName> names; ///< the units that the field understands
    double plainFactor = 1.0;    ///< converts a number without a unit to the program's unit
    bool isAngle = false;        ///< numbers made of pi are in radians
};

/// Names and counters while the expressions of one rule are read.
struct ExpressionNames
{
    std::vector<std::string> parameters;
    const Constants* constants = nullptr; ///< null: there are none
    const FieldUnits* units = nullptr;    ///< null: no number field
    std::uint32_t randoms = 0;            ///< calls of rand() so far
    bool usesOrder = false;
};

/// Reads one expression; it ends before ")", ",", "->" or the end. Errors (Syntax / Invalid, with their
/// place): something else was expected; an unknown name; nesting deeper than 100; a constant part that is no
/// finite number.
Expected<Expression> parseExpression(TextScanner& text, ExpressionNames& names);

/// Reads the expression of a number field, which must end at the end of the text. Errors: Syntax, Limit,
/// Invalid (not finite).
Expected<double> parseQuantity(TextScanner& text, const FieldUnits& units);

} // namespace ramure
