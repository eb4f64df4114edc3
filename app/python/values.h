/// \file
/// Values of parameters between Python and the table.
#pragma once

#include "app/python/python_api.h"
#include "core/params/param_def.h"

namespace ramure::python {

/// A bool, an int, a float, a str, a tuple of three floats, or the name of a choice.
pybind11::object toPython(const ParamValue& value);
/// Numbers of NumPy are numbers. The range is left to setParam(). \throws pybind11::type_error with the key
ParamValue fromPython(const ParamDef& def, const pybind11::handle& value);
/// All that the table says of a parameter, as a dict.
pybind11::dict factsOf(const ParamDef& def);

} // namespace ramure::python
