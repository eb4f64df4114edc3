#include "tests/cli/cli_support.h"
#include <QJsonArray>
#include <cmath>

namespace tst_ramure_cli_ik {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// `ramure-cli ik`.
class TestRamureCliIk : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badUseIsRefused()
    {
        QVERIFY(isRefused(runCli({"ik"}), "missing INPUT"));
        QVERIFY(isRefused(runCli({"ik", "demo:Arm"}), "missing --target X,Y,Z"));
        for (const char* target : {"1", "1,2", "a,b,c", "1,2,nan", "1,2,inf"})
            QVERIFY(isRefused(runCli({"ik", "demo:Arm", "--target", target}), "X,Y,Z expected"));
        QVERIFY(isRefused(runCli({"ik", "demo:Arm", "--target", "1,2,2", "--solver", "magic"}), "magic"));
        for (const char* steps : {"x", "-1", "1.5", "99999999999"})
            QVERIFY(isRefused(runCli({"ik", "demo:Arm", "--target", "1,2,2", "--steps", steps}), "--steps"));
        QVERIFY(isRefused(runCli({"ik", "demo:Arm", "--target", "1,2,2", "--node", "Leg"}), "Leg"));
        QVERIFY(isRefused(runCli({"ik", "preset:TinyTree", "--target", "1,2,2"}), "holds no arm"));
        QVERIFY(isRefused(runCli({"ik", "none.ramure", "--target", "1,2,2"}), "none.ramure"));
    }

    void bothSolversReachTheTarget()
    {
        for (const char* solver : {"dls", "transpose"}) {
            const auto run = runCli({"ik", "demo:Arm", "--target", "1,2,2", "--solver", solver, "--json"});
            QCOMPARE(run.code, 0);
            QVERIFY(run.err.isEmpty());
            QCOMPARE(run.keys(),
                     (QStringList{"angles", "anglesAtLimit", "reached", "residual", "steps", "tip"}));
            QCOMPARE(run.json()["angles"].toArray().size(), 3);
            QVERIFY(run.json()["reached"].toBool());
            QVERIFY(run.json()["residual"].toDouble() <= 1e-4);
            const QJsonArray tip = run.json()["tip"].toArray();
            QVERIFY(std::abs(tip[0].toDouble() - 1.0) + std::abs(tip[1].toDouble() - 2.0) +
                        std::abs(tip[2].toDouble() - 2.0) <
                    3e-4);
            const int steps = run.json()["steps"].toInt();
            QVERIFY(solver[0] == 'd' ? steps < 30 : steps > 30);
        }
    }

    void outOfReachIsTold()
    {
        const auto run = runCli({"ik", "demo:Arm", "--target", "10,0,0", "--json"});
        QCOMPARE(run.code, 1);
        QVERIFY(!run.json()["reached"].toBool());
        QVERIFY(std::abs(run.json()["residual"].toDouble() - (10.0 - 4.4)) < 0.01);
    }

    void noStepIsTheDefaultPose()
    {
        const auto run = runCli({"ik", "demo:Arm", "--target", "1,2,2", "--steps", "0", "--json"});
        QCOMPARE(run.code, 1);
        const QJsonArray tip = run.json()["tip"].toArray();
        QVERIFY(std::abs(tip[0].toDouble() - 1.7177032) < 1e-6);
        QVERIFY(std::abs(tip[1].toDouble() - 2.0079169) < 1e-6);
        QVERIFY(std::abs(tip[2].toDouble() - 3.4335330) < 1e-6);
    }

    void textSaysTheSame()
    {
        const auto run = runCli({"ik", "demo:Arm", "--target", "1,2,2"});
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.contains(QLatin1String("joint 3: phi ")));
        QVERIFY(run.out.endsWith(QLatin1String("reached  yes\n")));
    }

    void numbersOfJointsAreSettings()
    {
        for (const char* wrong : {"joints[0].phi", "joints[0].length", "joints[70].length=1",
                                  "joints[0].length=far", "joints[0].length=-1", "joints[1].phi.min=9"})
            QVERIFY2(runCli({"ik", "demo:Arm", "--target", "1,2,2", "--set", wrong}).code != 0, wrong);
        const auto run =
            runCli({"ik", "demo:Arm", "--target", "0,0,9", "--json", "--set", "joints[0].length=4", "--set",
                    "joints[1].length=3", "--set", "joints[2].length=2"});
        QCOMPARE(run.code, 1);
        QVERIFY(run.json()["residual"].toDouble() < 0.05); // out of reach by a hair: 0.999 of it is aimed at
    }

    void parametersOfTheArmCount()
    {
        const auto run = runCli({"ik", "demo:Arm", "--target", "1,2,2", "--json", "--set",
                                 "ik.solver=transpose", "--set", "ik.tolerance=0.1"});
        QCOMPARE(run.code, 0);
        const double residual = run.json()["residual"].toDouble();
        QVERIFY(residual > 0.01 && residual <= 0.1);
    }
};

RAMURE_SUITE(TestRamureCliIk)

} // namespace tst_ramure_cli_ik

#include "tst_ramure_cli_ik.moc"
