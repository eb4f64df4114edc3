/// \file
/// Values of a group on the clipboard: JSON, so that they can also be sent to somebody as text.
#pragma once

#include "core/params/param_def.h"
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

} // namespace ramure
