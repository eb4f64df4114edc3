#include "app/cli/work.h"
#include <csignal>
#include <cstdio>
#include <memory>
#include <pthread.h>
#include <unistd.h>

namespace ramure::cli {

namespace {

sigset_t stopSignals()
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

/// Signal handlers may do next to nothing: a thread that waits for the signals may do all.
void listen(const std::stop_token& end, std::stop_source work)
{
    const sigset_t set = stopSignals();
    for (int signal = 0; sigwait(&set, &signal) == 0 && !end.stop_requested();)
        if (!work.request_stop())
            ::_exit(2); // asked twice
}

} // namespace

Work::Work(const char* name)
    : m_name(name)
    , m_isTerminal(::isatty(STDERR_FILENO) != 0)
{
    const sigset_t set = stopSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    m_listener = std::jthread([work = m_stop](const std::stop_token& end) { listen(end, work); });
}

Work::~Work()
{
    m_listener.request_stop();
    pthread_kill(m_listener.native_handle(), SIGTERM); // to wake it
    m_listener.join();
    const sigset_t set = stopSignals();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    if (m_isTerminal)
        std::fputs("\r\033[K", stderr);
}

Progress Work::progress() const
{
    Progress out;
    out.stop = m_stop.get_token();
    if (m_isTerminal)
        out.onFraction = [name = m_name, shown = std::make_shared<int>(-1)](double fraction) {
            const int percent = static_cast<int>(fraction * 100.0);
            if (percent == *shown)
                return;
            *shown = percent;
            std::fprintf(stderr, "\r%s %d %%\033[K", name, percent);
            std::fflush(stderr);
        };
    return out;
}

} // namespace ramure::cli
