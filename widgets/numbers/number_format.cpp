#include "widgets/numbers/number_format.h"

#include "widgets/numbers/expression.h"
#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <limits>
#include <numbers>

namespace ramure {
namespace {

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
constexpr double openEnd =
    1e9; ///< limits from here on are only there to keep numbers sane: not worth telling

} // namespace

QString NumberFormat::text(double value) const
{
    const double shown = value * factor;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    if (whole)
        return locale.toString(std::round(shown), 'f', 0) + suffix;
    if (std::abs(shown) >= 1e9)
        return locale.toString(shown, 'g', 9) + suffix;
    int digits = decimals;
    if (shown != 0.0 && std::abs(shown) < 1.0)
        digits = std::max(digits, 2 - static_cast<int>(std::floor(std::log10(std::abs(shown)))));
    if (digits > decimals + 6)
        return locale.toString(shown, 'g', 3) + suffix;
    QString result = locale.toString(shown, 'f', digits);
    // Decimals beyond the second only where they say something: 0.3142, but 0.20 and not 0.2000.
    for (; digits > std::min(decimals, 2) && result.endsWith(u'0'); --digits)
        result.chop(1);
    return result + suffix;
}

Expected<double> NumberFormat::parse(const QString& text) const
{
    auto value = evaluateExpression(text, unit, 1.0 / factor);
    if (value && whole)
        *value = std::round(*value);
    return value;
}

NumberFormat numberFormat(const ParamDef& def, AngleUnit angles)
{
    NumberFormat format;
    format.unit = def.unit;
    format.decimals = def.decimals;
    format.whole = def.type == ParamType::Int;
    switch (def.unit) {
    case ParamUnit::Metre:
        format.suffix = QStringLiteral(" m");
        break;
    case ParamUnit::Radian:
        if (angles == AngleUnit::Degrees) {
            format.factor = degreesPerRadian;
            format.suffix = QStringLiteral("°");
            format.decimals = std::max(1, def.decimals - 2);
        } else {
            format.suffix = QStringLiteral(" rad");
        }
        break;
    case ParamUnit::Degree:
        format.suffix = QStringLiteral("°");
        break;
    case ParamUnit::Second:
        format.suffix = QStringLiteral(" s");
        break;
    case ParamUnit::None:
    case ParamUnit::Ratio:
    case ParamUnit::Count:
        break;
    }
    return format;
}

QString rangeText(const ParamDef& def, AngleUnit angles)
{
    if (def.type == ParamType::Bool || def.type == ParamType::Text || def.type == ParamType::Enum)
        return {};
    const NumberFormat format = numberFormat(def, angles);
    const bool low = def.hardMin > -openEnd;
    const bool high = def.hardMax < openEnd;
    if (low && high)
        return QCoreApplication::translate("Numbers", "%1 to %2")
            .arg(format.text(def.hardMin), format.text(def.hardMax));
    if (low)
        return QCoreApplication::translate("Numbers", "at least %1").arg(format.text(def.hardMin));
    if (high)
        return QCoreApplication::translate("Numbers", "at most %1").arg(format.text(def.hardMax));
    return {};
}

} // namespace ramure
