/// \file
/// What there is to know of a parameter besides its name and description, in words: for tool tips and the
/// handbook.
#pragma once

#include "widgets/base/texts/number_format.h"
#include <QList>
#include <string>
#include <utility>

namespace ramure {

/// Unit, range, default and, where it is another one, the value in \p preset as (name, value), those that it
/// has.
QList<std::pair<QString, QString>> paramFacts(const ParamDef& def, AngleUnit unit,
                                              const std::string& preset = {});

/// What a number means in a unit of the world, to stand below it: "about 4.0 m/s". Empty where it says all
/// itself.
QString paramMeaning(const ParamDef& def, const ParamValue& value);

} // namespace ramure
