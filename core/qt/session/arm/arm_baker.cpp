#include "core/qt/session/arm/arm_baker.h"

#include "core/qt/document/document_command.h"

namespace ramure {

ArmBaker::ArmBaker(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
}

Expected<void> ArmBaker::start(NodeId arm, const ArmBakeOptions& options)
{
    const auto editable = editableArm(m_document->scene(), arm);
    RAMURE_TRY(editable);
    const Node* node = *editable;
    if (!node->params.arm.follows)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the arm follows no target: there is no motion to bake"));
    if (m_job.isRunning())
        return {};
    m_job.start(
        [params = node->params, before = node->animation, timeline = m_document->scene().timeline(),
         options](const Progress& progress) { return bakeArm(params, before, timeline, options, progress); },
        [this, before = *node](Expected<NodeAnimation> baked) {
            const auto done = baked ? put(before, std::move(*baked)) : fail(std::move(baked.error()));
            emit finished(done ? std::nullopt : std::optional(done.error()));
        });
    return {};
}

Expected<void> ArmBaker::put(const Node& before, NodeAnimation&& baked)
{
    const Node* node = m_document->scene().find(before.id);
    if (!node || node->params != before.params || !(node->animation == before.animation))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the arm was changed meanwhile"));
    ArmState state = armState(*node);
    state.animation = std::move(baked);
    state.follows = false;
    return edit::setArm(*m_document, before.id, std::move(state), tr("Bake the arm to keys"));
}

} // namespace ramure

#include "moc_arm_baker.cpp"
