#include "app/cli/batch/worker_pool.h"
#include "core/base/parallel.h"
#include <QDir>
#include <QFile>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <new>
#include <optional>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace ramure::cli {

namespace {

constexpr int memoryExit = 4; ///< of a process that ran out of memory

using RowWork = std::function<QByteArray(std::size_t)>;

bool writeAll(int file, const void* bytes, std::size_t size)
{
    const char* next = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t written = ::write(file, next, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        next += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

bool readAll(int file, void* bytes, std::size_t size)
{
    char* next = static_cast<char*>(bytes);
    while (size > 0) {
        const ssize_t got = ::read(file, next, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        next += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

/// An answer is its length and its bytes.
[[noreturn]] void serve(int orders, int answers, const PoolOptions& options, const RowWork& work)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // does not outlive the parent, however that ends
    ::signal(SIGINT, SIG_IGN);          // Ctrl+C reaches all processes: the parent decides
    ::signal(SIGTERM, SIG_IGN);
    ::signal(SIGPIPE, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    if (options.memoryBytes > 0) {
        const rlimit limit{options.memoryBytes, options.memoryBytes};
        ::setrlimit(RLIMIT_DATA, &limit);
    }
    const ThreadLimit one(1);
    try {
        for (std::uint64_t job = 0; readAll(orders, &job, sizeof job);) {
            const QByteArray answer = work(job);
            const std::uint64_t size = static_cast<std::uint64_t>(answer.size());
            if (!writeAll(answers, &size, sizeof size) || !writeAll(answers, answer.constData(), size))
                break;
        }
    } catch (const std::bad_alloc&) {
        ::_exit(memoryExit);
    }
    ::_exit(0);
}

struct Worker
{
    pid_t process = 0;
    int orders = -1, answers = -1;
    std::optional<std::size_t> job;
    QByteArray received;

    void close()
    {
        ::close(orders);
        ::close(answers);
    }
    /// \returns the status of wait()
    int end()
    {
        int status = 0;
        ::kill(process, SIGKILL);
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        close();
        return status;
    }
};

JobEnd endOf(int status)
{
    if (WIFEXITED(status))
        return WEXITSTATUS(status) == memoryExit ? JobEnd::Memory : JobEnd::Crash;
    return WTERMSIG(status) == SIGKILL ? JobEnd::Memory : JobEnd::Crash;
}

#ifdef RAMURE_SANITIZED
/// AddressSanitizer's allocator keeps its locks across fork(): a child that is forked while another thread
/// allocates, as those of libraries do when they start, waits for ever.
bool othersSleep()
{
    const QDir tasks(QStringLiteral("/proc/self/task"));
    for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(tasks.filePath(task) + QLatin1String("/stat"));
        const QByteArray stat = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        const QByteArray state = stat.mid(stat.lastIndexOf(')') + 2, 1); // nothing: it has ended
        if (task.toLongLong() != ::gettid() && !state.isEmpty() && state != "S")
            return false;
    }
    return true;
}
#endif

class Pool
{
public:
    Pool(std::size_t count, const PoolOptions& options, const RowWork& work, const JobDone& done)
        : m_count(count)
        , m_options(options)
        , m_work(work)
        , m_done(done)
    {
        sigemptyset(&m_signals);
        sigaddset(&m_signals, SIGINT);
        sigaddset(&m_signals, SIGTERM);
        sigprocmask(SIG_BLOCK, &m_signals, &m_before);
        m_told = ::signalfd(-1, &m_signals, SFD_CLOEXEC);
    }
    ~Pool()
    {
        for (Worker& worker : m_workers)
            worker.end();
        ::close(m_told);
        sigprocmask(SIG_SETMASK, &m_before, nullptr);
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    int run()
    {
        ::signal(SIGPIPE, SIG_IGN);
        const std::size_t most = std::min(m_count, static_cast<std::size_t>(m_options.processes));
        while (m_workers.size() < most)
            m_workers.push_back(begin());
        for (Worker& worker : m_workers)
            order(worker);
        while (m_ended < m_count && !m_isStopped)
            if (const int signal = turn())
                return signal;
        return 0;
    }

private:
    Worker begin()
    {
        int orders[2], answers[2];
        if (::pipe(orders) != 0 || ::pipe(answers) != 0)
            throw std::bad_alloc();
#ifdef RAMURE_SANITIZED
        while (!othersSleep())
            ::usleep(1000);
#endif
        const pid_t process = ::fork();
        if (process < 0)
            throw std::bad_alloc();
        if (process == 0) {
            ::close(orders[1]);
            ::close(answers[0]);
            for (Worker& other : m_workers)
                other.close();
            serve(orders[0], answers[1], m_options, m_work);
        }
        ::close(orders[0]);
        ::close(answers[1]);
        return {process, orders[1], answers[0], {}, {}};
    }

    void order(Worker& worker)
    {
        worker.job.reset();
        if (m_next == m_count)
            return;
        const std::uint64_t job = m_next++;
        worker.job = job;
        writeAll(worker.orders, &job, sizeof job);
    }

    /// Waits for one thing to happen. \returns the signal, if it was one.
    int turn()
    {
        std::vector<pollfd> files{{m_told, POLLIN, 0}};
        for (const Worker& worker : m_workers)
            files.push_back({worker.answers, POLLIN, 0});
        if (::poll(files.data(), files.size(), -1) < 0)
            return 0;
        if (files[0].revents != 0) {
            signalfd_siginfo info{};
            return readAll(m_told, &info, sizeof info) ? static_cast<int>(info.ssi_signo) : 0;
        }
        for (std::size_t i = 0; i < m_workers.size(); ++i)
            if (files[i + 1].revents != 0)
                hear(m_workers[i]);
        return 0;
    }

    void hear(Worker& worker)
    {
        char bytes[1 << 16];
        const ssize_t got = ::read(worker.answers, bytes, sizeof bytes);
        if (got <= 0)
            return lose(worker);
        worker.received.append(bytes, static_cast<qsizetype>(got));
        std::uint64_t size = 0;
        if (worker.received.size() < qsizetype(sizeof size))
            return;
        memcpy(&size, worker.received.constData(), sizeof size);
        if (worker.received.size() < qsizetype(sizeof size + size))
            return;
        const QByteArray answer = worker.received.mid(sizeof size);
        const std::size_t job = *worker.job;
        worker.received.clear();
        order(worker); // it works while this process writes down what it answered
        ++m_ended;
        m_isStopped = !m_done(job, JobEnd::Done, answer) || m_isStopped;
    }

    void lose(Worker& worker)
    {
        int status = 0;
        while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
        }
        worker.close();
        const std::optional<std::size_t> job = worker.job;
        // Not among the others while its successor is forked: that would close what is closed.
        worker.orders = worker.answers = -1;
        worker = begin();
        order(worker);
        if (!job)
            return;
        ++m_ended;
        m_isStopped = !m_done(*job, endOf(status), {}) || m_isStopped;
    }

    std::size_t m_count;
    PoolOptions m_options;
    const RowWork& m_work;
    const JobDone& m_done;
    std::vector<Worker> m_workers;
    std::size_t m_next = 0, m_ended = 0;
    bool m_isStopped = false;
    sigset_t m_signals{}, m_before{};
    int m_told = -1;
};

} // namespace

int runJobs(std::size_t count, const PoolOptions& options, const RowWork& work, const JobDone& done)
{
    return Pool(count, options, work, done).run();
}

int usualProcesses()
{
    cpu_set_t set;
    return ::sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

} // namespace ramure::cli
