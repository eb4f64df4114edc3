/// \file
/// The recipe of a tree as one list: the source that it begins with, whose values are the node's own
/// parameters, and the steps behind it (NodeParams::edits). How texts name a step, and a value inside one.
#pragma once

#include "core/params/param_def.h"
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

/// Number of a step: 0 is the source that the recipe begins with, i > 0 is NodeParams::edits[i - 1].
using StepNumber = std::size_t;

/// Returns the English name of a step: its own name, else its kind's key, "weberPenn".
std::string stepName(const NodeParams& params, StepNumber step);
/// "1 weberPenn, 2 sag": for messages.
std::string stepNames(const NodeParams& params);
/// The step that a text names: "#2" counts from 1, anything else is a name. Errors: Unknown (none, or no such
/// number), Invalid (several are called so).
Expected<StepNumber> findStep(const NodeParams& params, std::string_view text);

/// Whether some kind of step has the parameter.
bool isOfSteps(const ParamDef& def);

/// A value of a recipe, as `--set` and the columns of tables name it.
struct RecipeKey
{
    std::string step; ///< "#2" or a name; empty: the only step that has the parameter
    const ParamDef* def = nullptr;
};
/// "weberPenn.levels", "#2.sag.amount", "step:Old limbs.sag.amount". Error: Unknown (no such parameter).
Expected<RecipeKey> parseRecipeKey(std::string_view text);

/// Sets a value of the node or of one of its steps. Errors, and then nothing is changed: those of findStep
/// and setParam; Unknown where no step has the parameter, Invalid where several have it: both name the steps.
Expected<void> setRecipeValue(NodeParams& params, const RecipeKey& key, const ParamValue& value);
/// Returns the value that setRecipeValue() would change. Errors: likewise.
Expected<ParamValue> recipeValue(const NodeParams& params, const RecipeKey& key);

} // namespace ramure
