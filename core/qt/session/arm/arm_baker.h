/// \file
/// Makes keys of an arm's motion on a thread of its own, and puts them into the document as one undo step.
#pragma once

#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/job.h"
#include "core/rig/arm/arm_bake.h"
#include <QObject>
#include <optional>

namespace ramure {

class ArmBaker : public QObject
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive this object.
    explicit ArmBaker(Document* document, QObject* parent = nullptr);

    /// Over the frames of the options; returns at once. Afterwards the arm follows its keys, no target.
    /// Nothing happens while another bake is running. Errors: Unknown (node), Invalid (no arm, locked, it
    /// follows no target).
    Expected<void> start(NodeId arm, const ArmBakeOptions& options);
    [[nodiscard]] Job* job() { return &m_job; }

signals:
    /// Without an error the keys are in the document. Errors: those of bakeArm and of edit::setArm; Invalid
    /// if the arm was changed meanwhile; Cancelled.
    void finished(const std::optional<ramure::Error>& error);

private:
    Expected<void> put(const Node& before, NodeAnimation&& baked);

    Document* m_document;
    Job m_job;
};

} // namespace ramure
