/// \file
/// Keeps the results of a document's trees up to date on a thread of its own. Two tiers: while edits keep
/// coming, a cheap draft that always finishes; after a short rest the full result, which alone may be
/// cancelled.
#pragma once

#include "core/document/document.h"
#include <QObject>
#include <memory>

namespace ramure {

class Recompute : public QObject
{
    Q_OBJECT
public:
    explicit Recompute(Document* document, QObject* parent = nullptr);
    ~Recompute() override; ///< stops and joins the thread

    [[nodiscard]] bool isBusy() const;
    /// Rest after the last edit before the full result starts, default 120 ms; 0 = at once, no drafts.
    void setRest(int milliseconds);
    /// Blocks (with an event loop) until every node's full result is there; for the CLI and tests. False on
    /// time-out.
    bool waitForFull(int timeoutMs);

public slots:
    /// Stops the full computation in progress; the draft or the last good result stays.
    void cancel();

signals:
    void busyChanged(bool busy);
    void progress(double fraction); ///< of the full computation, 0..1

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
