#include "widgets/dialogs/export_task.h"

#include "core/document/document.h"
#include "core/rig/physics/animated_physics.h"
#include "core/session/exporter.h"
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

void ExportTask::startPrint(const Document& document, const ExportOptions& which, const PrintOptions& options,
                            const std::shared_ptr<const ScenePrint>& ready, const QString& path,
                            std::function<void(const std::shared_ptr<const ScenePrint>&)> take)
{
    if (isRunning())
        return;
    using Made = std::shared_ptr<const ScenePrint>;
    start(
        [which, options, ready, scene = document.scene(), source = snapshotOf(document),
         file = path.toStdString()](const Progress& progress) -> Expected<Made> {
            Made made = ready;
            if (!made) {
                Evaluator evaluator(source, scene.timeline());
                auto print = printScene(evaluator.at(scene), which, options, progress.part(0.0, 0.9));
                if (!print)
                    return fail(std::move(print.error()));
                made = std::make_shared<const ScenePrint>(std::move(*print));
            }
            if (!file.empty())
                if (auto written =
                        writePrint(file, *made, printSpace(), which.write, progress.part(0.9, 1.0));
                    !written)
                    return fail(std::move(written.error()));
            return made;
        },
        [this, taken = std::move(take)](const Expected<Made>& made) {
            if (made)
                taken(*made);
            emit finished(made ? std::nullopt : std::optional(made.error()));
        });
}

} // namespace ramure
