/// \file
/// One long piece of work on a thread of its own, as the interface sees it: progress, cancel, how it ended.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <QObject>
#include <functional>
#include <optional>
#include <thread>

namespace ramure {

class BackgroundJob : public QObject
{
    Q_OBJECT
public:
    using Work = std::function<Expected<void>(const Progress&)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override; ///< stops the work and waits for its end; nothing is told any more

    /// Returns at once; nothing happens while another work is running. \p work must not touch what other
    /// threads change.
    void start(Work work);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }

protected:
    /// For destructors of those who lend the work something of their own.
    void stopAndWait();

signals:
    void runningChanged(bool running);
    void progress(double fraction); ///< not more often than the eye sees
    /// Nothing: it is done. An error with the code Cancelled after cancel().
    void finished(const std::optional<ramure::Error>& error);

private:
    void finish(const std::optional<Error>& error);

    bool m_running = false;
    std::jthread m_thread; ///< last: it calls the object
};

} // namespace ramure
