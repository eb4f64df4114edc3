#include "app/python/errors.h"

namespace ramure::python {

namespace {

namespace py = pybind11;

const char* nameOf(ErrorCode code)
{
    constexpr const char* names[] = {"invalid", "syntax", "limit", "io", "version", "unknown", "cancelled"};
    return names[static_cast<std::size_t>(code)];
}

/// What a text of the core says may quote the bytes of a file: none of them may spoil the message.
py::str textOf(const std::string& text)
{
    PyObject* const made =
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace");
    return py::reinterpret_steal<py::str>(made);
}

void setError(const Error& error)
{
    const py::object kind = py::module_::import("ramure.errors").attr("Error");
    const py::object made = kind(textOf(error.plain()), nameOf(error.code), textOf(error.file),
                                 textOf(error.path), error.line, error.column);
    PyErr_SetObject(kind.ptr(), made.ptr());
}

} // namespace

void registerErrors()
{
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown)
                std::rethrow_exception(std::move(thrown));
        } catch (const Raised& raised) {
            try {
                setError(raised.error);
            } catch (py::error_already_set& other) {
                other.restore();
            }
        }
    });
}

} // namespace ramure::python
