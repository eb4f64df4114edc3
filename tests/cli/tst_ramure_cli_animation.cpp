#include "tests/cli/cli_support.h"

#include <QDir>
#include <QJsonArray>

namespace tst_ramure_cli_animation {

using namespace ramure;

static const QByteArray triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class TestRamureCliAnimation : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badInputIsRefused()
    {
        QTemporaryDir folder;
        const QString project = folder.filePath(QStringLiteral("a.ramure"));
        QVERIFY(test::isRefused(test::runCli({"info", "demo:Nothing"}), "MovingTree"));
        QVERIFY(test::isRefused(test::runCli({"import", folder.path()}), "-o"));
        QVERIFY(test::isRefused(test::runCli({"import", folder.path(), "-o", project}), "no .obj"));
        QVERIFY(test::isRefused(test::runCli({"import", folder.path(), "-o", "a.txt"}), ".ramure"));
        test::write(folder.filePath(QStringLiteral("a.obj")), triangle);
        test::write(folder.filePath(QStringLiteral("a.animation")), "0,LINEAR,0\n");
        QVERIFY(test::isRefused(test::runCli({"import", folder.path(), "-o", project}), "a.animation:1"));
        QVERIFY(!QFile::exists(project));
    }
    void infoTellsWhereEveryNodeIs()
    {
        const auto run = test::runCli({"info", "demo:MovingTree", "--time", "2.5", "--json"});
        QCOMPARE(run.code, 0);
        const QJsonArray nodes = run.json().value(QStringLiteral("nodes")).toArray();
        QCOMPARE(nodes.size(), 1365);
        const QJsonArray world = nodes[1][QStringLiteral("world")].toArray();
        QCOMPARE(world.size(), 16);
        // T(0, 1, 0) Ry(35) Rx(35) S(0.75), row after row.
        const double a = qDegreesToRadians(35.0), s = 0.75;
        const double expected[16] = {
            s * cos(a),  s * sin(a) * sin(a), s * sin(a) * cos(a), 0, 0, s * cos(a), -s * sin(a), 1,
            -s * sin(a), s * cos(a) * sin(a), s * cos(a) * cos(a), 0, 0, 0,          0,           1};
        for (int i = 0; i < 16; ++i)
            QVERIFY2(std::abs(world[i].toDouble() - expected[i]) < 1e-9, qPrintable(QString::number(i)));
    }
    void aFolderBecomesAProjectAndGoesRound()
    {
        QTemporaryDir folder;
        test::write(folder.filePath(QStringLiteral("Big wheel.obj")),
                    triangle + "TRANSFORM 1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1\n");
        test::write(folder.filePath(QStringLiteral("Hub.obj")), "# parent=Big wheel\n" + triangle);
        test::write(folder.filePath(QStringLiteral("Hub.animation")),
                    "0,CUBIC,0,0,0,0,0,0,1,1,1,1\n1,CUBIC,1,2,3,0,0,0,1,1,1,1\n");
        const QString project = folder.filePath(QStringLiteral("a.ramure"));
        const auto made = test::runCli({"import", folder.path(), "-o", project, "--json"});
        QCOMPARE(made.code, 0);
        QVERIFY(made.out.contains(QStringLiteral("CUBIC")));
        const auto before = test::runCli({"info", project, "--time", "0.25", "--json"});
        QCOMPARE(before.code, 0);
        QDir(folder.path()).mkdir(QStringLiteral("out"));
        const QString out = folder.filePath(QStringLiteral("out"));
        QCOMPARE(test::runCli({"import", project, "-o", out}).code, 0);
        const QString again = folder.filePath(QStringLiteral("b.ramure"));
        QCOMPARE(test::runCli({"import", out, "-o", again}).code, 0);
        const auto after = test::runCli({"info", again, "--time", "0.25", "--json"});
        const auto hub = [](const test::CliRun& run) {
            for (const QJsonValue& node : run.json().value(QStringLiteral("nodes")).toArray())
                if (node[QStringLiteral("name")] == QStringLiteral("Hub"))
                    return node[QStringLiteral("world")].toArray();
            return QJsonArray();
        };
        QCOMPARE(hub(before).size(), 16);
        for (int i = 0; i < 16; ++i)
            QVERIFY(std::abs(hub(before)[i].toDouble() - hub(after)[i].toDouble()) < 1e-9);
    }
    void primitivesAreCheckedAndWritten()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("c.obj"));
        QCOMPARE(test::runCli({"validate", "demo:MovingCylinder"}).code, 0);
        QCOMPARE(test::runCli({"export", "demo:MovingCylinder", "--time", "1.25", "-o", file}).code, 0);
        QCOMPARE(test::runCli({"validate", file}).code, 0);
    }
};

RAMURE_SUITE(TestRamureCliAnimation)

} // namespace tst_ramure_cli_animation

#include "tst_ramure_cli_animation.moc"
