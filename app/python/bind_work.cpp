#include "app/cli/mesh_check.h"
#include "app/cli/scene_export.h"
#include "app/cli/scene_facts.h"
#include "app/python/bindings.h"
#include "core/qt/document/project/project_file.h"
#include "core/scene/shown_nodes.h"
#include <QFileInfo>
#include <QJsonDocument>

namespace ramure::python {

namespace {

namespace py = pybind11;

std::string textOf(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
}

Expected<std::shared_ptr<Work>> openWork(const std::string& name, const Progress& progress)
{
    const QString text = pathText(name);
    if (QFileInfo(text).suffix().toLower() != QLatin1String("ramure")) {
        auto input = cli::loadInput(text, {}, progress);
        RAMURE_TRY(input);
        return std::make_shared<Work>(std::move(*input), name);
    }
    auto project = loadProjectFile(text);
    RAMURE_TRY(project);
    return std::make_shared<Work>(cli::Input{std::move(project->scene)}, name, std::move(project->extras));
}

std::shared_ptr<Work> opened(const std::string& name, const py::object& callback)
{
    PythonProgress progress(callback);
    auto work = [&] {
        const py::gil_scoped_release released;
        return openWork(name, progress.progress());
    }();
    progress.rethrow();
    return taken(std::move(work));
}

/// What a function sees of the work: all of it, or one tree of several.
cli::Input seen(Work& work, NodeId only)
{
    cli::Input input = work.input();
    if (auto* const scene = std::get_if<Scene>(&input.content); scene && only != noNode)
        showOnly(*scene, {&only, 1});
    return input;
}

void save(Work& work, const std::string& path)
{
    work.run(py::none(), [&](const Progress&) -> Expected<void> {
        const auto scene = work.scene();
        RAMURE_TRY(scene);
        if (QFileInfo(pathText(path)).suffix().toLower() != QLatin1String("ramure"))
            return fail(ErrorCode::Invalid, "\"%1\": a project is a .ramure file", {path});
        return saveProjectFile({**scene, work.extras()}, pathText(path));
    });
}

std::string info(Work& work, bool axes, const py::object& callback)
{
    return work.run(callback, [&](const Progress&) -> Expected<std::string> {
        if (const ReadMesh* mesh = work.input().mesh())
            return textOf(cli::jsonFacts(*mesh));
        Evaluator evaluator(pipelineSource(work.pipeline()));
        EvaluatedScene now = evaluator.at(*work.input().scene());
        const auto facts = cli::sceneFacts(now, axes);
        RAMURE_TRY(facts);
        return cli::jsonOf(*facts, now).map(&textOf);
    });
}

std::string validate(Work& work, NodeId only, bool crossings, bool texture, const py::object& callback)
{
    return work.run(callback, [&](const Progress& progress) -> Expected<std::string> {
        const cli::Input input = seen(work, only);
        Evaluator evaluator(pipelineSource(work.pipeline()));
        const auto checked =
            cli::checkMeshes(input, evaluator, {0.0, crossings, only == noNode, texture}, progress);
        RAMURE_TRY(checked);
        return textOf(cli::jsonOf(*checked, crossings));
    });
}

/// \param words of the command line behind the input. Returns the report of a print, and what was told.
py::tuple exportFiles(Work& work, NodeId only, const std::vector<std::string>& words,
                      const py::object& callback)
{
    QStringList arguments;
    for (const std::string& word : words)
        arguments << pathText(word);
    arguments << QStringLiteral("--") << pathText(work.name());
    std::vector<std::string> notes;
    const std::string report = work.run(callback, [&](const Progress& progress) -> Expected<std::string> {
        cli::CommandLine line({"export", "", "INPUT", "", ""});
        cli::addSceneExportOptions(line);
        RAMURE_TRY(line.parse(arguments));
        const auto request =
            cli::exportRequestOf(line, [&](const Error& note) { notes.push_back(note.message()); });
        RAMURE_TRY(request);
        cli::Input input = seen(work, only);
        const auto done = cli::exportInput(line, *request, input, work.pipeline(), progress);
        RAMURE_TRY(done);
        if (done->code != cli::exitGood)
            return fail(ErrorCode::Invalid, "%1", {done->text.toStdString()});
        return done->text.toStdString();
    });
    return py::make_tuple(report, notes);
}

py::list trees(Work& work)
{
    const auto found =
        work.run(py::none(), [&](const Progress&) -> Expected<std::vector<std::pair<NodeId, std::string>>> {
            std::vector<std::pair<NodeId, std::string>> out;
            if (const Scene* scene = work.input().scene())
                for (const Node& node : scene->nodes())
                    if (node.kind == NodeKind::Tree)
                        out.emplace_back(node.id, node.name);
            return out;
        });
    py::list out;
    for (const auto& [id, name] : found)
        out.append(py::make_tuple(id, name));
    return out;
}

} // namespace

void bindWork(py::module_& module, py::class_<Work, std::shared_ptr<Work>>& work)
{
    module.def("open", &opened, py::arg("name"), py::arg("progress"));
    work.def("save", &save, py::arg("path"));
    work.def("info", &info, py::arg("axes"), py::arg("progress"));
    work.def("validate", &validate, py::arg("only"), py::arg("crossings"), py::arg("texture"),
             py::arg("progress"));
    work.def("export", &exportFiles, py::arg("only"), py::arg("words"), py::arg("progress"));
    work.def("trees", &trees);
    work.def("close", &Work::close);
}

} // namespace ramure::python
