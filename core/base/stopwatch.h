/// \file
/// Measures time since a start in two ways: by the wall clock, and as processor time of the calling thread.
/// On a busy machine only the second tells the cost of a piece of work.
#pragma once

#include <chrono>
#include <ctime>

namespace ramure {

struct Elapsed
{
    double wallMs = 0.0;
    double cpuMs = 0.0; ///< time of the calling thread, or of the process if the system counts no threads

    Elapsed& operator+=(const Elapsed& other)
    {
        wallMs += other.wallMs;
        cpuMs += other.cpuMs;
        return *this;
    }
    friend Elapsed operator-(const Elapsed& a, const Elapsed& b)
    {
        return {a.wallMs - b.wallMs, a.cpuMs - b.cpuMs};
    }
};

/// Starts when it is made. One thread only.
class Stopwatch
{
public:
    Stopwatch()
        : m_start(now())
    {
    }
    [[nodiscard]] Elapsed elapsed() const { return now() - m_start; }
    void restart() { m_start = now(); }

private:
    static double cpuMs()
    {
#ifdef CLOCK_THREAD_CPUTIME_ID
        std::timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
#else
        return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
#endif
    }
    static Elapsed now()
    {
        const auto wall = std::chrono::steady_clock::now().time_since_epoch();
        return {std::chrono::duration<double, std::milli>(wall).count(), cpuMs()};
    }

    Elapsed m_start;
};

} // namespace ramure
