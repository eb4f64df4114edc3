/// \file
/// A callback of Python as the Progress of a long function.
#pragma once

#include "app/python/python_api.h"
#include "core/base/progress.h"
#include <optional>

namespace ramure::python {

/// Calls a function of Python with the fraction that is done. If it raises, or somebody presses Ctrl+C, the
/// work is asked to stop, and rethrow() gives the exception back.
class PythonProgress
{
public:
    /// \param callback None: nobody is told; Ctrl+C is still heard.
    explicit PythonProgress(pybind11::object callback);
    PythonProgress(const PythonProgress&) = delete;
    PythonProgress& operator=(const PythonProgress&) = delete;

    /// Works on any thread that does not hold the interpreter's lock. Valid as long as this object.
    [[nodiscard]] Progress progress();
    /// \throws pybind11::error_already_set
    void rethrow();

private:
    void tell(double fraction);

    pybind11::object m_callback;
    std::stop_source m_stop;
    std::optional<pybind11::error_already_set> m_raised; ///< guarded by the interpreter's lock
};

} // namespace ramure::python
