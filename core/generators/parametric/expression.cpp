#include "core/generators/parametric/expression.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace ramure {
namespace {

using Op = Expression::Op;

constexpr int deepestNesting = 100;
/// Per level of nesting one number of each binary level waits, and one of a function.
constexpr std::size_t stackSize = 10 * std::size_t(deepestNesting);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Flags of a constant in a number field.
constexpr std::uint32_t measured = 1; ///< its value is in the unit of the program
constexpr std::uint32_t ofPi = 2;

/// Not a number where one side is none: so the end of the expression sees it.
double compared(Op op, double a, double b)
{
    if (!std::isfinite(a) || !std::isfinite(b))
        return nan;
    switch (op) {
    case Op::Less:
        return a < b;
    case Op::LessEqual:
        return a <= b;
    case Op::Greater:
        return a > b;
    case Op::GreaterEqual:
        return a >= b;
    case Op::Equal:
        return a == b;
    default:
        return a != b;
    }
}

double combined(Op op, double a, double b)
{
    switch (op) {
    case Op::Add:
        return a + b;
    case Op::Subtract:
        return a - b;
    case Op::Multiply:
        return a * b;
    case Op::Divide:
        return a / b;
    case Op::Power:
        return maths::pow(a, b);
    case Op::Min:
        return std::isnan(a) || std::isnan(b) ? nan : std::min(a, b);
    case Op::Max:
        return std::isnan(a) || std::isnan(b) ? nan : std::max(a, b);
    default:
        return compared(op, a, b);
    }
}

double applied(Op op, double a)
{
    switch (op) {
    case Op::Negate:
        return -a;
    case Op::Not:
        return std::isnan(a) ? nan : a == 0.0;
    case Op::Truth:
        return std::isnan(a) ? nan : a != 0.0;
    case Op::Abs:
        return std::abs(a);
    case Op::Sqrt:
        return std::sqrt(a);
    case Op::Sin:
        return maths::sin(std::fmod(a, 360.0) * oneDegree);
    case Op::Tan:
        return maths::tan(std::fmod(a, 360.0) * oneDegree);
    default:
        return maths::cos(std::fmod(a, 360.0) * oneDegree);
    }
}

bool isOfAngle(Op op)
{
    return op == Op::Sin || op == Op::Cos || op == Op::Tan;
}

bool isUnary(Op op)
{
    return op == Op::Negate || op == Op::Not || op == Op::Truth || op == Op::Abs || op == Op::Sqrt ||
           isOfAngle(op);
}

double drawn(double a, double b, const ExpressionInputs& inputs, std::uint32_t number)
{
    if (!inputs.byChance)
        return 0.5 * (a + b);
    constexpr std::uint64_t step = 0x9E3779B97F4A7C15ull;
    return Random(inputs.seed, RandomStream::Rewrite, mixBits(inputs.key + step * (number + 1ull)))
        .range(a, b);
}

char lowered(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
}

} // namespace

double Expression::run(const ExpressionInputs& inputs) const
{
    std::array<double, stackSize> stack; // not cleared: it is written before it is read
    double* top = stack.data() - 1;
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const Step& step = m_steps[i];
        switch (step.op) {
        case Op::Constant:
            *++top = step.value;
            break;
        case Op::Parameter:
            *++top = inputs.parameters[step.index];
            break;
        case Op::Order:
            *++top = inputs.order;
            break;
        case Op::Age:
            *++top = inputs.age;
            break;
        case Op::SkipIfFalse:
        case Op::SkipIfTrue:
            if (std::isnan(*top))
                return nan;
            if ((*top != 0.0) == (step.op == Op::SkipIfTrue))
                i = step.index - 1;
            else
                --top;
            break;
        case Op::Rand:
            --top;
            top[0] = drawn(top[0], top[1], inputs, step.index);
            break;
        default:
            if (isUnary(step.op)) {
                *top = applied(step.op, *top);
            } else {
                --top;
                top[0] = combined(step.op, top[0], top[1]);
            }
        }
    }
    return *top;
}

/// By recursive descent, one function per level of precedence.
class ExpressionParser
{
public:
    ExpressionParser(TextScanner& text, ExpressionNames& names)
        : m_text(text)
        , m_names(names)
    {
        m_made.m_place = text.place();
    }

    Expected<Expression> parse()
    {
        RAMURE_TRY(whole());
        const auto& steps = m_made.m_steps;
        m_made.m_isProduct = steps.size() == 3 && steps[0].op == Op::Parameter &&
                             steps[1].op == Op::Constant && steps[2].op == Op::Multiply;
        return std::move(m_made);
    }

    /// The value of a number field, to the end of the text.
    Expected<double> parseQuantity()
    {
        const TextPlace start = m_text.place();
        RAMURE_TRY(whole());
        if (!m_text.atEnd())
            return failAt(m_text.place(), ErrorCode::Syntax, RAMURE_NOOP("this cannot be read as a number"));
        const double value = inUnit(m_made.m_steps.back());
        if (!std::isfinite(value))
            return failAt(start, ErrorCode::Invalid, RAMURE_NOOP("the result is not a finite number"));
        return value;
    }

private:
    using Done = Expected<void>;
    using Step = Expression::Step;
    using Level = Done (ExpressionParser::*)();
    struct Sign
    {
        const char* text;
        Op op;
    };

    Done whole() { return m_names.units ? sum() : either(); }
    Done either() { return chained("|", Op::SkipIfTrue, &ExpressionParser::both); }
    Done both() { return chained("&", Op::SkipIfFalse, &ExpressionParser::comparison); }
    Done comparison()
    {
        static constexpr std::array signs{Sign{"<=", Op::LessEqual}, Sign{">=", Op::GreaterEqual},
                                          Sign{"==", Op::Equal},     Sign{"!=", Op::NotEqual},
                                          Sign{"<", Op::Less},       Sign{">", Op::Greater},
                                          Sign{"=", Op::Equal}};
        return binary(signs, &ExpressionParser::sum, false);
    }
    Done sum()
    {
        static constexpr std::array signs{Sign{"+", Op::Add}, Sign{"-", Op::Subtract}};
        return binary(signs, &ExpressionParser::product, true);
    }
    Done product()
    {
        static constexpr std::array signs{Sign{"*", Op::Multiply}, Sign{"/", Op::Divide}};
        if (auto done = measure(); !done)
            return done;
        while (const Sign* sign = signOf(signs)) {
            const TextPlace place = m_text.place();
            m_text.take(sign->text);
            // "1/4 turn" is a quarter of a turn: there the unit belongs to the whole fraction.
            const bool isFraction = sign->op == Op::Divide && (m_made.m_steps.back().index & measured) == 0;
            auto done = isFraction && m_names.units ? unary() : measure();
            if (done)
                done = emit(sign->op, place);
            if (done && isFraction)
                done = unit();
            if (!done)
                return done;
        }
        return {};
    }
    Done measure()
    {
        return unary().and_then([this] { return unit(); });
    }

    /// Of a number field: the unit behind a number.
    Done unit()
    {
        if (!m_names.units)
            return {};
        const TextPlace place = m_text.place();
        std::string name;
        for (const char* sign : {"°", "%"})
            if (m_text.take(sign))
                name = sign;
        if (name.empty())
            name = m_text.takeName();
        if (name.empty())
            return {};
        const auto sameLetters = [&name](std::string_view known) {
            return std::ranges::equal(known, name, {}, &lowered, &lowered);
        };
        const auto found = std::ranges::find_if(m_names.units->names, sameLetters, &UnitName::name);
        if (found == m_names.units->names.end())
            return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("unknown unit"));
        Step& number = m_made.m_steps.back();
        if ((number.index & measured) != 0)
            return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("this number has a unit already"));
        number.value *= found->factor;
        number.index |= found->isMeasure ? measured : 0;
        return {};
    }

    /// The right side is computed only where the left one does not decide.
    Done chained(const char* sign, Op skip, Level below)
    {
        if (auto done = (this->*below)(); !done)
            return done;
        while (m_text.take(sign)) {
            m_text.take(sign); // books write it once
            const std::size_t at = m_made.m_steps.size();
            m_made.m_steps.push_back({skip});
            if (auto done = (this->*below)(); !done)
                return done;
            m_made.m_steps[at].index = static_cast<std::uint32_t>(m_made.m_steps.size());
            m_made.m_steps.push_back({Op::Truth});
        }
        return {};
    }

    /// The one that stands there, or null.
    [[nodiscard]] const Sign* signOf(std::span<const Sign> signs) const
    {
        const auto sign = std::ranges::find_if(
            signs, [this](const Sign& s) { return !m_text.atArrow() && m_text.startsWith(s.text); });
        return sign == signs.end() ? nullptr : &*sign;
    }

    Done binary(std::span<const Sign> signs, Level below, bool chains)
    {
        if (auto done = (this->*below)(); !done)
            return done;
        for (bool more = true; more;) {
            const Sign* sign = signOf(signs);
            if (!sign)
                return {};
            const TextPlace place = m_text.place();
            m_text.take(sign->text);
            if (auto done = (this->*below)(); !done)
                return done;
            if (auto done = emit(sign->op, place); !done)
                return done;
            more = chains;
        }
        return {};
    }

    Done unary()
    {
        const TextPlace place = m_text.place();
        const char sign = m_text.peek();
        const bool isNot = sign == '!' && !m_names.units;
        if ((sign != '-' && sign != '+' && !isNot) || m_text.atArrow())
            return power();
        m_text.next();
        return nested([this] { return unary(); }).and_then([&] {
            return sign == '+' ? Done() : emit(sign == '-' ? Op::Negate : Op::Not, place);
        });
    }

    Done power()
    {
        if (auto done = operand(); !done)
            return done;
        const TextPlace place = m_text.place();
        if (!m_text.take("^"))
            return {};
        return nested([this] { return unary(); }).and_then([&] { return emit(Op::Power, place); });
    }

    Done operand()
    {
        const TextPlace place = m_text.place();
        if (m_text.atNumber())
            return m_text.takeNumber().map([this](double value) { push({Op::Constant, 0, value}); });
        if (m_text.atName())
            return named(m_text.takeName(), place);
        if (!m_text.take("("))
            return failAt(place, ErrorCode::Syntax,
                          m_names.units ? RAMURE_NOOP("a number is missing here")
                                        : RAMURE_NOOP("a number, a name or \"(\" is expected here"));
        return nested([this] { return whole(); }).and_then([this] { return closed(); });
    }

    Done named(std::string_view name, const TextPlace& place)
    {
        const auto parameter = std::ranges::find(m_names.parameters, name);
        if (parameter != m_names.parameters.end()) {
            push({Op::Parameter, static_cast<std::uint32_t>(parameter - m_names.parameters.begin())});
            return {};
        }
        if (m_names.constants) // before functions: an older file may have one called "tan"
            if (const auto constant = m_names.constants->find(name); constant != m_names.constants->end()) {
                push({Op::Constant, 0, constant->second});
                return {};
            }
        static constexpr std::array functions{
            Sign{"min", Op::Min},     Sign{"max", Op::Max}, Sign{"abs", Op::Abs}, Sign{"sqrt", Op::Sqrt},
            Sign{"sin", Op::Sin},     Sign{"cos", Op::Cos}, Sign{"tan", Op::Tan}, Sign{"rand", Op::Rand},
            Sign{"order", Op::Order}, Sign{"age", Op::Age}};
        const auto function = std::ranges::find(functions, name, &Sign::text);
        if (m_names.units)
            return namedInField(name, function == functions.end() ? Op::Constant : function->op, place);
        if (function == functions.end())
            return failAt(
                place, ErrorCode::Syntax,
                RAMURE_NOOP(
                    "\"%1\" is neither a parameter of this rule's modules nor a constant nor a function"),
                {std::string(name)});
        m_names.usesOrder = m_names.usesOrder || function->op == Op::Order;
        if (function->op != Op::Order && function->op != Op::Age)
            return called(function->op, place);
        push({function->op});
        return {};
    }

    Done namedInField(std::string_view name, Op op, const TextPlace& place)
    {
        const bool isPi = name == "pi" || name == "π";
        if (isPi || name == "tau") {
            push({Op::Constant, ofPi, isPi ? pi : 2.0 * pi});
            return {};
        }
        if (isUnary(op) || op == Op::Min || op == Op::Max)
            return called(op, place);
        return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is neither a number nor a function"),
                      {std::string(name)});
    }

    Done called(Op op, const TextPlace& place)
    {
        if (!m_text.take("("))
            return failAt(m_text.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("\"(\" is expected here: this is a function"));
        int arguments = 0;
        do {
            if (auto done = nested([this] { return whole(); }); !done)
                return done;
            ++arguments;
            if (arguments > 1 && (op == Op::Min || op == Op::Max))
                if (auto done = emit(op, place); !done)
                    return done;
        } while (m_text.take(","));
        const bool takesMany = op == Op::Min || op == Op::Max;
        const int wanted = isUnary(op) ? 1 : 2;
        if (takesMany ? arguments < 2 : arguments != wanted)
            return failAt(m_text.place(), ErrorCode::Syntax,
                          wanted == 1 ? RAMURE_NOOP("one number is expected in these brackets, not %1")
                                      : RAMURE_NOOP("two numbers are expected in these brackets, not %1"),
                          {std::to_string(arguments)});
        if (auto done = closed(); !done || takesMany)
            return done;
        return op == Op::Rand ? (push({op, m_names.randoms++}), Done()) : emit(op, place);
    }

    Done closed()
    {
        return m_text.take(")")
                   ? Done()
                   : failAt(m_text.place(), ErrorCode::Syntax, RAMURE_NOOP("\")\" is expected here"));
    }

    /// Calls stand on the program's stack: a text of a million brackets must not exhaust it.
    template <class Inner> Done nested(Inner&& inner)
    {
        if (++m_depth > deepestNesting)
            return failAt(m_text.place(), ErrorCode::Limit,
                          RAMURE_NOOP("the expression is nested deeper than %1"),
                          {std::to_string(deepestNesting)});
        Done done = inner();
        --m_depth;
        return done;
    }

    void push(const Step& step) { m_made.m_steps.push_back(step); }

    /// What is known already is computed now, and must be a number.
    Done emit(Op op, const TextPlace& place)
    {
        auto& steps = m_made.m_steps;
        const std::size_t operands = isUnary(op) ? 1 : 2;
        const bool isKnown = std::all_of(steps.end() - static_cast<std::ptrdiff_t>(operands), steps.end(),
                                         [](const Expression::Step& s) { return s.op == Op::Constant; });
        if (!isKnown) {
            push({op});
            return {};
        }
        Step right = steps.back();
        if (operands == 2)
            steps.pop_back();
        Step& left = steps.back();
        if (m_names.units) {
            auto done = operands == 2 ? fitUnits(op, left, right, place) : fitUnit(op, left);
            if (!done)
                return done;
        }
        left.value = operands == 2 ? combined(op, left.value, right.value) : applied(op, left.value);
        if (!std::isfinite(left.value))
            return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("the result is not a finite number"));
        return {};
    }

    [[nodiscard]] bool isMeasured(const Step& step) const
    {
        return (step.index & measured) != 0 || (step.index == ofPi && m_names.units->isAngle);
    }
    [[nodiscard]] double inUnit(const Step& step) const
    {
        return isMeasured(step) ? step.value : step.value * m_names.units->plainFactor;
    }

    /// Units of two numbers that are about to be combined; the result's flags are put into \p left.
    Done fitUnits(Op op, Step& left, Step& right, const TextPlace& place) const
    {
        const std::uint32_t both = left.index & right.index, any = left.index | right.index;
        if (op == Op::Power || op == Op::Multiply) {
            const std::uint32_t refused = op == Op::Power ? any : both;
            if ((refused & measured) != 0)
                return failAt(place, ErrorCode::Syntax,
                              op == Op::Power ? RAMURE_NOOP("a unit cannot have a power here")
                                              : RAMURE_NOOP("two units cannot be multiplied here"));
            left.index = op == Op::Power ? left.index : any;
        } else if (op == Op::Divide) {
            left.index = (any & ofPi) | ((left.index ^ right.index) & measured);
        } else if (any != 0) {
            left.value = inUnit(left);
            right.value = inUnit(right);
            left.index = measured;
        }
        return {};
    }
    Done fitUnit(Op op, Step& number) const
    {
        const bool isRadians =
            (number.index & ofPi) != 0 || (m_names.units->isAngle && number.index == measured);
        if (isOfAngle(op) && isRadians)
            number.value /= oneDegree;
        if (isOfAngle(op) || op == Op::Sqrt)
            number.index = 0;
        return {};
    }

    TextScanner& m_text;
    ExpressionNames& m_names;
    Expression m_made;
    int m_depth = 0;
};

Expected<Expression> parseExpression(TextScanner& text, ExpressionNames& names)
{
    return ExpressionParser(text, names).parse();
}

Expected<double> parseQuantity(TextScanner& text, const FieldUnits& units)
{
    ExpressionNames names;
    names.units = &units;
    return ExpressionParser(text, names).parseQuantity();
}

} // namespace ramure
