#include "core/session/background_job.h"

#include <chrono>
#include <new>

namespace ramure {

static constexpr std::chrono::milliseconds progressRest{30};

BackgroundJob::BackgroundJob(QObject* parent)
    : QObject(parent)
{
}

BackgroundJob::~BackgroundJob()
{
    cancel();
}

void BackgroundJob::start(Work work)
{
    if (m_running)
        return;
    m_running = true;
    using Clock = std::chrono::steady_clock;
    const auto run = [this, job = std::move(work)](const std::stop_token& stop) {
        const auto told = std::make_shared<Clock::time_point>();
        const auto tell = [this, told](double fraction) {
            const Clock::time_point now = Clock::now();
            if (fraction < 1.0 && now - *told < progressRest)
                return;
            *told = now;
            QMetaObject::invokeMethod(
                this, [this, fraction] { emit progress(fraction); }, Qt::QueuedConnection);
        };
        std::optional<Error> error;
        try {
            if (auto done = job({stop, tell}); !done)
                error = std::move(done.error());
        } catch (const std::bad_alloc&) {
            error = fail(ErrorCode::Limit, RAMURE_NOOP("there is not enough memory for this")).value();
        }
        QMetaObject::invokeMethod(
            this, [this, error] { finish(error); }, Qt::QueuedConnection);
    };
    m_thread = std::jthread(run); // waits for the one before, which has ended
    emit runningChanged(true);
}

void BackgroundJob::cancel()
{
    m_thread.request_stop();
}

void BackgroundJob::stopAndWait()
{
    m_thread = {};
}

void BackgroundJob::finish(const std::optional<Error>& error)
{
    m_running = false;
    emit runningChanged(false);
    emit finished(error);
}

} // namespace ramure

#include "moc_background_job.cpp"
