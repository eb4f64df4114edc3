#include "core/qt/session/jobs/separation_task.h"

#include "core/qt/document/document_command.h"

namespace ramure {

SeparationTask::SeparationTask(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&m_job, &Job::progress, this, &SeparationTask::progress);
}

Expected<void> SeparationTask::start(NodeId tree)
{
    if (isRunning())
        return {};
    const Node* node = m_document->scene().find(tree);
    if (!node)
        return unknownNode(tree);
    if (node->kind != NodeKind::Tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no branches"), {node->name});
    m_tree = tree;
    m_shape = m_document->shapeRevision(tree);
    m_job.start(
        [params = node->params](const Progress& progress) {
            TreePipeline pipeline;
            return separateBranches(pipeline, params, {}, progress);
        },
        [this](Expected<Separation>&& result) {
            emit finished(result ? apply(std::move(*result)) : std::optional(result.error()));
        });
    return {};
}

std::optional<Error> SeparationTask::apply(Separation&& result)
{
    if (!m_document->scene().find(m_tree) || m_document->shapeRevision(m_tree) != m_shape)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the tree was changed meanwhile")).value();
    if (const auto pushed = edit::putTreeEdits(*m_document, m_tree, result.steps); !pushed)
        return pushed.error();
    m_outcome = std::move(result);
    return std::nullopt;
}

} // namespace ramure

#include "moc_separation_task.cpp"
