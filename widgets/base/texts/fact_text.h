/// \file
/// How the inspector writes numbers: the locale's decimal sign, units behind, no number that is zero but for
/// rounding.
#pragma once

#include "widgets/base/texts/number_format.h"
#include <QString>
#include <glm/vec3.hpp>

namespace ramure::facttext {

/// Fixed decimals; never "-0.00".
QString number(double value, int decimals);
QString length(double metres);
/// Below a billionth of a radian an angle is shown as zero.
QString angle(double angleRad, AngleUnit unit);
QString anglePerMetre(double radPerMetre, AngleUnit unit);
QString curvature(double perMetre);
/// Three numbers, two spaces between; no unit.
QString vector(const glm::dvec3& v, int decimals);
/// The three numbers and the unit of length.
QString point(const glm::dvec3& metres, int decimals);

/// "°" or " rad" with the decimals and the factor of an angle of the inspector.
NumberFormat angleFormat(AngleUnit unit);

} // namespace ramure::facttext
