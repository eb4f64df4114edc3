/// \file
/// Many jobs on a few processes of our own: one that ends by a crash or for want of memory costs the others
/// nothing.
#pragma once

#include <QByteArray>
#include <cstddef>
#include <functional>

namespace ramure::cli {

/// How a job ended.
enum class JobEnd {
    Done,
    Memory, ///< more than the limit, or killed from outside, which is how systems end what takes too much
    Crash,
};

struct PoolOptions
{
    int processes = 1;
    std::size_t memoryBytes = 0; ///< that each may take; 0: no limit
};

using JobDone = std::function<bool(std::size_t job, JobEnd end, const QByteArray& answer)>;

/// Calls \p work for the jobs 0 to \p count - 1 on processes that are forked here, and \p done in this one as
/// they end, in any order, with what work returned. Loops of a process keep to one thread. SIGINT and
/// SIGTERM, or false from done, drop the jobs under way at once; nothing is told of them. \returns 0, or the
/// number of the signal. \pre no other threads of ours in this process. Those that libraries have started
/// wait: OpenVDB's log4cplus keeps four.
int runJobs(std::size_t count, const PoolOptions& options,
            const std::function<QByteArray(std::size_t job)>& work, const JobDone& done);

/// How many processes this machine has cores for.
int usualProcesses();

} // namespace ramure::cli
