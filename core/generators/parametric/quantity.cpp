#include "core/generators/parametric/quantity.h"

#include "core/generators/grammar/lookalikes.h"
#include "core/generators/parametric/expression.h"
#include "core/math/angle.h"

namespace ramure {
namespace {

struct UnitRow
{
    const char* name;
    ParamUnit unit;
    double factor;
};

constexpr UnitRow unitRows[] = {
    {"deg", ParamUnit::Radian, oneDegree}, {"°", ParamUnit::Radian, oneDegree},
    {"rad", ParamUnit::Radian, 1.0},       {"turn", ParamUnit::Radian, 2.0 * pi},
    {"km", ParamUnit::Metre, 1000.0},      {"m", ParamUnit::Metre, 1.0},
    {"cm", ParamUnit::Metre, 0.01},        {"mm", ParamUnit::Metre, 0.001},
    {"in", ParamUnit::Metre, 0.0254},      {"ft", ParamUnit::Metre, 0.3048},
    {"s", ParamUnit::Second, 1.0},         {"ms", ParamUnit::Second, 0.001},
    {"min", ParamUnit::Second, 60.0},      {"%", ParamUnit::None, 0.01},
    {"kg", ParamUnit::Kilogram, 1.0},      {"g", ParamUnit::Kilogram, 0.001},
    {"yr", ParamUnit::Year, 1.0},
};

FieldUnits unitsOf(ParamUnit unit, double plainFactor)
{
    FieldUnits units{{}, plainFactor, unit == ParamUnit::Radian};
    for (const UnitRow& row : unitRows)
        if (row.unit == unit || row.unit == ParamUnit::None)
            units.names.push_back(
                {row.name, row.factor, row.unit != ParamUnit::None || unit == ParamUnit::Share});
    return units;
}

/// A comma before a digit, or at the end, is a decimal sign.
std::string withPoints(std::string text)
{
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char next = i + 1 < text.size() ? text[i + 1] : '0';
        if (text[i] == ',' && next >= '0' && next <= '9')
            text[i] = '.';
    }
    return text;
}

} // namespace

Expected<double> evaluateQuantity(std::string_view text, ParamUnit unit, double plainFactor)
{
    constexpr std::string_view timesSign = "×";
    // The sign behind a factor: elsewhere it multiplies.
    if (unit == ParamUnit::Factor) {
        const std::size_t last = text.find_last_not_of(" \t") + 1;
        if (text.substr(0, last).ends_with(timesSign))
            text = text.substr(0, last - timesSign.size());
    }
    const std::string plain = withPoints(plainNotation(text));
    TextScanner scanner(plain, "", 1, true);
    return parseQuantity(scanner, unitsOf(unit, plainFactor));
}

} // namespace ramure
