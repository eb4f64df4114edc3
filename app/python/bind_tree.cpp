#include "app/cli/export_options.h"
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/values.h"
#include "core/params/recipe.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/session/export/exporter.h"

namespace ramure::python {

namespace {

namespace py = pybind11;

py::object value(Work& work, NodeId tree, const std::string& text)
{
    const RecipeKey key = taken(parseRecipeKey(text));
    return toPython(work.run(py::none(), [&](const Progress&) -> Expected<ParamValue> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        return recipeValue((*node)->params, key);
    }));
}

void setValue(Work& work, NodeId tree, const std::string& text, const py::handle& given)
{
    const RecipeKey key = taken(parseRecipeKey(text));
    const ParamValue wanted = fromPython(*key.def, given);
    work.run(py::none(), [&](const Progress&) -> Expected<void> {
        const auto node = work.tree(tree);
        RAMURE_TRY(node);
        RAMURE_TRY(setRecipeValue((*node)->params, key, wanted));
        work.touched();
        return {};
    });
}

void grow(Work& work, NodeId tree, const py::object& callback)
{
    work.run(callback, [&](const Progress& progress) -> Expected<void> {
        RAMURE_TRY(work.grown(tree, Stage::Foliage, progress));
        return {};
    });
}

/// The meshes that an export with these options would write, and the copies of leaves and fruit.
ExportScene collected(Work& work, NodeId tree, const std::vector<std::string>& words,
                      const py::object& callback)
{
    QStringList arguments{QStringLiteral("tree")};
    for (const std::string& word : words)
        arguments << pathText(word);
    return work.run(callback, [&](const Progress& progress) -> Expected<ExportScene> {
        cli::CommandLine line({"export", "", "INPUT", "", ""});
        cli::addExportOptions(line, ofExport);
        RAMURE_TRY(line.parse(arguments));
        auto options = cli::exportOptionsOf(line, ofExport);
        RAMURE_TRY(options);
        RAMURE_TRY(work.tree(tree));
        options->nodes = {tree};
        options->hidden = true;
        Evaluator evaluator(pipelineSource(work.pipeline()));
        return collectExport(evaluator.at(*work.input().scene()), *options, progress);
    });
}

py::list meshes(Work& work, NodeId tree, const std::vector<std::string>& words, const py::object& callback)
{
    py::list out;
    for (const ExportMesh& mesh : collected(work, tree, words, callback).meshes) {
        py::dict entry = arraysOf(mesh.mesh);
        entry["name"] = mesh.name;
        entry["lod"] = mesh.level;
        out.append(entry);
    }
    return out;
}

py::dict copies(Work& work, NodeId tree, bool texture, const py::object& callback)
{
    const std::vector<std::string> words{"--leaves", "instances", texture ? "--texture" : "--no-texture"};
    py::dict out;
    for (ExportCopies& each : collected(work, tree, words, callback).copies) {
        const std::string name = each.name;
        out[py::str(name)] = arraysOf(std::make_shared<const ExportCopies>(std::move(each)));
    }
    return out;
}

std::shared_ptr<const Skeleton> skeletonOf(Work& work, NodeId tree, bool simplified,
                                           const py::object& callback)
{
    return work.run(callback, [&](const Progress& progress) -> Expected<std::shared_ptr<const Skeleton>> {
        const auto grown = work.grown(tree, simplified ? Stage::Simplified : Stage::Skeleton, progress);
        RAMURE_TRY(grown);
        if (simplified)
            return std::shared_ptr<const Skeleton>(grown->simplified, &grown->simplified->skeleton);
        return grown->skeleton;
    });
}

} // namespace

void bindTree(py::class_<Work, std::shared_ptr<Work>>& work)
{
    work.def("value", &value, py::arg("tree"), py::arg("key"));
    work.def("set_value", &setValue, py::arg("tree"), py::arg("key"), py::arg("value"));
    work.def("grow", &grow, py::arg("tree"), py::arg("progress"));
    work.def("meshes", &meshes, py::arg("tree"), py::arg("words"), py::arg("progress"));
    work.def("copies", &copies, py::arg("tree"), py::arg("texture"), py::arg("progress"));
    work.def(
        "skeleton",
        [](Work& self, NodeId tree, bool simplified, const py::object& callback) {
            return arraysOf(skeletonOf(self, tree, simplified, callback));
        },
        py::arg("tree"), py::arg("simplified"), py::arg("progress"));
    work.def(
        "axes",
        [](Work& self, NodeId tree, const py::object& callback) {
            return axisArrays(*skeletonOf(self, tree, false, callback));
        },
        py::arg("tree"), py::arg("progress"));
}

} // namespace ramure::python
