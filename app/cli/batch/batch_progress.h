/// \file
/// How far a batch is, on the standard error, in the words of whoever listens.
#pragma once

#include <QString>
#include <cstddef>

namespace ramure::cli {

enum class ProgressDialect {
    Text,   ///< for people: what failed, and a percentage where there is a terminal
    Json,   ///< an object a line
    OpenJd, ///< openjd_progress, openjd_status, openjd_fail: Open Job Description
};

class BatchProgress
{
public:
    BatchProgress(ProgressDialect dialect, std::size_t count);

    /// \param problem of a row that failed; empty: it went well
    void rowEnded(const QString& problem);
    /// The last words. \param problem why all of it failed; empty: it did not
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
