#include "widgets/export/export_task.h"

#include "core/document/document.h"
#include <map>

namespace ramure {
namespace {

using TreeSnapshot = std::map<NodeId, Expected<TreeResult>>;

/// The document's results, shared with the thread: the document itself stays where it is.
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

} // namespace

ExportTask::ExportTask(QObject* parent)
    : QObject(parent)
{
}

ExportTask::~ExportTask()
{
    cancel();
}

void ExportTask::start(const Document& document, const ExportOptions& options, const QString& path)
{
    if (m_running)
        return;
    m_running = true;
    const quint64 run = ++m_run;
    const auto work = [this, run, options, scene = document.scene(), source = snapshotOf(document),
                       file = path.toStdString()](const std::stop_token& stop) {
        Progress report;
        report.stop = stop;
        report.onFraction = [this](double fraction) {
            QMetaObject::invokeMethod(
                this, [this, fraction] { emit progress(fraction); }, Qt::QueuedConnection);
        };
        const auto done = exportScene(scene, options, source, file, report);
        const std::optional<Error> error = done ? std::nullopt : std::optional(done.error());
        QMetaObject::invokeMethod(
            this, [this, run, error] { finish(run, error); }, Qt::QueuedConnection);
    };
    m_thread = std::jthread(work); // waits for the one before, which has ended
}

void ExportTask::cancel()
{
    m_thread.request_stop();
}

void ExportTask::finish(quint64 run, const std::optional<Error>& error)
{
    if (run != m_run)
        return;
    m_running = false;
    emit finished(error);
}

} // namespace ramure
