/// \file
/// Loops spread over the processor's threads, with the same result on one thread as on many.
///
/// A loop is cut into chunks whose borders depend on its length alone. Which thread takes which chunk is left
/// to chance; work that writes only what belongs to its chunk gives the same bytes however many threads there
/// are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

namespace ramure {

/// How many threads a loop called from this thread takes at most, the calling one included; at least 1.
unsigned parallelThreads();

/// While it lives, loops called from this thread take at most \p threads (0 = as many as the machine has).
class ThreadLimit
{
public:
    explicit ThreadLimit(unsigned threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    unsigned m_before;
};

namespace parallel {

using Call = void (*)(void* work, std::size_t chunk);
/// Calls \p call(work, c) for every c in [0, chunks), each once, in any order.
void run(std::size_t chunks, void* work, Call call);

} // namespace parallel

/// Calls \p work(begin, end) for consecutive ranges of \p grain numbers (the last may be shorter) that
/// together cover [0, count), and returns when all are done. \p grain should stand for 20 microseconds of
/// work or more. A loop inside another loop, or started while another one runs, stays on its caller's thread.
/// If calls throw, the other ranges are still worked on, and one of the exceptions is thrown afterwards.
template <class Work> void parallelFor(std::size_t count, std::size_t grain, Work&& work)
{
    grain = std::max<std::size_t>(grain, 1);
    auto range = [&](std::size_t chunk) {
        const std::size_t begin = chunk * grain;
        work(begin, std::min(count, begin + grain));
    };
    using Range = decltype(range);
    parallel::run((count + grain - 1) / grain, std::addressof(range),
                  [](void* self, std::size_t chunk) { (*static_cast<Range*>(self))(chunk); });
}

} // namespace ramure
