/// \file
/// Keeps the results of a document's trees up to date on a thread of its own. Two tiers: while edits keep
/// coming, a cheap draft that always finishes; after a short rest the full result, which alone may be
/// cancelled.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/jobs/evaluation.h"
#include <QObject>
#include <memory>

namespace ramure {

/// Recomputes trees after edits that change their shape:
/// - A draft is computed at once. Edits that come meanwhile wait for it, and the last of them is next.
/// - The full result follows after a short rest. It follows at once after New, Open, adding nodes and undoing
/// a removal.
/// - The second opinion of OpenMesh follows without hurry, as a new report in the result.
///
/// If all full results together took little time before, they are computed at once, without a draft. The
/// interface's thread only copies parameters (under 0.1 ms per tree) and takes results.
class Recompute : public QObject
{
    Q_OBJECT
public:
    explicit Recompute(Document* document, QObject* parent = nullptr);
    Recompute(Document* document, Evaluation evaluation, QObject* parent = nullptr);
    ~Recompute() override; ///< stops and joins the thread

    /// A draft or a full result is being computed, or waits. (Not: the second opinion.)
    [[nodiscard]] bool isBusy() const;
    /// Rest after the last edit before the full result starts, default 120 ms; 0 = at once, no drafts.
    void setRest(int milliseconds);
    /// Trees whose full results together took less than this get no drafts; default 12 ms.
    void setDirectLimit(int milliseconds);
    /// Blocks (with an event loop) until every node's full result is there; for the CLI and tests. False on
    /// time-out, and when the computation was cancelled.
    bool waitForFull(int timeoutMs);

public slots:
    /// Stops the full computation in progress; the draft or the last good result stays.
    void cancel();

signals:
    void busyChanged(bool busy);
    /// Progress of the full computation, 0..1, at most about 60 times a second.
    void progress(double fraction);

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace ramure
