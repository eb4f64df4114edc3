#include "widgets/base/texts/number_format.h"

#include "core/generators/parametric/quantity.h"
#include "widgets/base/texts/core_text.h"
#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
/// Decimals of small values, on top of the usual ones.
constexpr int moreForAngles = 2;
constexpr int moreForLengths = 4;
constexpr double openEnd =
    1e9; ///< limits from here on are only there to keep numbers sane: not worth telling

} // namespace

QString NumberFormat::text(double value) const
{
    if (value == 0.0 && !atZero.isEmpty())
        return atZero;
    double shown = value * factor;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    if (whole)
        return locale.toString(std::round(shown) + 0.0, 'f', 0) + suffix; // -0 becomes 0
    if (std::abs(shown) >= 1e9)
        return locale.toString(shown, 'g', 9) + suffix;
    const int mostDigits = decimals + (unit == ParamUnit::Radian ? moreForAngles : moreForLengths);
    if (std::abs(shown) <= 0.5 * std::pow(10.0, -mostDigits))
        shown = 0.0;
    int digits = decimals;
    if (shown != 0.0 && std::abs(shown) < 1.0)
        digits =
            std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(shown)))), decimals, mostDigits);
    QString result = locale.toString(shown, 'f', digits);
    // Decimals beyond the second only where they say something: 0.3142, but 0.20 and not 0.2000.
    for (; digits > std::min(decimals, 2) && result.endsWith(u'0'); --digits)
        result.chop(1);
    return result + suffix;
}

Expected<double> NumberFormat::parse(const QString& text) const
{
    if (!atZero.isEmpty() && text == atZero)
        return 0.0;
    auto value = evaluateQuantity(text.toStdString(), unit, 1.0 / factor);
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
    case ParamUnit::Share:
        format.factor = 100.0;
        format.suffix = QStringLiteral(" %");
        format.decimals = std::max(0, def.decimals - 2);
        break;
    case ParamUnit::Kilogram:
        format.suffix = QStringLiteral(" kg");
        break;
    case ParamUnit::Factor:
        format.suffix = QStringLiteral(" ×");
        break;
    case ParamUnit::Year:
        format.suffix = u' ' + coreText(RAMURE_NOOP("yr"));
        break;
    case ParamUnit::Day:
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
