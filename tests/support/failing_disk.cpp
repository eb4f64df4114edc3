#include "tests/support/failing_disk.h"

#include "core/base/file_writer.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

namespace ramure::test {
namespace {

FileCalls realCalls;
std::atomic<int> callsLeft = 0; // until the one that fails
int failure = 0;

bool fails()
{
    if (--callsLeft != 0)
        return false;
    errno = failure;
    return true;
}

FileCalls failingCalls()
{
    return {
        [](const char* path, int flags, mode_t mode) {
            return fails() ? -1 : realCalls.open(path, flags, mode);
        },
        [](int file, mode_t mode) { return fails() ? -1 : realCalls.chmod(file, mode); },
        [](int file, const void* bytes, std::size_t size) -> ssize_t {
            return fails() ? -1 : realCalls.write(file, bytes, size);
        },
        [](int) { return fails() ? -1 : 0; },
        [](int file) {
            const int closed = realCalls.close(file); // a close that fails closes all the same
            return fails() ? -1 : closed;
        },
        [](const char* from, const char* to, unsigned flags) {
            return fails() ? -1 : realCalls.rename(from, to, flags);
        },
    };
}

/// What an error has to say.
void checkError(const Expected<void>& written, const QString& folder, int reason)
{
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::Io);
    QVERIFY2(written.error().file.starts_with(folder.toStdString()), why(written));
    QCOMPARE(written.error().plain(), "cannot be written: " + std::generic_category().message(reason));
}

/// \p now after an error, \p before it.
void checkFiles(const QMap<QString, QByteArray>& now, const QMap<QString, QByteArray>& before,
                const QMap<QString, QByteArray>& whole, bool single)
{
    if (single) {
        QCOMPARE(now.keys(), before.keys());
        QVERIFY(now == before);
        return;
    }
    for (auto file = now.begin(); file != now.end(); ++file)
        QVERIFY2((before.contains(file.key()) && file.value() == before[file.key()]) ||
                     (whole.contains(file.key()) && file.value() == whole[file.key()]),
                 qPrintable(file.key()));
    for (const QString& name : before.keys())
        QVERIFY2(now.contains(name), qPrintable(name));
}

} // namespace

FailingDisk::FailingDisk(int call, int reason)
{
    failure = reason;
    callsLeft = call;
    realCalls = std::exchange(fileCalls(), failingCalls());
}

FailingDisk::~FailingDisk()
{
    fileCalls() = realCalls;
}

bool FailingDisk::hasFailed() const
{
    return callsLeft <= 0;
}

SmallDisk::SmallDisk(rlim_t bytes)
{
    makeFileLimitAnError();
    getrlimit(RLIMIT_FSIZE, &m_before);
    const rlimit limit{bytes, m_before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
}

QMap<QString, QByteArray> filesIn(const QString& folder)
{
    QMap<QString, QByteArray> files;
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden | QDir::System)) {
        if (name.endsWith(QStringLiteral(".lock"))) // of a program that runs, not of a writing
            continue;
        QFile file(QDir(folder).filePath(name));
        files.insert(name, file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read"));
    }
    return files;
}

static void checkFailingCalls(const QString& folder, const WriteFiles& write, bool single,
                              const QMap<QString, QByteArray>& whole)
{
    constexpr int manyCalls = 1000;
    for (int call = 1;; ++call) {
        QVERIFY(call < manyCalls);
        const int reason = call % 2 == 0 ? ENOSPC : EIO;
        const QMap<QString, QByteArray> before = filesIn(folder);
        const FailingDisk disk(call, reason);
        const auto written = write(folder, 1);
        if (!disk.hasFailed()) {
            QVERIFY2(written, why(written));
            return;
        }
        checkError(written, folder, reason);
        checkFiles(filesIn(folder), before, whole, single);
        if (QTest::currentTestFailed()) {
            qInfo("at call %d", call);
            return;
        }
    }
}

void checkNothingLost(const WriteFiles& write, bool single)
{
    QTemporaryDir temporary;
    const QDir folder(temporary.path());
    for (const char* name : {"old", "new"})
        QVERIFY(folder.mkdir(QLatin1String(name)));
    const QString old = folder.filePath(QStringLiteral("old"));
    QVERIFY(write(old, 1));
    const QMap<QString, QByteArray> whole = filesIn(old);
    QVERIFY(write(old, 0));
    const QMap<QString, QByteArray> before = filesIn(old);
    QCOMPARE(before.keys(), whole.keys());
    QVERIFY(before != whole);
    {
        const SmallDisk disk(0);
        checkError(write(old, 1), old, EFBIG);
    }
    checkFiles(filesIn(old), before, whole, single);
    checkFailingCalls(old, write, single, whole);
    checkFailingCalls(folder.filePath(QStringLiteral("new")), write, single, whole);
    // Below a file, and where even the administrator may not write.
    const QString below = QDir(old).filePath(whole.firstKey()) + QStringLiteral("/below");
    checkError(write(below, 1), below, ENOTDIR);
    const auto refused = write(QStringLiteral("/sys"), 1);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::Io);
    QVERIFY2(refused.error().file.starts_with("/sys/"), why(refused));
}

} // namespace ramure::test
