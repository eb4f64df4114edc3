#include "core/session/background_thread.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#ifdef __linux__
#include <sys/resource.h>
#endif

namespace ramure {
namespace {

/// Threads that this one starts have its priority too.
void becomePolite()
{
#ifdef __linux__
    // Of this thread alone. Not SCHED_IDLE: where the processor draws the view, that would never get a turn.
    constexpr int polite = 10;
    ::setpriority(PRIO_PROCESS, 0, polite); // a wish: without it the work is only less polite
#endif
}

} // namespace

struct BackgroundThread::Private
{
    struct Job
    {
        Work work;
        std::stop_source stop;
    };

    void loop(const std::stop_token& quit)
    {
        becomePolite();
        for (;;) {
            std::unique_lock lock(mutex);
            wake.wait(lock, quit, [this] { return waiting.has_value(); });
            if (quit.stop_requested())
                return;
            const Job job = std::move(*waiting);
            waiting.reset();
            running = job.stop;
            lock.unlock();
            job.work(job.stop.get_token());
        }
    }

    std::mutex mutex;
    std::condition_variable_any wake;
    std::optional<Job> waiting;
    std::stop_source running{std::nostopstate};
    std::jthread thread; ///< last: it needs all of the above
};

BackgroundThread::BackgroundThread()
    : m_private(std::make_unique<Private>())
{
    m_private->thread = std::jthread([d = m_private.get()](const std::stop_token& quit) { d->loop(quit); });
}

BackgroundThread::~BackgroundThread()
{
    m_private->thread.request_stop();
    stop();
}

void BackgroundThread::start(Work work)
{
    stop();
    const std::scoped_lock lock(m_private->mutex);
    m_private->waiting = Private::Job{std::move(work), std::stop_source()};
    m_private->wake.notify_one();
}

void BackgroundThread::stop()
{
    const std::scoped_lock lock(m_private->mutex);
    m_private->waiting.reset();
    m_private->running.request_stop();
}

} // namespace ramure
