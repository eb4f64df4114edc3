/// \file
/// Long work on the command line: a progress line, and Ctrl+C that leaves no half-written file behind.
#pragma once

#include "core/base/progress.h"
#include <thread>

namespace ramure::cli {

/// While it lives, SIGINT and SIGTERM ask the work to stop; a second one ends the program at once. Progress
/// is shown on the standard error where that is a terminal.
class Work
{
public:
    explicit Work(const char* name);
    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    [[nodiscard]] Progress progress() const;

private:
    const char* m_name;
    std::stop_source m_stop;
    bool m_isTerminal;
    std::jthread m_listener;
};

} // namespace ramure::cli
