/// \file
/// Expressions of a parametric grammar: text becomes a list of steps for a stack of numbers.
///
///     expression = or; or = and { "||" and }; and = comparison { "&&" comparison }
///     comparison = sum [ ("<" | "<=" | ">" | ">=" | "==" | "!=") sum ]; sum = product { ("+" | "-") product
///     } product    = unary { ("*" | "/") unary }; unary = { "-" | "+" | "!" } power power      = value [ "^"
///     unary ]; value = number | name | "(" or ")" | function "(" or { "," or } ")"
///
/// Functions: min, max (two or more numbers), abs, sqrt, sin, cos (degrees), rand(a, b). Names: parameters of
/// the rule's modules, constants, `order` (brackets around the module), `age` (rounds since it came). True is
/// 1, and everything but 0 is true.
#pragma once

#include "core/generators/parametric/text_scanner.h"
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ramure {

/// What the names of a grammar's constants stand for.
using Constants = std::map<std::string, double, std::less<>>;

/// What an expression may ask for.
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
        Rand,
    };
    struct Step
    {
        Op op;
        std::uint32_t index = 0; ///< of a parameter or of a rand(), or where a skip leads to
        double value = 0.0;      ///< of a constant, and what a Product multiplies by
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

/// Names and what is counted while the expressions of one rule are read.
struct ExpressionNames
{
    std::vector<std::string> parameters;
    const Constants* constants = nullptr;
    std::uint32_t randoms = 0; ///< calls of rand() so far
    bool usesOrder = false;
};

/// Reads as much as belongs to an expression; it ends before ")", ",", "->" or the end. Errors (Syntax /
/// Invalid, with their place): what was expected; a name that means nothing; nesting deeper than 100; a part
/// without variables that is no finite number.
Expected<Expression> parseExpression(TextScanner& text, ExpressionNames& names);

} // namespace ramure
