/// \file
/// The few waits of a fixed time that a test may have, by their reasons. All others wait for what is to
/// happen: QTRY_VERIFY, QTest::qWaitFor, signals (tst_layers forbids the clock elsewhere).
#pragma once

#include <QTest>
#include <chrono>
#include <thread>

namespace ramure::test {

/// Stands for work that takes its time; no event is handled meanwhile.
inline void work(double milliseconds)
{
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(milliseconds));
}

/// What must not happen has had the time to.
inline void letHappen(int milliseconds)
{
    QTest::qWait(milliseconds);
}

/// What follows has to come out well at whatever moment it comes: one of several that are tried.
inline void anyMoment(int milliseconds)
{
    QTest::qWait(milliseconds);
}

/// What \p look gives once it has stayed the same for \p milliseconds; after half a minute whatever it is
/// then.
template <class Look> auto whenStill(int milliseconds, Look look)
{
    auto last = look();
    (void)QTest::qWaitFor(
        [&] {
            QTest::qWait(milliseconds);
            auto next = look();
            std::swap(last, next);
            return last == next;
        },
        30'000);
    return last;
}

} // namespace ramure::test
