#include "tests/cli/cli_support.h"
#include <QJsonArray>
#include <QSet>

namespace tst_ramure_cli_scatter {

using namespace ramure;
using test::runCli;

/// A wood on the command line, and its files.
class TestRamureCliScatter : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    QByteArray bytes(const char* name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatMakesNoWoodIsRefused()
    {
        const QString out = path("bad.ramure");
        const auto refuses = [&](const QStringList& arguments, const char* why) {
            const auto run = runCli(QStringList{"scatter"} + arguments);
            if (run.code != 2 || !run.err.contains(QLatin1String(why)) || QFile::exists(out))
                qWarning("%s: %s", qPrintable(arguments.join(u' ')), qPrintable(run.err));
        };
        const QStringList tiny{"--tree", "preset:TinyTree"};
        refuses({"-o", out}, "--tree");
        refuses(tiny, "-o FILE.ramure");
        refuses(tiny + QStringList{"-o", path("bad.glb")}, "-o FILE.ramure");
        refuses({"--tree", "preset:NoSuchTree", "-o", out}, "NoSuchTree");
        refuses({"preset:NoSuchTree", "--tree", "preset:TinyTree", "-o", out}, "NoSuchTree");
        refuses(tiny + QStringList{"--count", "many", "-o", out}, "--count");
        refuses(tiny + QStringList{"--count", "-1", "-o", out}, "--count");
        refuses(tiny + QStringList{"--spacing", "-1", "-o", out}, "--spacing");
        refuses(tiny + QStringList{"--area", "100", "-o", out}, "--area");
        refuses(tiny + QStringList{"--area", "100x0", "-o", out}, "scatter.depth");
        refuses(tiny + QStringList{"--area", "1x2x3", "-o", out}, "--area");
        refuses(tiny + QStringList{"--on", "nowhere.obj", "-o", out}, "nowhere.obj");
        refuses(tiny + QStringList{"--set", "scatter.steepest=9", "-o", out}, "scatter.steepest");
        refuses(tiny + QStringList{"--count", "0", "--spacing", "0", "-o", out}, "spacing");
        refuses(tiny + QStringList{"--set", "scatter.lowest=5", "-o", out}, "no copy");
    }

    void aWoodOnAHill()
    {
        QFile hill(path("hill.obj"));
        QVERIFY(hill.open(QIODevice::WriteOnly));
        hill.write("v -20 0 -10\nv 20 4 -10\nv 20 4 10\nv -20 0 10\nf 1 4 3 2\n");
        hill.close();
        const auto made = runCli({"scatter", "--tree", "preset:TinyTree", "--tree", "preset:SmallTree",
                                  "--on", hill.fileName(), "--count", "50", "--spacing", "2", "--seed", "3",
                                  "--json", "-o", path("wood.ramure")});
        QCOMPARE(made.code, 0);
        QCOMPARE(made.json()["copies"].toInt(), 50);
        QCOMPARE(made.json()["prototypes"].toArray().size(), 2);
        // As a list beside a file, and in a GLB, which counts each mesh once.
        QCOMPARE(
            runCli({"export", path("wood.ramure"), "--leaves", "instances", "-o", path("wood.obj")}).code, 0);
        const QString table = QString::fromUtf8(bytes("wood_leaves.csv"));
        QSet<QString> keys;
        for (const QString& line : table.split(u'\n', Qt::SkipEmptyParts).mid(1)) {
            const QStringList cells = line.split(u',');
            QCOMPARE(cells[0], QStringLiteral("Scatter"));
            keys.insert(cells[6]);
            const double x = cells[14].toDouble(), y = cells[18].toDouble();
            QVERIFY(std::abs(y - 0.1 * (x + 20.0)) < 1e-3);
        }
        QCOMPARE(keys.size(), 50);
        QCOMPARE(runCli({"export", path("wood.ramure"), "-o", path("wood.glb")}).code, 0);
        QVERIFY(bytes("wood.glb").contains("EXT_mesh_gpu_instancing"));
        QCOMPARE(runCli({"export", path("wood.ramure"), "-o", path("wood.usda")}).code, 0);
        QCOMPARE(bytes("wood.usda").count("def PointInstancer"), 6); // branches, leaves and fruit of both
        QVERIFY(table.contains("branches_TinyTree"));
        // Read back, all copies are there.
        const auto read = runCli({"info", path("wood.glb"), "--json"});
        QCOMPARE(read.code, 0);
        QVERIFY(read.json()["faces"].toInt() > 1'000'000);
    }

    void theSameBytesEachTime()
    {
        for (const char* name : {"a", "b"})
            QCOMPARE(
                runCli({"scatter", "--tree", "preset:TinyTree", "--count", "30", "-o", path("same.ramure")})
                        .code +
                    runCli({"export", path("same.ramure"), "-o",
                            m_folder.filePath(QLatin1String(name) + ".glb")})
                        .code,
                0);
        QVERIFY(bytes("a.glb") == bytes("b.glb") && !bytes("a.glb").isEmpty());
    }

    void whatCopiesCannotHoldIsRefused()
    {
        QCOMPARE(
            runCli({"scatter", "--tree", "preset:TinyTree", "--count", "9", "-o", path("w.ramure")}).code, 0);
        for (const QStringList& option :
             {QStringList{"--levels", "3"}, QStringList{"--wind", "unity"},
              QStringList{"--model", "skeleton"}, QStringList{"--frames", "0:3"}}) {
            const auto run = runCli(QStringList{"export", path("w.ramure"), "-o", path("no.glb")} + option);
            QCOMPARE(run.code, 2);
            QVERIFY2(run.err.contains(QLatin1String("Scatter: copies of a scatter")), qPrintable(run.err));
        }
        QVERIFY(!QFile::exists(path("no.glb")));
        // A prototype by itself has all of it.
        QCOMPARE(
            runCli({"export", path("w.ramure"), "--node", "TinyTree", "--levels", "3", "-o", path("one.glb")})
                .code,
            0);
        QCOMPARE(runCli({"export", path("w.ramure"), "-o", path("merged.obj")}).code, 0);
        QCOMPARE(bytes("merged.obj").count("\no "), 3);
    }
};

RAMURE_SUITE(TestRamureCliScatter)

} // namespace tst_ramure_cli_scatter

#include "tst_ramure_cli_scatter.moc"
