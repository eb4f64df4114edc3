#include "core/params/recipe.h"

#include "core/params/tree_edit_table.h"
#include <algorithm>
#include <charconv>

namespace ramure {
namespace {

constexpr std::string_view named = "step:";

bool has(EditOperation operation, const ParamDef& def)
{
    return std::ranges::count(stepParams(operation), &def) > 0;
}

bool isOfStep(const NodeParams& params, StepNumber step, const ParamDef& def)
{
    // How a source stands on others is none of the first one's business.
    if (step == 0)
        return hasParam(NodeKind::Tree, def) && has(params.generator.kind, def);
    return has(params.edits[step - 1].operation, def);
}

Expected<void> setAt(NodeParams& params, StepNumber step, const ParamDef& def, const ParamValue& value)
{
    if (step == 0)
        return setParam(params, def, value);
    NodeParams values = *params.edits[step - 1].values;
    RAMURE_TRY(setParam(values, def, value));
    params.edits[step - 1].values = StepValues(std::move(values));
    return {};
}

} // namespace

bool isOfSteps(const ParamDef& def)
{
    return std::ranges::any_of(editOperations(),
                               [&def](const EditOperationInfo& info) { return has(info.operation, def); });
}

std::string stepName(const NodeParams& params, StepNumber step)
{
    if (step == 0)
        return infoOf(params.generator.kind).key;
    const TreeEdit& edit = params.edits[step - 1];
    return edit.name.empty() ? infoOf(edit.operation).key : edit.name;
}

std::string stepNames(const NodeParams& params)
{
    constexpr StepNumber most = 12; // in one line
    std::string names;
    const StepNumber count = params.edits.size() + 1;
    for (StepNumber i = 0; i < std::min(count, most); ++i)
        names.append(i > 0 ? ", " : "").append(std::to_string(i + 1)).append(" ").append(stepName(params, i));
    return count > most ? names + ", ..." : names;
}

Expected<StepNumber> findStep(const NodeParams& params, std::string_view text)
{
    const StepNumber count = params.edits.size() + 1;
    if (text.starts_with('#')) {
        StepNumber number = 0;
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
        if (error == std::errc() && end == text.data() + text.size() && number >= 1 && number <= count)
            return number - 1;
    }
    std::vector<StepNumber> found;
    for (StepNumber i = 0; i < count; ++i)
        if (stepName(params, i) == text)
            found.push_back(i);
    if (found.size() == 1)
        return found.front();
    return found.empty()
               ? fail(ErrorCode::Unknown, RAMURE_NOOP("there is no step \"%1\"; there are: %2"),
                      {std::string(text), stepNames(params)})
               : fail(ErrorCode::Invalid, RAMURE_NOOP("several steps are called \"%1\": #N names one of %2"),
                      {std::string(text), stepNames(params)});
}

Expected<RecipeKey> parseRecipeKey(std::string_view text)
{
    const auto unknown =
        fail(ErrorCode::Unknown,
             RAMURE_NOOP("unknown parameter \"%1\": `ramure-cli list params` shows those there are"),
             {std::string(text)});
    if (!text.starts_with('#') && !text.starts_with(named)) {
        const ParamDef* def = findParam(text);
        return def ? Expected<RecipeKey>({{}, def}) : unknown;
    }
    const std::string_view rest = text.starts_with('#') ? text : text.substr(named.size());
    // Names may have dots: the key is what the table knows.
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.', dot + 1))
        if (const ParamDef* def = findParam(rest.substr(dot + 1)))
            return RecipeKey{std::string(rest.substr(0, dot)), def};
    return unknown;
}

static Expected<StepNumber> stepOf(const NodeParams& params, const RecipeKey& key)
{
    const ParamDef& def = *key.def;
    if (!key.step.empty()) {
        const auto step = findStep(params, key.step);
        RAMURE_TRY(step);
        if (isOfStep(params, *step, def) || (*step == 0 && !isOfSteps(def)))
            return *step;
        return fail(ErrorCode::Unknown, RAMURE_NOOP("the step \"%1\" has no \"%2\""),
                    {stepName(params, *step), def.key});
    }
    if (!isOfSteps(def))
        return StepNumber(0);
    std::vector<StepNumber> steps;
    for (StepNumber i = 0; i <= params.edits.size(); ++i)
        if (isOfStep(params, i, def))
            steps.push_back(i);
    if (steps.size() == 1)
        return steps.front();
    return steps.empty()
               ? fail(ErrorCode::Unknown, RAMURE_NOOP("no step has \"%1\"; there are: %2"),
                      {def.key, stepNames(params)})
               : fail(ErrorCode::Invalid, RAMURE_NOOP("several steps have \"%1\": #N.%1 names one of %2"),
                      {def.key, stepNames(params)});
}

Expected<void> setRecipeValue(NodeParams& params, const RecipeKey& key, const ParamValue& value)
{
    const auto step = stepOf(params, key);
    RAMURE_TRY(step);
    return setAt(params, *step, *key.def, value);
}

Expected<ParamValue> recipeValue(const NodeParams& params, const RecipeKey& key)
{
    const auto step = stepOf(params, key);
    RAMURE_TRY(step);
    return key.def->get(*step == 0 ? params : *params.edits[*step - 1].values);
}

} // namespace ramure
