/// \file
/// Arithmetic as an artist types it into a number field: "2*pi/10", "18 deg", "20cm + 5mm".
///
///     sum      = product { ("+" | "-") product }
///     product  = power { ("*" | "/") power }
///     power    = signed [ "^" power ]
///     signed   = { "+" | "-" } unit
///     unit     = primary [ name of a unit ]
///     primary  = number | "pi" | "tau" | function "(" sum ")" | "(" sum ")"
///
/// Units: rad, deg, °, turn for angles; m, km, cm, mm, in, ft for lengths; % everywhere. Functions: sqrt,
/// sin, cos, tan (of radians), abs. Both the point and the comma are decimal signs.
#pragma once

#include "core/base/error.h"
#include "core/params/param_def.h"
#include <QStringView>

namespace ramure {

/// \param unit what the value means inside the program: decides which units are understood.
/// \param plainFactor what a number without a unit is multiplied by, to get from the unit shown in the
/// interface to that of the program. An angle made with pi or tau is in radians whatever is shown. Errors:
/// Syntax with column (1-based), Invalid where the result is not finite or the units do not fit.
Expected<double> evaluateExpression(QStringView text, ParamUnit unit, double plainFactor = 1.0);

} // namespace ramure
