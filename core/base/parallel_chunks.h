/// \file
/// Shares numbered chunks of work among a few threads. The work of a chunk may depend on its number only, so
/// the result is the same on one thread and on many. This is for long work that reports progress and can be
/// cancelled. Its threads are its own and have the calling thread's priority, so background work does not
/// keep the threads of parallel.h from work in the foreground.
#pragma once

#include "core/base/progress.h"
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <new>
#include <thread>
#include <vector>

namespace ramure {

/// \param wanted 0 = as many as the machine has. Never more than there are chunks, at least 1.
inline unsigned threadCount(unsigned wanted, std::size_t chunks)
{
    const unsigned most = wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
    return static_cast<unsigned>(std::clamp<std::size_t>(chunks, 1, most));
}

/// Calls work(chunk) once for each chunk 0 .. chunks - 1, in whatever order, on the calling thread and
/// threads - 1 others. The progress is reported by the calling thread only. False where it was cancelled:
/// then some chunks have not been looked at. Memory that runs out in any thread is thrown here.
template <class WorkOnChunk>
bool forChunks(std::size_t chunks, unsigned threads, const Progress& progress, WorkOnChunk&& work)
{
    std::atomic<std::size_t> next{0}, done{0};
    std::atomic<bool> outOfMemory{false};
    const auto run = [&](bool reports) {
        try {
            for (std::size_t chunk = next++; chunk < chunks; chunk = next++) {
                if (progress.cancelled() || outOfMemory)
                    return;
                work(chunk);
                const std::size_t finished = ++done;
                if (reports)
                    progress.report(static_cast<double>(finished) / static_cast<double>(chunks));
            }
        } catch (const std::bad_alloc&) {
            outOfMemory = true;
        }
    };
    {
        std::vector<std::jthread> others;
        for (unsigned i = 1; i < threadCount(threads, chunks); ++i)
            others.emplace_back([&run] { run(false); });
        run(true);
    }
    if (outOfMemory)
        throw std::bad_alloc();
    return done == chunks;
}

} // namespace ramure
