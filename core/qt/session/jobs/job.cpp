#include "core/qt/session/jobs/job.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPointer>
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>
#ifdef __linux__
#include <sys/resource.h>
#endif

namespace ramure {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds progressRest{16};

std::atomic<int> abandoned = 0;

QEvent::Type mailEvent()
{
    static const auto type = static_cast<QEvent::Type>(QEvent::registerEventType());
    return type;
}

/// Threads that this one starts have its priority too.
void becomePolite()
{
#ifdef __linux__
    // Of this thread alone. Not SCHED_IDLE: where the processor draws the view, that would never get a turn.
    constexpr int polite = 10;
    ::setpriority(PRIO_PROCESS, 0, polite); // a wish: without it the work is only less polite
#endif
}

Error cancelledError()
{
    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")).value();
}

} // namespace

/// What the job and its thread have in common; the thread keeps it where the job goes first.
///
/// Everything passes from one thread to the other under the mutex. Qt's event only says that there is mail,
/// and is posted under it too: ThreadSanitizer knows no lock of Qt's.
struct Job::Shared
{
    /// With the mutex held.
    void send(std::function<void()> message)
    {
        if (!job)
            return;
        mail.push_back(std::move(message));
        if (mail.size() == 1)
            wakeJob();
    }
    void wakeJob() { QCoreApplication::postEvent(job, new QEvent(mailEvent())); }
    void serve();

    static std::mutex allMutex;
    static std::vector<Shared*> all; ///< those that have a job

    std::mutex mutex; ///< guards all that follows
    std::condition_variable wake, rest;
    Job* job = nullptr; ///< null: it is gone, and nobody reads mail
    std::deque<std::function<void()>> mail;
    std::map<int, std::shared_ptr<Request>> waiting; ///< by lane
    std::shared_ptr<Request> running;
    Clock::time_point begun;
    std::optional<Clock::time_point> stopAsked; ///< by stopAll
    bool quit = false, ended = false, isAbandoned = false;
};

std::mutex Job::Shared::allMutex;
std::vector<Job::Shared*> Job::Shared::all;

Error caughtError()
{
    try {
        std::rethrow_exception(std::current_exception());
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::Limit, RAMURE_NOOP("there is not enough memory for this")).value();
    } catch (const std::exception& exception) {
        return fail(ErrorCode::Invalid, RAMURE_NOOP("unexpected error: %1"), {exception.what()}).value();
    } catch (...) {
        return fail(ErrorCode::Invalid, RAMURE_NOOP("unexpected error: %1"), {"?"}).value();
    }
}

void Job::Shared::serve()
{
    std::unique_lock lock(mutex);
    for (;;) {
        wake.wait(lock, [this] { return quit || !waiting.empty(); });
        if (quit)
            break;
        const std::shared_ptr<Request> request = std::move(waiting.begin()->second);
        waiting.erase(waiting.begin());
        running = request;
        begun = Clock::now();
        lock.unlock();
        const auto told = std::make_shared<Clock::time_point>();
        const auto tell = [this, request, told](double fraction) {
            const Clock::time_point now = Clock::now();
            if (fraction < 1.0 && now - *told < progressRest)
                return;
            *told = now;
            const std::scoped_lock held(mutex);
            send([owner = job, request, fraction] {
                if (!request->cancelled && std::ranges::count(owner->m_pending, request) > 0)
                    emit owner->progress(fraction);
            });
        };
        std::optional<Error> error;
        try {
            error = request->work({request->stop.get_token(), tell});
        } catch (...) {
            error = caughtError();
        }
        request->work = {}; // what it owned goes here, not on the thread of the interface
        lock.lock();
        running.reset();
        send([owner = job, request, error = std::move(error)]() mutable {
            owner->finish(request, std::move(error));
        });
        rest.notify_all();
    }
    ended = true;
    abandoned -= isAbandoned ? 1 : 0;
    rest.notify_all();
}

Job::Job(QObject* parent, Manner manner)
    : QObject(parent)
    , m_shared(std::make_shared<Shared>())
    , m_manner(manner)
{
    m_shared->job = this;
    const std::scoped_lock lock(Shared::allMutex);
    Shared::all.push_back(m_shared.get());
}

Job::~Job()
{
    {
        const std::scoped_lock lock(Shared::allMutex);
        std::erase(Shared::all, m_shared.get());
    }
    std::deque<std::function<void()>> mail; // goes when the mutex is free again
    std::map<int, std::shared_ptr<Request>> waiting;
    std::unique_lock lock(m_shared->mutex);
    m_shared->job = nullptr;
    m_shared->quit = true;
    mail.swap(m_shared->mail);
    waiting.swap(m_shared->waiting);
    if (!m_thread.joinable())
        return;
    if (m_shared->running)
        m_shared->running->stop.request_stop();
    m_shared->wake.notify_one();
    const Clock::time_point latest = m_shared->stopAsked.value_or(Clock::now()) + patience;
    m_shared->isAbandoned = !m_shared->rest.wait_until(lock, latest, [this] { return m_shared->ended; });
    abandoned += m_shared->isAbandoned ? 1 : 0;
    const bool leave = m_shared->isAbandoned;
    lock.unlock();
    if (leave)
        m_thread.detach();
    else
        m_thread.join();
}

void Job::begin(std::shared_ptr<Request> request, Running running)
{
    if (running == Running::Stops) {
        stopUntold(request->lane);
    } else {
        takeBack(request->lane);
    }
    m_pending.push_back(request);
    {
        const std::scoped_lock lock(m_shared->mutex);
        m_shared->waiting[request->lane] = request;
        m_shared->wake.notify_one();
    }
    if (!m_thread.joinable()) {
        try {
            m_thread = std::thread([shared = m_shared, polite = m_manner == Manner::Polite] {
                if (polite)
                    becomePolite();
                shared->serve();
            });
        } catch (const std::system_error&) {
            const std::scoped_lock lock(m_shared->mutex);
            m_shared->waiting.clear();
            m_shared->send([this, request] {
                finish(request,
                       fail(ErrorCode::Limit, RAMURE_NOOP("there is not enough memory for this")).value());
            });
        }
    }
    updateRunning();
}

bool Job::takeBack(int lane)
{
    std::shared_ptr<Request> request; // goes when the mutex is free again
    {
        const std::scoped_lock lock(m_shared->mutex);
        if (const auto found = m_shared->waiting.find(lane); found != m_shared->waiting.end()) {
            request = std::move(found->second);
            m_shared->waiting.erase(found);
        }
    }
    if (request)
        std::erase(m_pending, request);
    return request != nullptr;
}

bool Job::withdraw(int lane)
{
    const bool waited = takeBack(lane);
    updateRunning();
    return waited;
}

bool Job::cancel(int lane, std::chrono::milliseconds grace)
{
    const std::scoped_lock lock(m_shared->mutex);
    if (const auto found = m_shared->waiting.find(lane); found != m_shared->waiting.end()) {
        found->second->cancelled = true;
        m_shared->send([this, request = found->second] { finish(request, cancelledError()); });
        m_shared->waiting.erase(found);
    }
    const bool runs = m_shared->running && m_shared->running->lane == lane;
    if (runs && Clock::now() - m_shared->begun < grace)
        return false;
    for (const std::shared_ptr<Request>& request : m_pending)
        request->cancelled = request->cancelled || request->lane == lane;
    return runs && m_shared->running->stop.request_stop();
}

void Job::stopUntold(int lane)
{
    cancel(lane);
    std::erase_if(m_pending,
                  [lane](const std::shared_ptr<Request>& request) { return request->lane == lane; });
}

void Job::forget(int lane)
{
    stopUntold(lane);
    updateRunning();
}

bool Job::isRunning(int lane) const
{
    return std::ranges::any_of(
        m_pending, [lane](const std::shared_ptr<Request>& request) { return request->lane == lane; });
}

bool Job::wait(std::chrono::milliseconds most, int lane)
{
    {
        std::unique_lock lock(m_shared->mutex);
        const auto isOver = [shared = m_shared.get(), lane] {
            return !shared->waiting.contains(lane) && !(shared->running && shared->running->lane == lane);
        };
        if (!m_shared->rest.wait_for(lock, most, isOver))
            return false;
    }
    const QPointer<Job> alive(this);
    while (alive && takeMessage())
        continue;
    return true;
}

Job::Mailbox Job::mailbox() const
{
    return [shared = m_shared](std::function<void()> message) {
        const std::scoped_lock lock(shared->mutex);
        shared->send(std::move(message));
    };
}

void Job::stopAll()
{
    const std::scoped_lock all(Shared::allMutex);
    for (Shared* shared : Shared::all) {
        const std::scoped_lock lock(shared->mutex);
        shared->stopAsked = Clock::now();
        if (shared->running)
            shared->running->stop.request_stop();
    }
}

int Job::abandonedCount()
{
    return abandoned;
}

bool Job::event(QEvent* event)
{
    bool isMail = false;
    {
        const std::scoped_lock lock(m_shared->mutex); // before anything of the event is looked at
        isMail = event->type() == mailEvent();
    }
    if (isMail)
        takeMessage();
    return isMail || QObject::event(event);
}

/// One at a time, with an event for the rest: an event loop within the call goes on where this one stopped.
bool Job::takeMessage()
{
    std::function<void()> message;
    {
        const std::scoped_lock lock(m_shared->mutex);
        if (m_shared->mail.empty())
            return false;
        message = std::move(m_shared->mail.front());
        m_shared->mail.pop_front();
        if (!m_shared->mail.empty())
            m_shared->wakeJob();
    }
    message(); // perhaps the end of this object
    return true;
}

void Job::finish(const std::shared_ptr<Request>& request, std::optional<Error>&& error)
{
    const auto found = std::ranges::find(m_pending, request);
    if (found == m_pending.end())
        return;
    m_pending.erase(found);
    if (request->cancelled && request->hasValue)
        error = cancelledError();
    const QPointer<Job> alive(this);
    updateRunning();
    if (alive)
        request->take(std::move(error));
}

void Job::updateRunning()
{
    const bool now = !m_pending.empty();
    if (std::exchange(m_running, now) != now)
        emit runningChanged(now);
}

} // namespace ramure

#include "moc_job.cpp"
