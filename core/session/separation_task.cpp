#include "core/session/separation_task.h"

#include "core/document/commands.h"

namespace ramure {

SeparationTask::SeparationTask(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
}

SeparationTask::~SeparationTask()
{
    cancel();
}

Expected<void> SeparationTask::start(NodeId tree)
{
    if (m_running)
        return {};
    const Node* node = m_document->scene().find(tree);
    if (!node)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(tree)});
    if (node->kind != NodeKind::Tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no branches"), {node->name});
    m_tree = tree;
    m_shape = m_document->shapeRevision(tree);
    m_running = true;
    const quint64 run = ++m_run;
    m_thread = std::jthread([this, run, params = node->params](const std::stop_token& stop) {
        Progress report{stop, [this](double fraction) {
                            QMetaObject::invokeMethod(
                                this, [this, fraction] { emit progress(fraction); }, Qt::QueuedConnection);
                        }};
        Expected<Separation> result = fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        try {
            TreePipeline pipeline;
            result = separateBranches(pipeline, params, {}, report);
        } catch (const std::bad_alloc&) {
            result = fail(ErrorCode::Limit, RAMURE_NOOP("there is not enough memory for this tree"));
        }
        QMetaObject::invokeMethod(
            this, [this, run, kept = std::move(result)] { finish(run, kept); }, Qt::QueuedConnection);
    });
    return {};
}

void SeparationTask::cancel()
{
    m_thread.request_stop();
}

void SeparationTask::finish(quint64 run, const Expected<Separation>& result)
{
    if (run != m_run)
        return;
    m_running = false;
    emit finished(result ? apply(*result) : std::optional(result.error()));
}

std::optional<Error> SeparationTask::apply(const Separation& result)
{
    if (!m_document->scene().find(m_tree) || m_document->shapeRevision(m_tree) != m_shape)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the tree was changed meanwhile")).value();
    if (const auto pushed = edit::setBranchBends(*m_document, m_tree, result.bendRad); !pushed)
        return pushed.error();
    m_outcome = result;
    return std::nullopt;
}

} // namespace ramure

#include "moc_separation_task.cpp"
