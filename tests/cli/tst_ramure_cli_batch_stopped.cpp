#include "tests/cli/batch_support.h"
#include "tests/support/waits.h"
#include <QElapsedTimer>
#include <csignal>
#include <random>

namespace tst_ramure_cli_batch_stopped {

using namespace ramure;
using test::batchOf;
using test::bytesOf;
using test::filesBelow;
using test::linesOf;
using test::runCli;

/// Batches that are stopped, killed, or run out of memory, and go on. RAMURE_KILLS says how often one is
/// killed, 10 times without it.
class TestRamureCliBatchStopped : public test::FolderSuite
{
    Q_OBJECT

    [[nodiscard]] int rowsDone(const QString& folder) const
    {
        return int(bytesOf(path(folder) + "/manifest.jsonl.journal").count('\n'));
    }
    /// Every file that stands in its place has the bytes it has in the end.
    static bool isWhole(const std::map<QString, QByteArray>& found,
                        const std::map<QString, QByteArray>& whole)
    {
        for (const auto& [name, bytes] : found) {
            if (name.startsWith("manifest.jsonl") || name.startsWith(".row-") || name.startsWith("."))
                continue;
            const auto expected = whole.find(name);
            if (expected == whole.end() || expected->second != bytes) {
                qWarning("%s is not whole", qPrintable(name));
                return false;
            }
        }
        return true;
    }

private slots:
    void init() { begin(); }

    void tooMuchMemoryIsTheRowsError()
    {
        if (test::isSanitized) // AddressSanitizer's own memory is more than any limit that a row could meet
            return;
        const QByteArray text = "preset,seed\nTinyTree,1\nSmallTree,2\nTinyTree,3\n";
        const auto run = runCli(batchOf(table(text), path("out"), {"--memory", "40M"}));
        QCOMPARE(run.code, 4);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QCOMPARE(lines.size(), std::size_t(3));
        QVERIFY(!lines[0].contains("error") && !lines[2].contains("error"));
        QCOMPARE(lines[1]["error"]["kind"].toString(), QString("memory"));
        QVERIFY(QFile::exists(path("out/TinyTree_3.obj")) && !QFile::exists(path("out/SmallTree_2.obj")));
        // With enough of it, what is missing is done.
        QCOMPARE(runCli(batchOf(table(text), path("out"), {"--memory", "2G", "--resume"})).code, 0);
        QCOMPARE(runCli(batchOf(table(text), path("plain"))).code, 0);
        QVERIFY(filesBelow(path("out")) == filesBelow(path("plain")));
    }

    void signalsEndItClean_data()
    {
        QTest::addColumn<int>("signal");
        QTest::addColumn<int>("code");
        QTest::newRow("SIGTERM") << SIGTERM << 143;
        QTest::newRow("SIGINT") << SIGINT << 130;
    }
    void signalsEndItClean()
    {
        QFETCH(int, signal);
        QFETCH(int, code);
        const QByteArray text = test::smallTrees(3) + "SmallTree,8,\nSmallTree,9,\nSmallTree,10,\n";
        QCOMPARE(runCli(batchOf(table(text), path("whole"))).code, 0);
        const auto whole = filesBelow(path("whole"));
        QProcess process;
        process.start(QStringLiteral(RAMURE_CLI), batchOf(table(text), path("out")));
        QTRY_VERIFY_WITH_TIMEOUT(rowsDone("out") >= 3, test::patience(60'000)); // large trees are under way
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(::kill(pid_t(process.processId()), signal), 0);
        QVERIFY(process.waitForFinished());
        const qint64 ms = timer.elapsed();
        qInfo("ended after %lld ms", static_cast<long long>(ms));
        QVERIFY(ms < 1000);
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), code);
        const auto found = filesBelow(path("out"));
        QVERIFY(isWhole(found, whole));
        for (const auto& [name, bytes] : found)
            QVERIFY2(!name.startsWith("."), qPrintable(name)); // nothing lies about
        QVERIFY(!QFile::exists(path("out/manifest.jsonl.journal")));
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QVERIFY(lines.size() >= 3 && lines.size() < 6);
        QCOMPARE(runCli(batchOf(table(text), path("out"), {"--resume"})).code, 0);
        QVERIFY(filesBelow(path("out")) == whole);
    }

    void killedAgainAndAgain()
    {
        bool given = false;
        const int asked = qEnvironmentVariableIntValue("RAMURE_KILLS", &given);
        const int kills = given ? asked : 10;
        const QString csv = table(test::smallTrees(6 * kills));
        QCOMPARE(runCli(batchOf(csv, path("whole"))).code, 0);
        const auto whole = filesBelow(path("whole"));
        std::minstd_rand random(7);
        int killed = 0;
        for (int i = 0; i < kills; ++i) {
            const int before = rowsDone("out");
            QProcess process;
            process.start(QStringLiteral(RAMURE_CLI), batchOf(csv, path("out"), {"--resume"}));
            // A journal that is gone on with has a line more at once: that of a torn one.
            QTRY_VERIFY_WITH_TIMEOUT(rowsDone("out") >= before + 2 || process.state() == QProcess::NotRunning,
                                     test::patience(60'000));
            test::anyMoment(int(random() % 40));
            process.kill();
            QVERIFY(process.waitForFinished());
            killed += process.exitStatus() == QProcess::CrashExit ? 1 : 0;
            QVERIFY(isWhole(filesBelow(path("out")), whole));
        }
        qInfo("killed %d times", killed);
        QVERIFY(killed > kills / 2);
        QCOMPARE(runCli(batchOf(csv, path("out"), {"--resume"})).code, 0);
        QVERIFY(filesBelow(path("out")) == whole);
    }

    /// As the system does for want of memory.
    void aProcessThatIsKilledCostsItsRow()
    {
        const QByteArray text = "preset,seed\nSmallTree,1\nTinyTree,2\nTinyTree,3\n";
        QProcess process;
        process.start(QStringLiteral(RAMURE_CLI), batchOf(table(text), path("out"), {"--jobs", "1"}));
        const auto children = [&] {
            return bytesOf(QStringLiteral("/proc/%1/task/%1/children").arg(process.processId())).trimmed();
        };
        QTRY_VERIFY(!children().isEmpty());
        QCOMPARE(::kill(pid_t(children().toInt()), SIGKILL), 0);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 4);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QCOMPARE(lines[0]["error"]["kind"].toString(), QString("memory"));
        QVERIFY(!lines[1].contains("error") && !lines[2].contains("error"));
    }

    /// The second waits for the first, and has nothing left to do.
    void twoOfTheSame()
    {
        const QString csv = table(test::smallTrees(8));
        QProcess one, two;
        one.start(QStringLiteral(RAMURE_CLI), batchOf(csv, path("out"), {"--resume"}));
        two.start(QStringLiteral(RAMURE_CLI), batchOf(csv, path("out"), {"--resume"}));
        QVERIFY(one.waitForFinished(60'000) && two.waitForFinished(60'000));
        QCOMPARE(one.exitCode(), 0);
        QCOMPARE(two.exitCode(), 0);
        QCOMPARE(runCli(batchOf(csv, path("whole"))).code, 0);
        QVERIFY(filesBelow(path("out")) == filesBelow(path("whole")));
    }
};

RAMURE_SUITE(TestRamureCliBatchStopped)

} // namespace tst_ramure_cli_batch_stopped

#include "tst_ramure_cli_batch_stopped.moc"
