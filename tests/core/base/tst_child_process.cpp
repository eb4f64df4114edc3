#include "core/base/child_process.h"

#include "tests/support/suite.h"
#include <thread>

namespace tst_child_process {

using namespace ramure;

/// Programs of others.
class TestChildProcess : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNotThereCannotBeStarted()
    {
        QVERIFY(!isInstalled("no-such-program-of-ramure"));
        QVERIFY(isInstalled("sh"));
        const auto ran = runProcess({"no-such-program-of-ramure"});
        QVERIFY(!ran);
        QCOMPARE(ran.error().code, ErrorCode::Io);
        QVERIFY(ran.error().message().find("no-such-program-of-ramure") != std::string::npos);
    }

    void ends_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("said");
        QTest::newRow("well") << QStringLiteral("echo a; echo b >&2") << 0 << QStringLiteral("a\nb\n");
        QTest::newRow("badly") << QStringLiteral("echo no; exit 7") << 7 << QStringLiteral("no\n");
        QTest::newRow("killed") << QStringLiteral("kill -9 $$") << 137 << QString();
        QTest::newRow("asks") << QStringLiteral("cat; echo done") << 0 << QStringLiteral("done\n");
    }
    void ends()
    {
        QFETCH(const QString, script);
        const auto ran = runProcess({"sh", "-c", script.toStdString()});
        QVERIFY2(ran, test::why(ran).constData());
        QTEST(ran->exitCode, "code");
        QTEST(QString::fromStdString(ran->said), "said");
    }

    void longTextKeepsItsEnd()
    {
        const auto ran = runProcess({"sh", "-c", "seq 1 100000"});
        QVERIFY(ran && ran->said.size() <= 4096 && ran->said.ends_with("\n100000\n"));
    }

    /// With what it has started: the child of a shell holds the pipe.
    void aCancelKillsIt()
    {
        std::stop_source stop;
        std::jthread later([&] { stop.request_stop(); });
        const auto ran = runProcess({"sh", "-c", "sleep 1000 & sleep 1000"}, {stop.get_token(), {}});
        QVERIFY(!ran);
        QCOMPARE(ran.error().code, ErrorCode::Cancelled);
    }
};

RAMURE_SUITE(TestChildProcess)

} // namespace tst_child_process

#include "tst_child_process.moc"
