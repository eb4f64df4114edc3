/// \file
/// Facts about a parameter besides its name and description, in words: for tool tips and the handbook.
#pragma once

#include "widgets/base/texts/number_format.h"
#include <QList>
#include <string>
#include <utility>

namespace ramure {

/// Returns pairs of name and value: unit, range, default and, if it differs, the value in \p preset.
QList<std::pair<QString, QString>> paramFacts(const ParamDef& def, AngleUnit unit,
                                              const std::string& preset = {});

/// Explains a value in a unit of the world, to be shown below the field: "about 4.0 m/s". Empty if the value
/// explains itself.
QString paramMeaning(const ParamDef& def, const ParamValue& value);

} // namespace ramure
