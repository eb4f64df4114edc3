/// \file
/// Errors of the core as exceptions of Python: ramure.Error with the reason, the code, the file, the path
/// inside it, the line and the column.
#pragma once

#include "app/python/python_api.h"
#include "core/base/error.h"

namespace ramure::python {

/// Carries an error to the translator that registerErrors() leaves behind.
struct Raised
{
    Error error;
};

/// Has to be called once, by the module. The class itself is Python's: ramure.errors.Error.
void registerErrors();

/// Returns the value. \throws Raised
template <class T> T taken(Expected<T> value)
{
    if (!value)
        throw Raised{std::move(value.error())};
    if constexpr (!std::is_void_v<T>)
        return std::move(*value);
}

/// \throws Raised
[[noreturn]] inline void raise(ErrorCode code, const char* text, std::vector<std::string> args = {})
{
    throw Raised{fail(code, text, std::move(args)).value()};
}

} // namespace ramure::python
