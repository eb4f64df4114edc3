#include "app/python/bindings.h"
#include "app/python/values.h"
#include "core/params/recipe.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/edit_script.h"
#include "core/qt/document/project/project_edits.h"
#include <QJsonDocument>
#include <algorithm>

namespace ramure::python {

namespace {

namespace py = pybind11;

/// A step is known by its id, wherever it stands; 0 is the source that the recipe begins with.
Expected<StepNumber> numberOf(const NodeParams& params, std::uint64_t step)
{
    if (step == 0)
        return StepNumber(0);
    const auto found = std::ranges::find(params.edits, step, &TreeEdit::id);
    if (found == params.edits.end())
        return fail(ErrorCode::Unknown, "the step is no longer there");
    return static_cast<StepNumber>(found - params.edits.begin()) + 1;
}

/// Changes the recipe of a tree by act(params, number), which returns Expected<void>; an error leaves it as
/// it was.
template <class Act> void change(Work& work, NodeId tree, std::uint64_t step, Act&& act)
{
    work.run(py::none(), [&](const Progress&) -> Expected<void> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        NodeParams params = (*node)->params;
        const auto number = numberOf(params, step);
        RAMURE_TRY(number);
        RAMURE_TRY(act(params, *number));
        (*node)->params = std::move(params);
        work.touched();
        return {};
    });
}

Expected<std::size_t> placeOf(StepNumber number)
{
    if (number == 0)
        return fail(ErrorCode::Invalid, "the source that a recipe begins with stays where it is");
    return number - 1;
}

RecipeKey stepKey(const std::string& key)
{
    RecipeKey found = taken(parseRecipeKey(key));
    if (!found.step.empty())
        raise(ErrorCode::Invalid, "\"%1\": a step's own parameter expected", {key});
    return found;
}

/// Id, kind, name and whether it is switched on, of each step.
py::list steps(Work& work, NodeId tree)
{
    const auto params = work.run(py::none(), [&](const Progress&) -> Expected<NodeParams> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        return (*node)->params;
    });
    py::list out;
    out.append(py::make_tuple(0, infoOf(params.generator.kind).key, stepName(params, 0), true));
    for (std::size_t i = 0; i < params.edits.size(); ++i) {
        const TreeEdit& edit = params.edits[i];
        out.append(
            py::make_tuple(edit.id, infoOf(edit.operation).key, stepName(params, i + 1), edit.enabled));
    }
    return out;
}

py::object stepValue(Work& work, NodeId tree, std::uint64_t step, const std::string& text)
{
    RecipeKey key = stepKey(text);
    return toPython(work.run(py::none(), [&](const Progress&) -> Expected<ParamValue> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        const auto number = numberOf((*node)->params, step);
        RAMURE_TRY(number);
        key.step = "#" + std::to_string(*number + 1);
        return recipeValue((*node)->params, key);
    }));
}

void setStepValue(Work& work, NodeId tree, std::uint64_t step, const std::string& text,
                  const py::handle& given)
{
    RecipeKey key = stepKey(text);
    const ParamValue wanted = fromPython(*key.def, given);
    change(work, tree, step, [&](NodeParams& params, StepNumber number) {
        key.step = "#" + std::to_string(number + 1);
        return setRecipeValue(params, key, wanted);
    });
}

/// \param place from 1 on; 0: behind all. Returns the id.
std::uint64_t addStep(Work& work, NodeId tree, const std::string& kind, std::size_t place,
                      const std::string& name, const py::dict& values)
{
    const EditOperationInfo* const info = editOperationOf(kind);
    if (!info || info->rows[0] == '\0')
        raise(ErrorCode::Unknown, "\"%1\" is no modifier and no source: hand edits are made by edit()",
              {kind});
    std::vector<std::pair<RecipeKey, ParamValue>> wanted;
    for (const auto& [key, given] : values) {
        RecipeKey found = stepKey(key.cast<std::string>());
        ParamValue read = fromPython(*found.def, given);
        wanted.emplace_back(std::move(found), std::move(read));
    }
    std::uint64_t id = 0;
    change(work, tree, 0, [&](NodeParams& params, StepNumber) -> Expected<void> {
        TreeEdit made = newStep(info->operation);
        made.name = name;
        made.id = id = newEditId(params.edits, made);
        const std::size_t at = std::min(place == 0 ? params.edits.size() : place - 1, params.edits.size());
        params.edits.insert(params.edits.begin() + static_cast<std::ptrdiff_t>(at), std::move(made));
        for (auto& [key, read] : wanted) {
            key.step = "#" + std::to_string(at + 2);
            RAMURE_TRY(setRecipeValue(params, key, read));
        }
        return {};
    });
    return id;
}

void removeStep(Work& work, NodeId tree, std::uint64_t step)
{
    change(work, tree, step, [](NodeParams& params, StepNumber number) -> Expected<void> {
        const auto at = placeOf(number);
        RAMURE_TRY(at);
        params.edits.erase(params.edits.begin() + static_cast<std::ptrdiff_t>(*at));
        return {};
    });
}

/// \param place from 1 on
void moveStep(Work& work, NodeId tree, std::uint64_t step, std::size_t place)
{
    change(work, tree, step, [&](NodeParams& params, StepNumber number) -> Expected<void> {
        const auto from = placeOf(number);
        RAMURE_TRY(from);
        if (place < 1 || place > params.edits.size())
            return fail(ErrorCode::Invalid, "there are %1 places behind the source",
                        {std::to_string(params.edits.size())});
        TreeEdit moved = std::move(params.edits[*from]);
        params.edits.erase(params.edits.begin() + static_cast<std::ptrdiff_t>(*from));
        params.edits.insert(params.edits.begin() + static_cast<std::ptrdiff_t>(place - 1), std::move(moved));
        return {};
    });
}

void enableStep(Work& work, NodeId tree, std::uint64_t step, bool on)
{
    change(work, tree, step, [on](NodeParams& params, StepNumber number) -> Expected<void> {
        const auto at = placeOf(number);
        RAMURE_TRY(at);
        params.edits[*at].enabled = on;
        return {};
    });
}

void renameStep(Work& work, NodeId tree, std::uint64_t step, const std::string& name)
{
    change(work, tree, step, [&](NodeParams& params, StepNumber number) -> Expected<void> {
        const auto at = placeOf(number);
        RAMURE_TRY(at);
        params.edits[*at].name = name;
        return {};
    });
}

/// What became of a step when the tree grew: its state, and why.
py::tuple stepState(Work& work, NodeId tree, std::uint64_t step, const py::object& callback)
{
    using State = std::pair<std::string, std::string>;
    const State state = work.run(callback, [&](const Progress& progress) -> Expected<State> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        const auto number = numberOf((*node)->params, step);
        RAMURE_TRY(number);
        const auto grown = work.grown(tree, Stage::Skeleton, progress);
        RAMURE_TRY(grown);
        if (*number == 0 || !grown->edits)
            return State("placed", "");
        const EditOutcome& outcome = (*grown->edits)[*number - 1];
        return State(cli::stateName(outcome.state), outcome.why.plain());
    });
    return py::make_tuple(state.first, state.second);
}

/// The steps of hands as project files have them, as JSON.
std::string stepData(Work& work, NodeId tree, std::uint64_t step)
{
    return work.run(py::none(), [&](const Progress&) -> Expected<std::string> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        const auto number = numberOf((*node)->params, step);
        RAMURE_TRY(number);
        const auto at = placeOf(*number);
        RAMURE_TRY(at);
        return QJsonDocument(json::writeEdits({(*node)->params.edits[*at]})).toJson().toStdString();
    });
}

void edit(Work& work, NodeId tree, const std::string& script)
{
    work.run(py::none(), [&](const Progress&) -> Expected<void> {
        const auto scene = work.scene();
        RAMURE_TRY(scene);
        Document document;
        document.reset(**scene, {}, {});
        RAMURE_TRY(replayEdits(document, tree, QByteArray::fromStdString(script)));
        **scene = document.scene();
        work.touched();
        return {};
    });
}

} // namespace

void bindSteps(py::class_<Work, std::shared_ptr<Work>>& work)
{
    work.def("steps", &steps, py::arg("tree"));
    work.def("step_value", &stepValue, py::arg("tree"), py::arg("step"), py::arg("key"));
    work.def("set_step_value", &setStepValue, py::arg("tree"), py::arg("step"), py::arg("key"),
             py::arg("value"));
    work.def("add_step", &addStep, py::arg("tree"), py::arg("kind"), py::arg("place"), py::arg("name"),
             py::arg("values"));
    work.def("remove_step", &removeStep, py::arg("tree"), py::arg("step"));
    work.def("move_step", &moveStep, py::arg("tree"), py::arg("step"), py::arg("place"));
    work.def("enable_step", &enableStep, py::arg("tree"), py::arg("step"), py::arg("on"));
    work.def("rename_step", &renameStep, py::arg("tree"), py::arg("step"), py::arg("name"));
    work.def("step_state", &stepState, py::arg("tree"), py::arg("step"), py::arg("progress"));
    work.def("step_data", &stepData, py::arg("tree"), py::arg("step"));
    work.def("edit", &edit, py::arg("tree"), py::arg("script"));
}

} // namespace ramure::python
