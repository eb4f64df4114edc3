/// \file
/// Which editor a row of the parameter table gets.
#pragma once

#include "widgets/panels/properties/param_editor.h"

namespace ramure {

/// Never null: every type of parameter has an editor.
ParamEditor* makeParamEditor(const ParamDef& def, QWidget* parent);

} // namespace ramure
