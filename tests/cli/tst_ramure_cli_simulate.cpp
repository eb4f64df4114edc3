#include "tests/cli/cli_support.h"
#include <QJsonArray>

namespace tst_ramure_cli_simulate {

using namespace ramure;
using test::isRefused;
using test::runCli;

class TestRamureCliSimulate : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QStringList rows(const char* name) const
    {
        return QString::fromUtf8(test::bytesOf(path(name))).split(u'\n', Qt::SkipEmptyParts);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void badUseIsRefused()
    {
        QVERIFY(isRefused(runCli({"simulate"}), "missing INPUT"));
        QVERIFY(isRefused(runCli({"simulate", "preset:TinyTree"}), "missing --steps N"));
        for (const char* steps : {"", "x", "-1", "1.5", "10000001", "99999999999999999999"})
            QVERIFY(isRefused(runCli({"simulate", "preset:TinyTree", "--steps", steps}),
                              "a whole number from 0 to 10000000 expected"));
        QVERIFY(isRefused(runCli({"simulate", "preset:Oak", "--steps", "1"}), "Oak"));
        QVERIFY(isRefused(runCli({"simulate", "none.ramure", "--steps", "1"}), "none.ramure"));
        QVERIFY(
            isRefused(runCli({"simulate", "preset:TinyTree", "--steps", "1", "--csv", path("none/x.csv")}),
                      "none/x.csv"));
        QVERIFY(
            isRefused(runCli({"simulate", "preset:TinyTree", "--steps", "1", "--tree", "Oak"}), "--tree"));
        QVERIFY(
            isRefused(runCli({"simulate", "preset:TinyTree", "--steps", "1", "--set", "physics.mode=quick"}),
                      "physics.mode: must be one of faithful, robust, not \"quick\""));
        QVERIFY(isRefused(
            runCli({"simulate", "preset:TinyTree", "--steps", "1", "--set", "physics.stepSeconds=0"}),
            "physics.stepSeconds"));
        test::write(path("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QVERIFY(
            isRefused(runCli({"simulate", path("flat.obj"), "--steps", "1"}), "is a mesh: only trees move"));
        QVERIFY(!QFile::exists(path("none/x.csv")));
    }

    void rowsAreThoseOfTheSpecification()
    {
        const QStringList command{"simulate", "preset:TinyTree",       "--steps", "300",
                                  "--set",    "physics.mode=faithful", "--json"};
        const test::CliRun run = runCli(command + QStringList{"--csv", path("a.csv")});
        QCOMPARE(run.code, 0);
        QVERIFY(run.err.isEmpty());
        QCOMPARE(run.keys(), (QStringList{"apples", "branches", "kineticEnergy", "largestTurn", "lengthError",
                                          "stepMilliseconds", "steps", "time", "tip"}));
        QCOMPARE(run.json()["branches"].toInt(), 111);
        QCOMPARE(run.json()["steps"].toInt(), 300);
        QCOMPARE(run.json()["time"].toDouble(), 3.0);
        QVERIFY(run.json()["largestTurn"].toDouble() > 0.1);
        const QStringList table = rows("a.csv");
        QCOMPARE(table.size(), 302);
        QCOMPARE(table.first(), QStringLiteral("step,time,lengthError,kineticEnergy,tipX,tipY,tipZ"));
        for (qsizetype k = 0; k + 1 < table.size(); ++k) {
            const QStringList row = table[k + 1].split(u',');
            QCOMPARE(row.size(), 7);
            QCOMPARE(row[0].toInt(), k);
            QVERIFY(std::abs(row[1].toDouble() - 0.01 * double(k)) < 1e-12);
            QVERIFY(row[2].toDouble() < 1e-6);
            QCOMPARE(row[3].toDouble() > 0.0, k > 0);
        }
        QCOMPARE(table.last().split(u',')[4].toDouble(), run.json()["tip"].toArray()[0].toDouble());
        QCOMPARE(runCli(command + QStringList{"--csv", path("b.csv")}).code, 0);
        QCOMPARE(test::bytesOf(path("a.csv")), test::bytesOf(path("b.csv")));
    }

    void parametersCount()
    {
        const auto tip = [](const QStringList& sets) {
            QStringList command{"simulate", "preset:TinyTree", "--steps", "50", "--json"};
            for (const QString& set : sets)
                command << "--set" << set;
            return runCli(command).json()["tip"].toArray();
        };
        QVERIFY(tip({}) == tip({"physics.mode=robust"}));
        for (const char* set : {"physics.mode=faithful", "physics.seed=2", "physics.windStrength=0",
                                "physics.windDirection=1", "physics.gravity=0", "physics.restFrame=world"})
            QVERIFY2(tip({set}) != tip({}), set);
        QVERIFY(runCli({"simulate", "preset:TinyTree", "--steps", "0"}).out.contains("lengthError"));
        const QJsonArray rest =
            runCli({"simulate", "preset:TinyTree", "--steps", "0", "--json"}).json()["tip"].toArray();
        QVERIFY(tip({"physics.windStrength=0"}) == rest); // settled
        QVERIFY(tip({"physics.windStrength=0", "physics.settled=false"}) != rest);
        QVERIFY(tip({"physics.windStrength=0", "physics.gravity=0", "physics.settled=false"}) == rest);
    }

    void oneOfSeveralTreesIsChosen()
    {
        test::write(path("grove.ramure"),
                    R"({"format":"ramure","version":1,"nodes":[{"id":1,"kind":"tree","name":"A"},)"
                    R"({"id":2,"kind":"tree","name":"B","params":{"grammar.iterations":3}}]})");
        const test::CliRun run = runCli({"simulate", path("grove.ramure"), "--steps", "1"});
        QVERIFY(isRefused(run, "--tree NAME, one of A, B, expected"));
        QCOMPARE(runCli({"simulate", path("grove.ramure"), "--steps", "1", "--tree", "B"}).code, 0);
    }
};

RAMURE_SUITE(TestRamureCliSimulate)

} // namespace tst_ramure_cli_simulate

#include "tst_ramure_cli_simulate.moc"
