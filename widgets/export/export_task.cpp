#include "widgets/export/export_task.h"

#include "core/document/document.h"
#include "core/document/moving_source.h"
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
    return [trees](const Node& node, Stage, const Progress&) { return trees->at(node.id); };
}

void ExportTask::startExport(const Document& document, const ExportOptions& options, const QString& path,
                             double timeSeconds)
{
    start([options, timeSeconds, scene = document.scene(), source = snapshotOf(document),
           file = path.toStdString()](const Progress& progress) {
        MovingSource moving(source);
        return exportScene(scene, options, moving.at(timeSeconds), file, progress);
    });
}

} // namespace ramure
