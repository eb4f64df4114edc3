/// \file
/// Moves the colliding branches of one tree apart on a thread of its own, and puts the outcome into the
/// document as one undo step.
#pragma once

#include "core/document/document.h"
#include "core/pipeline/separate_branches.h"
#include <QObject>
#include <optional>
#include <thread>

namespace ramure {

class SeparationTask : public QObject
{
    Q_OBJECT
public:
    /// \param document must outlive this object.
    explicit SeparationTask(Document* document, QObject* parent = nullptr);
    ~SeparationTask() override; ///< stops the thread and waits for it

    /// Takes what it needs from the document and returns at once; nothing happens while another one is
    /// running. Errors: Unknown (node), Invalid (no tree).
    Expected<void> start(NodeId tree);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }
    /// Of the last one that came to its end; without those errors that are told by finished().
    [[nodiscard]] const Separation& outcome() const { return m_outcome; }

signals:
    void progress(double fraction);
    /// Nothing: it is done, the command is pushed (none where no turn helps). Errors besides those of
    /// separateBranches: Invalid where the tree was changed meanwhile or is locked.
    void finished(const std::optional<ramure::Error>& error);

private:
    void finish(quint64 run, const Expected<Separation>& result);
    [[nodiscard]] std::optional<Error> apply(const Separation& result);

    Document* m_document;
    NodeId m_tree = noNode;
    quint64 m_shape = 0; ///< Document::shapeRevision when it began
    bool m_running = false;
    quint64 m_run = 0;
    Separation m_outcome;
    std::jthread m_thread;
};

} // namespace ramure
