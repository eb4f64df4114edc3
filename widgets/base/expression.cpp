#include "widgets/base/expression.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <QString>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace ramure {
namespace {

constexpr int maxDepth = 64; ///< of brackets and signs: no text can exhaust the stack

/// A number on its way: plain ones get the field's unit when they meet one that has it.
struct Quantity
{
    double value = 0.0;
    bool hasUnit = false;
    bool hasPi = false;
    double unitFactor = 1.0; ///< of the unit written last: "1/4 turn" is a quarter of a turn
};

struct UnitName
{
    QStringView name;
    ParamUnit unit;
    double factor;
};

constexpr UnitName unitNames[] = {
    {u"deg", ParamUnit::Radian, oneDegree}, {u"°", ParamUnit::Radian, oneDegree},
    {u"rad", ParamUnit::Radian, 1.0},       {u"turn", ParamUnit::Radian, 2.0 * std::numbers::pi},
    {u"km", ParamUnit::Metre, 1000.0},      {u"m", ParamUnit::Metre, 1.0},
    {u"cm", ParamUnit::Metre, 0.01},        {u"mm", ParamUnit::Metre, 0.001},
    {u"in", ParamUnit::Metre, 0.0254},      {u"ft", ParamUnit::Metre, 0.3048},
    {u"s", ParamUnit::Second, 1.0},         {u"ms", ParamUnit::Second, 0.001},
    {u"min", ParamUnit::Second, 60.0},      {u"%", ParamUnit::None, 0.01},
    {u"kg", ParamUnit::Kilogram, 1.0},      {u"g", ParamUnit::Kilogram, 0.001},
};

class Parser
{
public:
    Parser(QStringView text, ParamUnit unit, double plainFactor)
        : m_text(text)
        , m_unit(unit)
        , m_plainFactor(plainFactor)
    {
    }

    Expected<double> run()
    {
        const Quantity result = sum();
        skipBlanks();
        if (!m_error && m_at < m_text.size())
            stop(RAMURE_NOOP("this cannot be read as a number"));
        if (m_error)
            return fail(*m_error);
        const double value = inUnit(result);
        if (std::isnan(value))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the result is no number"));
        if (std::isinf(value))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the result is too large"));
        return value;
    }

private:
    [[nodiscard]] double inUnit(const Quantity& q) const
    {
        if (q.hasUnit || (q.hasPi && m_unit == ParamUnit::Radian))
            return q.value;
        return q.value * m_plainFactor;
    }

    void stop(const char* text)
    {
        if (m_error)
            return;
        m_error = Error();
        m_error->code = ErrorCode::Syntax;
        m_error->text = text;
        m_error->column = static_cast<int>(m_at) + 1;
    }

    void skipBlanks()
    {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
    }

    bool take(QChar symbol)
    {
        skipBlanks();
        if (m_at >= m_text.size() || m_text[m_at] != symbol)
            return false;
        ++m_at;
        return true;
    }

    Quantity sum()
    {
        Quantity left = product();
        while (!m_error) {
            const bool plus = take(u'+');
            if (!plus && !take(u'-') && !take(u'−'))
                break;
            const Quantity right = product();
            if (left.hasUnit || right.hasUnit || left.hasPi || right.hasPi) {
                left = {inUnit(left), true, false, 1.0};
                left.value += plus ? inUnit(right) : -inUnit(right);
            } else {
                left.value += plus ? right.value : -right.value;
            }
        }
        return left;
    }

    Quantity product()
    {
        Quantity left = power();
        while (!m_error) {
            const bool times = take(u'*') || take(u'×');
            if (!times && !take(u'/') && !take(u'÷'))
                break;
            const Quantity right = power();
            if (times && left.hasUnit && right.hasUnit)
                stop(RAMURE_NOOP("two units cannot be multiplied here"));
            const bool fractionOfUnit = !times && right.hasUnit && !left.hasUnit;
            if (times)
                left.value *= right.value;
            else if (fractionOfUnit)
                left.value = left.value / right.value * right.unitFactor * right.unitFactor;
            else
                left.value /= right.value;
            left.hasUnit = times ? left.hasUnit || right.hasUnit : left.hasUnit != right.hasUnit;
            left.hasPi = left.hasPi || right.hasPi;
        }
        return left;
    }

    Quantity power()
    {
        const Quantity base = signedUnit();
        if (m_error || !take(u'^'))
            return base;
        if (++m_depth > maxDepth) {
            stop(RAMURE_NOOP("too many levels"));
            return {};
        }
        const Quantity exponent = power();
        --m_depth;
        if (base.hasUnit || exponent.hasUnit)
            stop(RAMURE_NOOP("a unit cannot have a power here"));
        return {maths::pow(base.value, exponent.value), false, base.hasPi, 1.0};
    }

    Quantity signedUnit()
    {
        double sign = 1.0;
        while (true) {
            if (take(u'-') || take(u'−'))
                sign = -sign;
            else if (!take(u'+'))
                break;
        }
        Quantity result = primary();
        result.value *= sign;
        if (!m_error)
            applyUnit(result);
        return result;
    }

    void applyUnit(Quantity& q)
    {
        const QStringView name = takeName();
        if (name.isEmpty())
            return;
        for (const UnitName& unit : unitNames) {
            if (name.compare(unit.name, Qt::CaseInsensitive) != 0)
                continue;
            if (unit.unit != ParamUnit::None && unit.unit != m_unit)
                break;
            if (q.hasUnit) {
                m_at -= name.size();
                stop(RAMURE_NOOP("this number has a unit already"));
                return;
            }
            q.value *= unit.factor;
            q.hasUnit = unit.unit != ParamUnit::None || m_unit == ParamUnit::Share;
            q.unitFactor = unit.factor;
            return;
        }
        m_at -= name.size();
        stop(RAMURE_NOOP("unknown unit"));
    }

    /// Letters, or one of the signs that are units; empty where there is something else.
    QStringView takeName()
    {
        skipBlanks();
        const qsizetype from = m_at;
        if (m_at < m_text.size() && (m_text[m_at] == u'°' || m_text[m_at] == u'%')) {
            ++m_at;
        } else {
            while (m_at < m_text.size() && m_text[m_at].isLetter())
                ++m_at;
        }
        return m_text.sliced(from, m_at - from);
    }

    Quantity primary()
    {
        if (take(u'('))
            return bracket();
        skipBlanks();
        if (m_at < m_text.size() && (m_text[m_at].isDigit() || m_text[m_at] == u'.' || m_text[m_at] == u','))
            return {number(), false, false, 1.0};
        const QStringView name = takeName();
        if (name.compare(u"pi", Qt::CaseInsensitive) == 0 || name == u"π")
            return {std::numbers::pi, false, true, 1.0};
        if (name.compare(u"tau", Qt::CaseInsensitive) == 0)
            return {2.0 * std::numbers::pi, false, true, 1.0};
        if (!name.isEmpty() && take(u'('))
            return function(name);
        m_at -= name.size();
        const bool isWord = name.compare(u"nan", Qt::CaseInsensitive) == 0 ||
                            name.compare(u"inf", Qt::CaseInsensitive) == 0 ||
                            name.compare(u"infinity", Qt::CaseInsensitive) == 0;
        stop(isWord ? RAMURE_NOOP("only finite numbers can be used")
                    : RAMURE_NOOP("a number is missing here"));
        return {};
    }

    Quantity bracket()
    {
        if (++m_depth > maxDepth) {
            stop(RAMURE_NOOP("too many levels"));
            return {};
        }
        const Quantity inner = sum();
        --m_depth;
        if (!m_error && !take(u')'))
            stop(RAMURE_NOOP("a closing bracket is missing"));
        return inner;
    }

    Quantity function(QStringView name)
    {
        double (*apply)(double) = nullptr;
        if (name == u"sqrt")
            apply = [](double x) { return std::sqrt(x); };
        else if (name == u"sin")
            apply = &maths::sin;
        else if (name == u"cos")
            apply = &maths::cos;
        else if (name == u"tan")
            apply = &maths::tan;
        else if (name == u"abs")
            apply = [](double x) { return std::abs(x); };
        if (!apply) {
            stop(RAMURE_NOOP("unknown function"));
            return {};
        }
        const Quantity inner = bracket();
        const bool keepsUnit = name == u"abs";
        return {apply(inner.value), keepsUnit && inner.hasUnit, keepsUnit && inner.hasPi, 1.0};
    }

    /// "1e-999" is 0 for all purposes, though the conversion calls it a failure.
    static bool isTooSmall(const QString& text)
    {
        const auto isPlain = [](QChar c) { return c.unicode() < 128; };
        const auto isDigit = [](QChar c) { return c >= u'0' && c <= u'9'; };
        return std::ranges::all_of(text, isPlain) && std::ranges::any_of(text, isDigit);
    }

    double number()
    {
        const qsizetype from = m_at;
        const auto digits = [this] {
            while (m_at < m_text.size() && m_text[m_at].isDigit())
                ++m_at;
        };
        digits();
        if (m_at < m_text.size() && (m_text[m_at] == u'.' || m_text[m_at] == u',')) {
            ++m_at;
            digits();
        }
        // An exponent only where digits follow: "2e" is a number and an unknown unit.
        if (m_at < m_text.size() && m_text[m_at].toLower() == u'e') {
            qsizetype next = m_at + 1;
            if (next < m_text.size() && (m_text[next] == u'+' || m_text[next] == u'-'))
                ++next;
            if (next < m_text.size() && m_text[next].isDigit()) {
                m_at = next;
                digits();
            }
        }
        bool good = false;
        QString text = m_text.sliced(from, m_at - from).toString();
        const double value = text.replace(u',', u'.').toDouble(&good);
        if (std::isinf(value)) {
            m_at = from;
            stop(RAMURE_NOOP("this number is too large"));
        } else if (!good && !isTooSmall(text))
            stop(RAMURE_NOOP("this cannot be read as a number"));
        return value;
    }

    QStringView m_text;
    ParamUnit m_unit;
    double m_plainFactor;
    qsizetype m_at = 0;
    int m_depth = 0;
    std::optional<Error> m_error;
};

} // namespace

Expected<double> evaluateExpression(QStringView text, ParamUnit unit, double plainFactor)
{
    // The sign behind a factor: elsewhere it multiplies.
    if (unit == ParamUnit::Factor && text.trimmed().endsWith(u'×'))
        text = text.first(text.lastIndexOf(u'×'));
    return Parser(text, unit, plainFactor).run();
}

} // namespace ramure
