/// \file
/// The condition of a step: which axes of a tree it acts on.
///
/// The language is that of the conditions of grammars (core/generators/parametric/expression.h), with "and",
/// "or" and "not" as words too. Names: order (0 = trunk), share (of the parent's length, where the axis
/// starts), s (the same in metres), length (m), radius (m, at the foot), azimuth (degrees about the parent),
/// angle (degrees from the parent), height (m, of the foot above the ground), forks (that the axis has) and
/// age, which is 0 for trees that did not grow over years.
#pragma once

#include "core/base/error.h"
#include "core/generators/parametric/expression.h"
#include "core/recipe/edit_tree.h"
#include <string_view>

namespace ramure {

class AxisFilter
{
public:
    /// Blank text means every axis. Errors: Syntax, Invalid, with the column; path = "step.where".
    static Expected<AxisFilter> parse(std::string_view text);

    /// One mark per axis of EditTree::axis(), set where the axis is there and the condition holds.
    [[nodiscard]] std::vector<bool> axesOf(const EditTree& tree) const;

private:
    Expression m_condition; ///< empty: always true
};

} // namespace ramure
