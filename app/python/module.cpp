#include "app/cli/scene_export.h"
#include "app/python/bindings.h"
#include "app/python/values.h"
#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/params/recipe.h"
#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"

namespace ramure::python {

namespace {

namespace py = pybind11;

py::list presetList()
{
    py::list out;
    for (const Preset& preset : presets()) {
        py::dict entry;
        entry["name"] = preset.name;
        entry["latin"] = preset.latin;
        entry["group"] = preset.group;
        entry["description"] = preset.description;
        entry["ages"] = preset.ages[0] == 0 ? py::tuple()
                                            : py::make_tuple(preset.ages[0], preset.ages[1], preset.ages[2]);
        out.append(entry);
    }
    return out;
}

py::list parameterList()
{
    py::list out;
    for (const ParamDef& def : allParams())
        if (hasParam(NodeKind::Tree, def) || isOfSteps(def))
            out.append(factsOf(def));
    return out;
}

py::list stepList()
{
    py::list out;
    for (const EditOperationInfo& info : editOperations()) {
        if (info.operation == EditOperation::Unknown)
            continue;
        constexpr const char* groups[] = {"hand", "modifier", "source", ""};
        py::dict entry;
        entry["kind"] = info.key;
        entry["group"] = groups[static_cast<std::size_t>(info.group)];
        entry["label"] = info.label;
        entry["help"] = info.tip;
        py::list keys, own;
        for (const ParamDef* def : stepParams(info.operation)) {
            keys.append(def->key);
            if (hasParam(NodeKind::Tree, *def))
                own.append(def->key);
        }
        entry["parameters"] = keys;
        entry["tree_parameters"] = own;
        out.append(entry);
    }
    return out;
}

/// Name, whether it takes a value, and the help of each option of `ramure-cli export`.
py::list optionList()
{
    cli::CommandLine line({"export", "", "INPUT", "", ""});
    cli::addSceneExportOptions(line);
    py::list out;
    for (const QCommandLineOption& option : line.options()) {
        const QString name = option.names().last();
        if (name != QLatin1String("h") && name != QLatin1String("help") && name != QLatin1String("version") &&
            name != QLatin1String("set") && name != QLatin1String("output"))
            out.append(py::make_tuple(name.toStdString(), !option.valueName().isEmpty(),
                                      option.description().toStdString()));
    }
    return out;
}

py::list formatList()
{
    py::list out;
    for (const FileFormat* format : fileFormats())
        if (isFor(*format, FormatUse::Write))
            out.append(format->ending);
    return out;
}

} // namespace

void bindTables(py::module_& module)
{
    module.attr("version") = RAMURE_VERSION;
    module.def("presets", &presetList);
    module.def("parameters", &parameterList);
    module.def("step_kinds", &stepList);
    module.def("export_options", &optionList);
    module.def("formats", &formatList);
}

PYBIND11_MODULE(_ramure, module)
{
    registerErrors();
    bindTables(module);
    py::class_<Work, std::shared_ptr<Work>> work(module, "Work");
    bindWork(module, work);
    bindTree(work);
    bindSteps(work);
}

} // namespace ramure::python
