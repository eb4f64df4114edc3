/// \file
/// One piece of work at a time on a thread that leaves the processor to whoever else wants it, as a rule.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

namespace ramure {

class BackgroundThread
{
public:
    using Work = std::function<void(const std::stop_token& stop)>;

    BackgroundThread();
    ~BackgroundThread(); ///< stops what runs and joins
    BackgroundThread(const BackgroundThread&) = delete;
    BackgroundThread& operator=(const BackgroundThread&) = delete;

    /// Stops what runs; \p work begins when that has ended. Returns at once.
    void start(Work work);
    /// Asks what runs to stop, and forgets what waits. Returns at once: the work may still be about to end.
    void stop();

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace ramure
