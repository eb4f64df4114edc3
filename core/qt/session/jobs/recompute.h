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

/// What happens after an edit that changes the shape of trees:
/// - their draft is computed at once; edits that come meanwhile wait for it, and the last of them is next;
/// - when the rest is over, or at once after New, Open, adding and undoing a removal, their full result;
/// - then, unhurried, the second opinion of OpenMesh, which comes as a new report in the result.
/// Where all full results together took little the last time, they come at once and there is no draft.
/// The interface's thread only copies parameters (under 0.1 ms per tree) and takes results.
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
    void progress(double fraction); ///< of the full computation, 0..1, at most some 60 times a second

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace ramure
