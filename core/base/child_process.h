/// \file
/// Programs of others, run as child processes.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <string>
#include <vector>

namespace ramure {

/// Whether a program of this name is in the PATH.
bool isInstalled(const std::string& program);

struct ProcessResult
{
    int exitCode = 0; ///< 128 and its number where a signal ended it
    std::string said; ///< the end of what it printed, at most 4096 bytes
};

/// Runs a program without input and waits for it. A cancel kills it with all that it has started.
/// \param words the program, looked for in the PATH, and its arguments
/// Errors: Io (it cannot be started), Cancelled.
Expected<ProcessResult> runProcess(const std::vector<std::string>& words, const Progress& progress = {});

} // namespace ramure
