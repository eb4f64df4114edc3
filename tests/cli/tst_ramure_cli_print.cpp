#include "tests/cli/cli_support.h"
#include <QJsonArray>

namespace tst_ramure_cli_print {

using namespace ramure;

class TestRamureCliPrint : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    static QStringList words(const QStringList& rest)
    {
        return QStringList{"export", "preset:TinyTree", "--print", "fdm", "--height", "100mm"} + rest;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void onlyOneTreeIsPrinted()
    {
        QVERIFY(test::isRefused(
            test::runCli({"export", "demo:Arm", "-o", path("a.stl"), "--print", "fdm", "--height", "100mm"}),
            "no visible tree to print"));
        QVERIFY(!QFile::exists(path("a.stl")));
    }
    void leavesHaveNames()
    {
        QVERIFY(test::isRefused(test::runCli(words({"-o", path("a.stl"), "--print-leaves", "paper"})),
                                "off or shells"));
        QVERIFY(test::isRefused(
            test::runCli({"export", "preset:TinyTree", "-o", path("a.stl"), "--print-leaves", "shells"}),
            "needs --print"));
        const test::CliRun made =
            test::runCli({"export", "preset:TinyTree", "-o", path("l.stl"), "--print", "resin", "--height",
                          "60mm", "--print-leaves", "shells", "--json"});
        QCOMPARE(made.code, 0);
        const QJsonObject json = made.json();
        QCOMPARE(json.value(QLatin1String("leaves")).toString(), QStringLiteral("shells"));
        QVERIFY(json.value(QLatin1String("shells")).toInt() > 0);
        QCOMPARE(json.value(QLatin1String("pieces")).toInt(), 1);
        QVERIFY(json.value(QLatin1String("closed")).toBool());
    }
    /// One print as two files and two reports; a second run gives the same bytes.
    void filesAndReports()
    {
        const test::CliRun first = test::runCli(
            words({"-o", path("a.stl"), "-o", path("a.3mf"), "--json", "--report", path("a.json")}));
        QCOMPARE(first.code, 0);
        const QJsonObject json = first.json();
        QCOMPARE(json.value(QLatin1String("pieces")).toInt(), 1);
        QCOMPARE(json.value(QLatin1String("crossings")).toInt(), 0);
        QVERIFY(json.value(QLatin1String("closed")).toBool());
        QVERIFY(json.value(QLatin1String("thinnest")).toDouble() >= 1.98);
        QVERIFY(std::abs(json.value(QLatin1String("size")).toArray().at(2).toDouble() - 100.0) < 1.0);
        QFile report(path("a.json"));
        QVERIFY(report.open(QIODevice::ReadOnly));
        QCOMPARE(QJsonDocument::fromJson(report.readAll()).object(), json);
        const test::CliRun second = test::runCli(words({"-o", path("b.stl"), "-o", path("b.3mf")}));
        QCOMPARE(second.code, 0);
        QVERIFY(second.out.contains(QLatin1String("yes, ")));
        for (const char* ending : {".stl", ".3mf"}) {
            QFile a(path("a") + QLatin1String(ending)), b(path("b") + QLatin1String(ending));
            QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
            QVERIFY2(a.readAll() == b.readAll(), ending);
        }
        // What was written is read, in metres with Y up, and valid.
        const test::CliRun checked = test::runCli({"validate", path("a.3mf"), "--json"});
        QCOMPARE(checked.code, 0);
        QVERIFY(std::abs(checked.json().value(QLatin1String("volume")).toDouble() * 1e9 /
                             json.value(QLatin1String("volume")).toDouble() -
                         1.0) < 1e-4);
    }
};

RAMURE_SUITE(TestRamureCliPrint)

} // namespace tst_ramure_cli_print

#include "tst_ramure_cli_print.moc"
