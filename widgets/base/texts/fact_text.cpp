#include "widgets/base/texts/fact_text.h"

#include <QLocale>
#include <cmath>
#include <numbers>

namespace ramure::facttext {
namespace {

constexpr double smallestAngle = 1e-9;
constexpr int lengthDecimals = 4;

double zeroIfTiny(double value, double tiny)
{
    return std::abs(value) < tiny ? 0.0 : value;
}

} // namespace

QString number(double value, int decimals)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double halfStep = 0.5 * std::pow(10.0, -decimals);
    if (std::abs(value) >= 1e9)
        return locale.toString(value, 'g', 6);
    return locale.toString(zeroIfTiny(value, halfStep), 'f', decimals);
}

NumberFormat angleFormat(AngleUnit unit)
{
    NumberFormat format;
    format.unit = ParamUnit::Radian;
    format.decimals = 2;
    format.factor = unit == AngleUnit::Degrees ? 180.0 / std::numbers::pi : 1.0;
    format.suffix = unit == AngleUnit::Degrees ? QStringLiteral("°") : QStringLiteral(" rad");
    if (unit == AngleUnit::Radians)
        format.decimals = 4;
    return format;
}

QString length(double metres)
{
    NumberFormat format;
    format.unit = ParamUnit::Metre;
    format.decimals = lengthDecimals;
    format.suffix = QStringLiteral(" m");
    return format.text(metres);
}

QString angle(double angleRad, AngleUnit unit)
{
    const NumberFormat format = angleFormat(unit);
    return number(zeroIfTiny(angleRad, smallestAngle) * format.factor, format.decimals) + format.suffix;
}

QString anglePerMetre(double radPerMetre, AngleUnit unit)
{
    return angle(radPerMetre, unit) + QStringLiteral("/m");
}

QString curvature(double perMetre)
{
    return number(perMetre, 3) + QStringLiteral(" 1/m");
}

QString vector(const glm::dvec3& v, int decimals)
{
    return QStringLiteral("%1  %2  %3")
        .arg(number(v.x, decimals), number(v.y, decimals), number(v.z, decimals));
}

QString point(const glm::dvec3& metres, int decimals)
{
    return vector(metres, decimals) + QStringLiteral("\u00a0m");
}

} // namespace ramure::facttext
