#include "app/python/arrays.h"

#include "core/skeleton/axes.h"

namespace ramure::python {

namespace {

namespace py = pybind11;

using Sizes = std::vector<py::ssize_t>;

template <class Item, class Number>
// NOLINTNEXTLINE(bugprone-sizeof-expression)
constexpr auto numbersIn = static_cast<py::ssize_t>(sizeof(Item) / sizeof(Number));

/// A numpy array over memory that \p owner keeps.
template <class Number>
py::array view(const void* data, Sizes shape, Sizes strides, const std::shared_ptr<const void>& owner)
{
    const py::capsule keeper(new std::shared_ptr<const void>(owner), [](void* held) {
        delete static_cast<std::shared_ptr<const void>*>(held); // NOLINT(cppcoreguidelines-owning-memory)
    });
    py::array made(py::dtype::of<Number>(), std::move(shape), std::move(strides), data, keeper);
    made.attr("setflags")(py::arg("write") = false);
    return made;
}

/// A list of numbers, or of vectors of so many numbers each.
template <class Number, class Item>
py::array listView(const std::vector<Item>& list, const std::shared_ptr<const void>& owner)
{
    static_assert(sizeof(Item) % sizeof(Number) == 0);
    constexpr py::ssize_t width = numbersIn<Item, Number>;
    const auto rows = static_cast<py::ssize_t>(list.size());
    constexpr auto size = static_cast<py::ssize_t>(sizeof(Number));
    if constexpr (width == 1)
        return view<Number>(list.data(), {rows}, {size}, owner);
    else
        return view<Number>(list.data(), {rows, width}, {width * size, size}, owner);
}

/// One member of each item of a list.
template <class Number, class Item, class Member>
py::array memberView(const std::vector<Item>& list, Member Item::*member,
                     const std::shared_ptr<const void>& owner)
{
    static_assert(sizeof(Member) % sizeof(Number) == 0);
    constexpr py::ssize_t width = numbersIn<Member, Number>;
    const void* const data = list.empty() ? nullptr : &(list.front().*member);
    const auto rows = static_cast<py::ssize_t>(list.size());
    constexpr auto step = static_cast<py::ssize_t>(sizeof(Item)),
                   size = static_cast<py::ssize_t>(sizeof(Number));
    if constexpr (width == 1)
        return view<Number>(data, {rows}, {step}, owner);
    else
        return view<Number>(data, {rows, width}, {step, size}, owner);
}

} // namespace

py::dict arraysOf(const std::shared_ptr<const TriangleMesh>& mesh)
{
    py::dict out;
    const auto add = [&](const char* name, const py::array& array) {
        if (array.size() > 0)
            out[name] = array;
    };
    out["positions"] = listView<float>(mesh->positions, mesh);
    out["triangles"] = listView<std::uint32_t>(mesh->triangles, mesh);
    add("normals", listView<float>(mesh->normals, mesh));
    add("uv", listView<float>(mesh->uv, mesh));
    add("uv_triangles", listView<std::uint32_t>(mesh->uvTriangles, mesh));
    add("branch", listView<std::int32_t>(mesh->branch, mesh)); // noIndex is -1
    add("level", listView<std::int32_t>(mesh->level, mesh));
    add("radius", listView<float>(mesh->radius, mesh));
    add("colours", listView<std::uint8_t>(mesh->colours, mesh));
    return out;
}

py::dict arraysOf(const std::shared_ptr<const Skeleton>& skeleton)
{
    py::dict out;
    out["parent"] = listView<std::int32_t>(skeleton->parent, skeleton);
    out["start"] = listView<double>(skeleton->p0, skeleton);
    out["end"] = listView<double>(skeleton->p1, skeleton);
    out["start_radius"] = listView<double>(skeleton->a0, skeleton);
    out["end_radius"] = listView<double>(skeleton->a1, skeleton);
    out["level"] = listView<std::int32_t>(skeleton->level, skeleton);
    out["key"] = listView<std::uint64_t>(skeleton->key, skeleton);
    return out;
}

py::dict axisArrays(const Skeleton& skeleton)
{
    const auto made = std::make_shared<const TreeAxes>(axesOf(skeleton));
    const std::vector<Axis>& axes = made->axes;
    py::dict out;
    out["address"] = memberView<std::uint64_t>(axes, &Axis::address, made);
    out["parent"] = memberView<std::int32_t>(axes, &Axis::parent, made);
    out["order"] = memberView<std::int32_t>(axes, &Axis::order, made);
    out["place"] = memberView<double>(axes, &Axis::s, made);
    out["share"] = memberView<double>(axes, &Axis::share, made);
    out["down_angle"] = memberView<double>(axes, &Axis::downAngle, made);
    out["azimuth"] = memberView<double>(axes, &Axis::azimuth, made);
    out["length"] = memberView<double>(axes, &Axis::length, made);
    out["radius"] = memberView<double>(axes, &Axis::radius, made);
    out["first"] = memberView<std::int32_t>(axes, &Axis::firstNode, made);
    out["count"] = memberView<std::int32_t>(axes, &Axis::nodes, made);
    out["branches"] = listView<std::int32_t>(made->nodes, made);
    out["axis_of_branch"] = listView<std::int32_t>(made->axisOf, made);
    return out;
}

py::dict arraysOf(const std::shared_ptr<const ExportCopies>& copies)
{
    const std::vector<ExportCopy>& list = copies->copies;
    py::dict out;
    constexpr auto number = static_cast<py::ssize_t>(sizeof(double));
    // The core's matrices lie column after column.
    out["matrices"] = view<double>(
        list.empty() ? nullptr : &list.front().place, {static_cast<py::ssize_t>(list.size()), 4, 4},
        {static_cast<py::ssize_t>(sizeof(ExportCopy)), number, 4 * number}, copies);
    out["tint"] = memberView<float>(list, &ExportCopy::tint, copies);
    out["branch"] = memberView<std::int32_t>(list, &ExportCopy::branch, copies);
    out["kind"] = copies->kind;
    out["shape"] = arraysOf(copies->shape);
    return out;
}

} // namespace ramure::python
