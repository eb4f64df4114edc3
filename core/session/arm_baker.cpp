#include "core/session/arm_baker.h"

namespace ramure {

/// What it was made from, and what was made.
struct ArmBaker::Made
{
    NodeParams params;
    NodeAnimation before, baked;
    TimelineSettings timeline;
};

ArmBaker::ArmBaker(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&m_job, &BackgroundJob::finished, this, &ArmBaker::take);
}

Expected<void> ArmBaker::start(NodeId arm, const ArmBakeOptions& options)
{
    const Node* node = m_document->scene().find(arm);
    if (!node)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(arm)});
    if (node->kind != NodeKind::Arm)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no arm"), {node->name});
    if (m_document->scene().isLocked(arm))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is locked"), {node->name});
    if (!node->params.arm.follows)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the arm follows no target: there is no motion to bake"));
    if (m_job.isRunning())
        return {};
    m_arm = arm;
    m_made = std::make_shared<Made>(Made{node->params, node->animation, {}, m_document->scene().timeline()});
    m_job.start([made = m_made, options](const Progress& progress) -> Expected<void> {
        auto baked = bakeArm(made->params, made->before, made->timeline, options, progress);
        if (!baked)
            return fail(std::move(baked.error()));
        made->baked = std::move(*baked);
        return {};
    });
    return {};
}

void ArmBaker::take(const std::optional<Error>& error)
{
    if (error)
        return emit finished(error);
    const Node* node = m_document->scene().find(m_arm);
    const bool same = node && node->params == m_made->params && node->animation == m_made->before;
    Expected<void> done = fail(ErrorCode::Invalid, RAMURE_NOOP("the arm was changed meanwhile"));
    if (same) {
        ArmState state = armState(*node);
        state.animation = m_made->baked;
        state.follows = false;
        done = edit::setArm(*m_document, m_arm, std::move(state), tr("Bake the arm to keys"));
    }
    emit finished(done ? std::nullopt : std::optional(done.error()));
}

} // namespace ramure

#include "moc_arm_baker.cpp"
