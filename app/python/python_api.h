/// \file
/// The interpreter's headers, whatever stands before them: Qt takes the word `slots` for itself.
#pragma once

#pragma push_macro("slots")
#undef slots
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#pragma pop_macro("slots")
