#include "widgets/dialogs/export/export_task.h"

#include "core/qt/document/document.h"
#include "core/qt/session/export/document_source.h"
#include "core/qt/session/export/exporter.h"
#include "core/rig/physics/animated_physics.h"
#include <map>

namespace ramure {

using TreeSnapshot = std::map<NodeId, Expected<TreeResult>>;

TreeSource snapshotOf(const Document& document)
{
    auto trees = std::make_shared<TreeSnapshot>();
    const TreeSource source = documentSource(document);
    for (const Node& node : document.scene().nodes()) {
        if (node.kind == NodeKind::Tree)
            trees->emplace(node.id, source(node, Stage::Foliage, {}));
    }
    return [trees](const Node& node, Stage last, const Progress& progress) {
        // A shape that has tracks is another one at every time than the document's.
        return movesShape(node.animation) ? TreePipeline().evaluate(node.params, last, progress)
                                          : trees->at(node.id);
    };
}

void ExportTask::startExport(const Document& document, const ExportOptions& options, const QString& path,
                             double timeSeconds, const std::optional<TimelineSettings>& timeline)
{
    if (isRunning())
        return;
    start([options, timeSeconds, scene = document.scene(), source = snapshotOf(document),
           loop = timeline.value_or(document.scene().timeline()),
           file = path.toStdString()](const Progress& progress) {
        Evaluator evaluator(source, loop);
        return exportScene(evaluator.at(scene, timeSeconds), options, file, progress);
    });
}

void ExportTask::startPrint(const std::shared_ptr<const ScenePrint>& print, const WriteOptions& options,
                            const QString& path)
{
    if (isRunning())
        return;
    start([print, options, file = path.toStdString()](const Progress& progress) {
        return writePrint(file, *print, printSpace(), options, progress);
    });
}

} // namespace ramure
