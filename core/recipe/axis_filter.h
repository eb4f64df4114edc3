/// \file
/// The condition of a step: which axes of a tree it acts on.
///
/// The language is that of the conditions of grammars (core/generators/parametric/expression.h), with "and",
/// "or" and "not" as words too. Names: order (0 = trunk), share (of the parent's length, where the axis
/// starts), s (the same in metres), length (m), radius (m, at the foot), azimuth (degrees about the parent),
/// angle (degrees from the parent), height (m, of the foot above the ground), forks (that the axis has) and
/// age, which is 0 for trees that did not grow over years.
///
/// Or a list of axes by their addresses: "axes 00c1f3…, 9be04a…", each in hexadecimal digits.
#pragma once

#include "core/base/error.h"
#include "core/generators/parametric/expression.h"
#include "core/recipe/edit_tree.h"
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

class AxisFilter
{
public:
    /// The text of a list.
    static std::string ofAxes(std::span<const std::uint64_t> addresses);
    /// Blank text means every axis. Errors: Syntax, Invalid, with the column; path = "step.where".
    static Expected<AxisFilter> parse(std::string_view text);

    /// One mark per axis of EditTree::axis(), set where the axis is there and the condition holds.
    [[nodiscard]] std::vector<bool> axesOf(const EditTree& tree) const;

private:
    Expression m_condition;                 ///< empty: always true
    std::vector<std::uint64_t> m_addresses; ///< ascending; not empty: those alone
};

} // namespace ramure
