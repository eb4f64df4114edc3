/// \file
/// Runs ramure-cli as users do.
#pragma once

#include "tests/support/suite.h"
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <memory>

namespace ramure::test {

struct CliRun
{
    int code = -1;
    QString out;
    QString err;

    [[nodiscard]] QJsonObject json() const
    {
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(out.toUtf8(), &error);
        if (error.error != QJsonParseError::NoError)
            qFatal("no JSON: %s", qPrintable(out));
        return document.object();
    }
    [[nodiscard]] QStringList keys() const
    {
        QStringList names = json().keys();
        names.sort();
        return names;
    }
};

/// Sanitizers ask for more of it.
inline int patienceMs()
{
    return 120'000 * std::max(1, qEnvironmentVariableIntValue("RAMURE_PATIENCE"));
}

inline CliRun runProgram(const QString& program, const QStringList& arguments,
                         const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment())
{
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    if (!process.waitForFinished(patienceMs()) || process.exitStatus() != QProcess::NormalExit)
        qFatal("%s %s: crashed or hangs", qPrintable(program), qPrintable(arguments.join(QLatin1Char(' '))));
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

inline CliRun runCli(const QStringList& arguments,
                     const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment())
{
    return runProgram(QStringLiteral(RAMURE_CLI), arguments, environment);
}

/// Exit code \p code, nothing on the standard output, one line on the standard error that holds \p part.
inline bool isRefused(const CliRun& run, const QString& part, int code = 2)
{
    const bool isOneLine = run.err.count(QLatin1Char('\n')) == 1 && run.err.endsWith(QLatin1Char('\n'));
    const bool isRight = run.code == code && run.out.isEmpty() && isOneLine &&
                         run.err.startsWith(QStringLiteral("ramure-cli: ")) && run.err.contains(part);
    if (!isRight)
        qWarning("code %d, out \"%s\", err \"%s\"", run.code, qPrintable(run.out.left(200)),
                 qPrintable(run.err));
    return isRight;
}

inline QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

/// A suite whose tests work in a folder of their own: call begin() in init().
class FolderSuite : public QObject
{
protected:
    void begin()
    {
        failOnAnyWarning();
        m_folder = std::make_unique<QTemporaryDir>();
    }
    [[nodiscard]] QString folder() const { return m_folder->path(); }
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    /// Writes a table of variations. \returns its path.
    [[nodiscard]] QString table(const QByteArray& text) const
    {
        write(path("t.csv"), text);
        return path("t.csv");
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace ramure::test
