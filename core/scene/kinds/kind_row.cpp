#include "core/params/param_def.h"
#include "core/scene/kinds/node_kinds.h"

#include <algorithm>
#include <functional>
#include <string>

namespace ramure {
namespace {

/// Adds a value as one number, or three.
struct Adder
{
    const ParamDef& def;
    std::vector<double>& numbers;

    template <class Number> void operator()(Number value) const { numbers.push_back(double(value)); }
    void operator()(const std::string& text) const { (*this)(std::hash<std::string>()(text)); }
    void operator()(const glm::dvec3& v) const { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }
    void operator()(const EnumValue& value) const
    {
        (*this)(
            std::ranges::find_if(def.items, [&](const EnumItem& item) { return value.name == item.name; }) -
            def.items.begin());
    }
};

} // namespace

const NodeKindRow& kindRow(NodeKind kind)
{
    static constexpr NodeKindRow unknown{
        .kind = NodeKind::Unknown,
        .icon = "info",
        .word = RAMURE_NOOP("node"),
        .tip = RAMURE_NOOP("%1: this version of Ramure does not know its kind")};
    const auto kinds = nodeKinds();
    const auto found = std::ranges::find(kinds, kind, &NodeKindRow::kind);
    return found == kinds.end() ? unknown : **found;
}

const NodeKindRow* findKind(std::string_view name)
{
    for (const NodeKindRow* row : nodeKinds())
        if (name == row->name)
            return row;
    return nullptr;
}

std::vector<double> ownNumbers(NodeKind kind, const NodeParams& params)
{
    std::vector<double> numbers{double(kind)};
    for (const ParamDef& def : paramTable())
        if (def.kinds == kindBit(kind))
            std::visit(Adder{def, numbers}, def.get(params));
    return numbers;
}

} // namespace ramure
