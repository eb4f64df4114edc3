/// \file
/// The value of a number field.
#pragma once

#include "core/base/error.h"
#include "core/params/param_def.h"
#include <string_view>

namespace ramure {

/// Arithmetic as an artist types it into a number field: "2*pi/10", "18 deg", "20cm + 5mm". Point and comma
/// are both decimal signs; a comma that parts two arguments needs a blank behind it. Signs of formulas such
/// as the typographic minus are understood.
///
/// Units: rad, deg, °, turn for angles; m, km, cm, mm, in, ft for lengths; s, ms, min; kg, g; % everywhere.
/// sin, cos and tan take degrees, or radians of a number made with pi or tau.
///
/// \param unit what the value means inside the program: decides which units are understood.
/// \param plainFactor what a number without a unit is multiplied by, to get from the unit shown in the
/// interface to that of the program. An angle made with pi or tau is in radians whatever is shown.
/// Errors: Syntax with column (1-based, in bytes), Limit, Invalid where the result is not finite.
Expected<double> evaluateQuantity(std::string_view text, ParamUnit unit, double plainFactor = 1.0);

} // namespace ramure
