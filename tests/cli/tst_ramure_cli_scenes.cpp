#include "tests/cli/cli_support.h"
#include <QJsonArray>
#include <cmath>

namespace tst_ramure_cli_scenes {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// Scenes of more than trees on the command line: arms, terrains, primitives.
class TestRamureCliScenes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    /// They grow as the text says, and the place is told.
    void lookalikesInAGrammarAreWarnings()
    {
        const auto run = [](const char* command, const char* minus) {
            return runCli({QString::fromLatin1(command), QStringLiteral("preset:SmallTree"),
                           QStringLiteral("--json"), QStringLiteral("--set"),
                           QStringLiteral("grammar.iterations=2"), QStringLiteral("--set"),
                           QStringLiteral("grammar.rules=A -> B[+B]%1B").arg(QString::fromUtf8(minus))});
        };
        for (const char* command : {"info", "validate"}) {
            const auto typed = run(command, "-"), pasted = run(command, "\u2212");
            QCOMPARE(typed.code, 0);
            QCOMPARE(pasted.code, 0);
            QVERIFY(typed.err.isEmpty() && !typed.json().contains(QStringLiteral("warnings")));
            QVERIFY2(pasted.err.startsWith(QStringLiteral("ramure-cli: warning: 1:11: grammar.rules: "
                                                          "\"\u2212\" (U+2212)")),
                     qPrintable(pasted.err));
            QCOMPARE(pasted.err.count(u'\n'), 1);
            const QJsonArray warnings = pasted.json().value(QStringLiteral("warnings")).toArray();
            QCOMPARE(warnings.size(), 1);
            QCOMPARE(warnings[0].toObject().value(QStringLiteral("column")).toInt(), 11);
            QCOMPARE(warnings[0].toObject().value(QStringLiteral("path")).toString(),
                     QStringLiteral("grammar.rules"));
        }
    }

    void unknownNodesAreRefused()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("a.obj");
        QVERIFY(isRefused(runCli({"export", "demo:Arm", "--node", "Leg", "-o", file}), "\"Leg\""));
        QVERIFY(isRefused(runCli({"validate", "demo:Arm", "--node", ""}), "no node has this name"));
        QVERIFY(isRefused(runCli({"render", "demo:Arm", "--node", "arm", "-o", folder.filePath("a.png")}),
                          "\"arm\""));
        QVERIFY(!QFile::exists(file));
        QCOMPARE(runCli({"export", "demo:Arm", "-o", file}).code, 0);
        QVERIFY(isRefused(runCli({"validate", file, "--node", "Arm"}), "the input is a mesh"));
    }

    void allNodesAreWrittenOrOne()
    {
        QTemporaryDir folder;
        const QString all = folder.filePath("all.obj"), one = folder.filePath("one.ply");
        QCOMPARE(runCli({"export", "demo:Arm", "--time", "2", "-o", all, "--require-valid"}).code, 0);
        const QJsonArray objects = runCli({"info", all, "--json"}).json()["objects"].toArray();
        QCOMPARE(objects.size(), 2);
        QCOMPARE(objects[0]["name"].toString(), QString("Arm"));
        QCOMPARE(objects[1]["name"].toString(), QString("Terrain"));
        QCOMPARE(runCli({"export", "demo:Arm", "--node", "Arm", "--time", "2", "-o", one}).code, 0);
        const auto checked = runCli({"validate", one, "--json"});
        QCOMPARE(checked.code, 0);
        QCOMPARE(checked.json()["vertices"].toInt(), objects[0]["vertices"].toInt());
    }

    void partOfAHierarchyStaysInItsPlace()
    {
        QTemporaryDir folder;
        const QString all = folder.filePath("all.obj"), one = folder.filePath("one.obj");
        QCOMPARE(runCli({"export", "demo:MovingTree", "--time", "1", "-o", all}).code, 0);
        QCOMPARE(runCli({"export", "demo:MovingTree", "--time", "1", "--node", "Branch 2.3", "-o", one}).code,
                 0);
        const QJsonArray whole = runCli({"info", all, "--json"}).json()["objects"].toArray();
        const QJsonArray part = runCli({"info", one, "--json"}).json()["objects"].toArray();
        QCOMPARE(whole.size(), 1365);
        QCOMPARE(part.size(), 1 + 4 + 16 + 64); // it and three levels below it
        for (const QJsonValue& object : whole)
            if (object["name"].toString() == QLatin1String("Branch 2.3"))
                QCOMPARE(part[0].toObject(), object.toObject());
    }

    void everyNodeIsValidated()
    {
        const auto run = runCli({"validate", "demo:Arm", "--time", "1", "--json"});
        QCOMPARE(run.code, 0);
        const QJsonArray nodes = run.json()["nodes"].toArray();
        QCOMPARE(nodes.size(), 2);
        QCOMPARE(nodes[0]["kind"].toString(), QString("arm"));
        QCOMPARE(nodes[0]["boundaryEdges"].toInt(), 0);
        QVERIFY(nodes[0]["openSurface"].isUndefined());
        QCOMPARE(nodes[1]["kind"].toString(), QString("terrain"));
        QVERIFY(nodes[1]["openSurface"].isUndefined()); // a block of earth
        QVERIFY(nodes[1]["valid"].toBool());
        QCOMPARE(nodes[1]["boundaryEdges"].toInt(), 0);
        QCOMPARE(nodes[1]["eulerCharacteristic"].toInt(), 2);
        QVERIFY(!run.json().contains("trees"));
        const auto thin = runCli({"validate", "demo:Arm", "--set", "terrain.depth=0", "--json"});
        QCOMPARE(thin.code, 0);
        const QJsonObject sheet = thin.json()["nodes"][1].toObject();
        QVERIFY(sheet["openSurface"].toBool() && sheet["valid"].toBool());
        QCOMPARE(sheet["boundaryEdges"].toInt(), 4 * 128);
        QVERIFY(runCli({"validate", "demo:Arm"}).out.contains("\n2 nodes\n"));
        // One alone is told as one mesh always was.
        const auto arm = runCli({"validate", "demo:Arm", "--node", "Arm"});
        QCOMPARE(arm.code, 0);
        QVERIFY(arm.out.startsWith("valid"));
    }

    void infoMeasuresThem()
    {
        const auto run = runCli({"info", "demo:Arm", "--json"});
        QCOMPARE(run.code, 0);
        const QJsonObject arm = run.json()["nodes"][0].toObject(), land = run.json()["nodes"][1].toObject();
        QCOMPARE(arm["joints"].toInt(), 3);
        QVERIFY(std::abs(arm["reach"].toDouble() - 4.4) < 1e-9);
        QVERIFY(std::abs(arm["tip"][0].toDouble() - 1.7177032) < 1e-6);
        QVERIFY(arm["vertices"].toInt() > 1000);
        QCOMPARE(land["faces"].toInt(),
                 2 * 128 * 128 + 4 * 128 * 5); // two bands on the sides, and the bottom
        // With the time the arm moves.
        const auto later = runCli({"info", "demo:Arm", "--json", "--time", "5"});
        QVERIFY(std::abs(later.json()["nodes"][0]["tip"][0].toDouble() - 1.0) < 1e-3);
    }
};

RAMURE_SUITE(TestRamureCliScenes)

} // namespace tst_ramure_cli_scenes

#include "tst_ramure_cli_scenes.moc"
