#include "core/base/parallel.h"
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ramure {

namespace {

thread_local unsigned threadLimit = 0; ///< 0 = as many as the machine has

/// One loop: its chunks are handed out by a counter.
class Loop
{
public:
    Loop(std::size_t chunks, void* work, parallel::Call call)
        : m_chunks(chunks)
        , m_work(work)
        , m_call(call)
    {
    }
    void takeChunks() noexcept
    {
        for (;;) {
            const std::size_t chunk = m_next.fetch_add(1, std::memory_order_relaxed);
            if (chunk >= m_chunks)
                return;
            try {
                m_call(m_work, chunk);
            } catch (...) {
                const std::scoped_lock lock(m_mutex);
                if (!m_exception)
                    m_exception = std::current_exception();
            }
        }
    }
    void rethrow() const
    {
        if (m_exception)
            std::rethrow_exception(m_exception);
    }

private:
    std::size_t m_chunks;
    void* m_work;
    parallel::Call m_call;
    std::atomic<std::size_t> m_next = 0;
    std::mutex m_mutex;
    std::exception_ptr m_exception;
};

/// Threads that wait for loops: starting one costs more than many loops take. They end when the program does.
class Helpers
{
public:
    explicit Helpers(unsigned count)
    {
        for (unsigned i = 0; i < count; ++i)
            m_threads.emplace_back([this](const std::stop_token& stop) { wait(stop); });
    }
    /// False where the helpers are busy with another loop.
    bool help(Loop& loop, unsigned helpers)
    {
        const std::unique_lock busy(m_busy, std::try_to_lock);
        if (!busy)
            return false;
        {
            const std::scoped_lock lock(m_mutex);
            m_loop = &loop;
            m_wanted = std::min<unsigned>(helpers, static_cast<unsigned>(m_threads.size()));
        }
        m_wake.notify_all();
        loop.takeChunks();
        std::unique_lock lock(m_mutex);
        m_wanted = 0; // who has not come yet finds nothing left
        m_done.wait(lock, [this] { return m_working == 0; });
        m_loop = nullptr;
        return true;
    }

private:
    void wait(const std::stop_token& stop)
    {
        threadLimit = 1; // a loop inside of a loop
        std::unique_lock lock(m_mutex);
        while (m_wake.wait(lock, stop, [this] { return m_wanted > 0; })) {
            --m_wanted;
            ++m_working;
            Loop* const loop = m_loop;
            lock.unlock();
            loop->takeChunks();
            lock.lock();
            if (--m_working == 0)
                m_done.notify_one();
        }
    }

    std::mutex m_busy;  ///< held by the loop that the helpers belong to
    std::mutex m_mutex; ///< guards what follows
    std::condition_variable_any m_wake;
    std::condition_variable m_done;
    Loop* m_loop = nullptr;
    unsigned m_wanted = 0;
    unsigned m_working = 0;
    std::vector<std::jthread> m_threads; // last: they are joined before the rest goes
};

unsigned machineThreads()
{
    static const unsigned count = std::max(1u, std::thread::hardware_concurrency());
    return count;
}

} // namespace

unsigned parallelThreads()
{
    return threadLimit == 0 ? machineThreads() : threadLimit;
}

ThreadLimit::ThreadLimit(unsigned threads)
    : m_before(threadLimit)
{
    threadLimit = threads;
}

ThreadLimit::~ThreadLimit()
{
    threadLimit = m_before;
}

void parallel::run(std::size_t chunks, void* work, Call call)
{
    Loop loop(chunks, work, call);
    const std::size_t threads = std::min<std::size_t>(parallelThreads(), chunks);
    const auto serially = [&loop] {
        const ThreadLimit one(1);
        loop.takeChunks();
    };
    if (threads <= 1) {
        serially();
    } else {
        // At least three, so that tests with a limit above the machine's threads have what they ask for.
        static Helpers helpers(std::max(machineThreads() - 1, 3u));
        const ThreadLimit one(1); // what the work itself spreads stays on its thread
        if (!helpers.help(loop, static_cast<unsigned>(threads - 1)))
            loop.takeChunks();
    }
    loop.rethrow();
}

} // namespace ramure
