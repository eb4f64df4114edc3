#include "app/cli/batch/batch_progress.h"
#include "app/cli/command_line.h"
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdio>
#include <unistd.h>

namespace ramure::cli {

namespace {

void say(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stderr);
    std::fflush(stderr);
}

void say(const QJsonObject& line)
{
    say(QString::fromUtf8(QJsonDocument(line).toJson(QJsonDocument::Compact)) + QLatin1Char('\n'));
}

} // namespace

BatchProgress::BatchProgress(ProgressDialect dialect, std::size_t count)
    : m_dialect(dialect)
    , m_count(count)
    , m_isTerminal(::isatty(STDERR_FILENO) != 0)
{
}

void BatchProgress::rowEnded(const QString& problem)
{
    ++m_done;
    if (!problem.isEmpty()) {
        ++m_failed;
        switch (m_dialect) {
        case ProgressDialect::Text:
            say(QLatin1String(m_isTerminal ? "\r\033[K" : "") + problem.simplified() + QLatin1Char('\n'));
            break;
        case ProgressDialect::Json:
            say(QJsonObject{{QStringLiteral("error"), problem}});
            break;
        case ProgressDialect::OpenJd:
            say(QStringLiteral("openjd_status: %1\n").arg(problem.simplified()));
            break;
        }
    }
    if (const int percent = int(100 * m_done / m_count); percent != m_shown) {
        m_shown = percent;
        tell();
    }
}

void BatchProgress::tell()
{
    switch (m_dialect) {
    case ProgressDialect::Text:
        if (m_isTerminal)
            say(QStringLiteral("\rbatch %1 %\033[K").arg(m_shown));
        break;
    case ProgressDialect::Json:
        say(QJsonObject{{QStringLiteral("done"), qint64(m_done)},
                        {QStringLiteral("rows"), qint64(m_count)},
                        {QStringLiteral("failed"), qint64(m_failed)}});
        break;
    case ProgressDialect::OpenJd:
        say(QStringLiteral("openjd_progress: %1\nopenjd_status: %2 of %3 rows\n")
                .arg(m_shown)
                .arg(m_done)
                .arg(m_count));
        break;
    }
}

void BatchProgress::ended(const QString& problem)
{
    if (m_dialect == ProgressDialect::Text && m_isTerminal)
        say(QStringLiteral("\r\033[K"));
    if (problem.isEmpty())
        return;
    if (m_dialect == ProgressDialect::OpenJd)
        say(QStringLiteral("openjd_fail: %1\n").arg(problem.simplified()));
    else if (m_dialect == ProgressDialect::Json)
        say(QJsonObject{{QStringLiteral("fail"), problem}});
    else
        printError(problem);
}

} // namespace ramure::cli
