#include "app/python/values.h"

#include "app/python/errors.h"

#include <string>

namespace ramure::python {

namespace {

namespace py = pybind11;

constexpr const char* typeNames[] = {"bool", "int", "float", "str", "tuple", "str"};

[[noreturn]] void refuse(const ParamDef& def, const char* wanted, const py::handle& value)
{
    throw py::type_error(std::string(def.key) + ": " + wanted + " expected, not " +
                         std::string(py::str(py::type::handle_of(value).attr("__name__"))));
}

/// Of an int, a float, or what says that it is one, such as a number of NumPy; a bool is none.
double realOf(const ParamDef& def, const py::handle& value)
{
    const bool isNumber = PyFloat_Check(value.ptr()) || PyIndex_Check(value.ptr()) ||
                          (py::hasattr(value, "__float__") && !py::isinstance<py::str>(value));
    if (!isNumber || PyBool_Check(value.ptr()))
        refuse(def, "a number", value);
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred())
        throw py::error_already_set();
    return number;
}

std::int64_t wholeOf(const ParamDef& def, const py::handle& value)
{
    if (PyBool_Check(value.ptr()) || PyIndex_Check(value.ptr()) == 0)
        refuse(def, "a whole number", value);
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!index)
        throw py::error_already_set();
    int overflows = 0;
    const long long number = PyLong_AsLongLongAndOverflow(index.ptr(), &overflows);
    if (overflows != 0) {
        Raised raised{
            fail(ErrorCode::Invalid, "the number %1 is out of all range", {std::string(py::str(index))})
                .value()};
        raised.error.path = def.key;
        throw raised;
    }
    return number;
}

glm::dvec3 vectorOf(const ParamDef& def, const py::handle& value)
{
    if (!py::isinstance<py::sequence>(value) || py::isinstance<py::str>(value) || py::len(value) != 3)
        refuse(def, "three numbers", value);
    const auto list = py::reinterpret_borrow<py::sequence>(value);
    return {realOf(def, list[0]), realOf(def, list[1]), realOf(def, list[2])};
}

std::string textOf(const ParamDef& def, const char* wanted, const py::handle& value)
{
    if (!py::isinstance<py::str>(value))
        refuse(def, wanted, value);
    return value.cast<std::string>();
}

} // namespace

py::object toPython(const ParamValue& value)
{
    if (const auto* vector = std::get_if<glm::dvec3>(&value))
        return py::make_tuple(vector->x, vector->y, vector->z);
    if (const auto* choice = std::get_if<EnumValue>(&value))
        return py::str(choice->name);
    if (const auto* flag = std::get_if<bool>(&value))
        return py::bool_(*flag);
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return py::int_(*whole);
    if (const auto* real = std::get_if<double>(&value))
        return py::float_(*real);
    return py::str(std::get<std::string>(value));
}

ParamValue fromPython(const ParamDef& def, const py::handle& value)
{
    switch (def.type) {
    case ParamType::Bool:
        if (!std::string(py::str(py::type::handle_of(value).attr("__name__")))
                 .starts_with("bool")) // or NumPy's
            refuse(def, "True or False", value);
        return PyObject_IsTrue(value.ptr()) == 1;
    case ParamType::Int:
        return wholeOf(def, value);
    case ParamType::Real:
        return realOf(def, value);
    case ParamType::Vec3:
        return vectorOf(def, value);
    case ParamType::Enum:
        return EnumValue{textOf(def, "the name of a choice", value)};
    case ParamType::Text:
        break;
    }
    return textOf(def, "a text", value);
}

py::dict factsOf(const ParamDef& def)
{
    py::dict out;
    out["key"] = def.key;
    out["label"] = def.label;
    out["help"] = def.tooltip;
    out["type"] = typeNames[static_cast<std::size_t>(def.type)];
    out["default"] = toPython(defaultValue(def));
    if (def.type == ParamType::Int || def.type == ParamType::Real || def.type == ParamType::Vec3)
        out["range"] = py::make_tuple(def.hardMin, def.hardMax);
    if (def.type == ParamType::Enum) {
        py::list names;
        for (const EnumItem& item : def.items)
            names.append(item.name);
        out["choices"] = names;
    }
    return out;
}

} // namespace ramure::python
