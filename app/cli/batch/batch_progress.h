/// \file
/// Reports the progress of a batch on the standard error, for people or in one of two formats for programs.
#pragma once

#include <QString>
#include <cstddef>

namespace ramure::cli {

enum class ProgressDialect {
    Text,   ///< for people: it names the rows that fail, and shows a percentage if there is a terminal
    Json,   ///< one object per line
    OpenJd, ///< openjd_progress, openjd_status, openjd_fail: Open Job Description
};

class BatchProgress
{
public:
    BatchProgress(ProgressDialect dialect, std::size_t count);

    /// Counts a row. \param problem why it failed; empty if it went well
    void rowEnded(const QString& problem);
    /// Prints the last line. \param problem why the whole batch failed; empty if it did not
    void ended(const QString& problem);
    [[nodiscard]] std::size_t failed() const { return m_failed; }

private:
    void tell();

    ProgressDialect m_dialect;
    std::size_t m_count, m_done = 0, m_failed = 0;
    int m_shown = -1;
    bool m_isTerminal;
};

} // namespace ramure::cli
