/// \file
/// Values on the clipboard: those of a group as JSON, so that they can also be sent to somebody as text; a
/// single one as a text that any field for numbers and the command line can read.
#pragma once

#include "core/params/param_def.h"
#include "widgets/base/texts/number_format.h"
#include <QString>
#include <utility>
#include <vector>

namespace ramure {

using ParamList = std::vector<std::pair<const ParamDef*, ParamValue>>;

/// {"ramure-parameters": {"turtle.theta": "0.3142", ...}}: values as the command line writes them.
QString writeParamList(const ParamList& values);
/// Unknown keys are skipped. Errors: Syntax (no such text), and those of parseValue and checkValue (path =
/// key).
Expected<ParamList> readParamList(const QString& text);

/// The value with its unit, such as "0.3142 rad"; pasted into a parameter of this program it is exact.
void copyValue(const ParamDef& def, const ParamValue& value);
/// What was copied, of this parameter or of another one of the same type, or any text that the parameter's
/// editor reads. Errors: Syntax, Invalid (path = key); the range is left to checkValue.
Expected<ParamValue> pastedValue(const ParamDef& def, AngleUnit unit);
/// `--set turtle.theta=0.3142`, quoted for a shell where it must be.
QString settingText(const ParamDef& def, const ParamValue& value);

} // namespace ramure
