/// \file
/// Moves the colliding branches of one tree apart on a thread of its own, and puts the outcome into the
/// document as one undo step.
#pragma once

#include "core/pipeline/separate_branches.h"
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/job.h"
#include <QObject>
#include <optional>

namespace ramure {

class SeparationTask : public QObject
{
    Q_OBJECT
public:
    /// \param document must outlive this object.
    explicit SeparationTask(Document* document, QObject* parent = nullptr);

    /// Copies its inputs from the document and returns at once; does nothing while another one is running.
    /// Errors: Unknown (node), Invalid (no tree).
    Expected<void> start(NodeId tree);
    void cancel() { m_job.cancel(); }
    [[nodiscard]] bool isRunning() const { return m_job.isRunning(); }
    /// Outcome of the last run that ended, without the errors that finished() reports.
    [[nodiscard]] const Separation& outcome() const { return m_outcome; }

signals:
    void progress(double fraction);
    /// Without an error it is done and the command is pushed (none if no turn helps). Errors besides those of
    /// separateBranches: Invalid if the tree was changed meanwhile or is locked.
    void finished(const std::optional<ramure::Error>& error);

private:
    [[nodiscard]] std::optional<Error> apply(Separation&& result);

    Document* m_document;
    NodeId m_tree = noNode;
    quint64 m_shape = 0; ///< Document::shapeRevision when it began
    Separation m_outcome;
    Job m_job;
};

} // namespace ramure
