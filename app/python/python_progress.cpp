#include "app/python/python_progress.h"

namespace ramure::python {

namespace py = pybind11;

PythonProgress::PythonProgress(py::object callback)
    : m_callback(std::move(callback))
{
    if (!m_callback.is_none() && PyCallable_Check(m_callback.ptr()) == 0)
        throw py::type_error("progress has to be a function of one number, or None");
}

Progress PythonProgress::progress()
{
    return {m_stop.get_token(), [this](double fraction) { tell(fraction); }};
}

void PythonProgress::tell(double fraction)
{
    if (m_stop.stop_requested())
        return;
    const py::gil_scoped_acquire held;
    try {
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!m_callback.is_none())
            m_callback(fraction);
    } catch (py::error_already_set& raised) {
        m_raised.emplace(raised);
        m_stop.request_stop();
    }
}

void PythonProgress::rethrow()
{
    if (m_raised)
        throw py::error_already_set(*m_raised);
}

} // namespace ramure::python
