#include "core/io/mesh_file.h"
#include "tests/cli/cli_support.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace ramure;
using namespace ramure::test;

/// --time and --frames: trees at a moment, and sequences of files.
class TestRamureCliMotion : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    static TriangleMesh read(const QString& file)
    {
        const auto mesh = readMeshFile(file.toStdString());
        if (!mesh)
            qFatal("%s", why(mesh).constData());
        return mesh->joined();
    }

private slots:
    void init() { failOnAnyWarning(); }

    void badMoments_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("says");
        const auto row = [](const QStringList& options, const char* says) {
            QTest::newRow(qPrintable(options.join(u' '))) << options << QString(says);
        };
        row({"--time", "-1"}, "--time");
        row({"--time", "soon"}, "--time");
        row({"--time", "nan"}, "--time");
        row({"--time", "1e300"}, "--time");
        row({"--time", "1", "--frames", "0:1"}, "not both");
        row({"--frames", "5"}, "FIRST:LAST");
        row({"--frames", "5:4"}, "FIRST:LAST");
        row({"--frames", "0:4:0"}, "FIRST:LAST");
        row({"--frames", "-1:4"}, "FIRST:LAST");
        row({"--frames", "0:1:2:3"}, "FIRST:LAST");
        row({"--frames", "0:1000000"}, "more than");
        row({"--frames", "0:1", "--fps", "0"}, "--fps");
        row({"--frames", "0:1", "--require-valid"}, "one moment");
    }
    void badMoments()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, says);
        const QStringList before = QDir(m_folder.path()).entryList(QDir::Files);
        QVERIFY(isRefused(runCli(QStringList{"export", "preset:TinyTree", "-o", path("bad.obj")} + options),
                          qPrintable(says)));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files), before);
    }
    void meshesDoNotMove()
    {
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("still.ply")}).code, 0);
        QVERIFY(isRefused(runCli({"export", path("still.ply"), "-o", path("x.ply"), "--time", "1"}), "mesh"));
    }
    void timeZeroIsRest()
    {
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("rest.ply")}).code, 0);
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("zero.ply"), "--time", "0"}).code, 0);
        QCOMPARE(bytesOf(path("zero.ply")), bytesOf(path("rest.ply")));
    }
    void framesAreTheirTimes()
    {
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("seq.ply"), "--frames", "10:30:10", "--fps",
                         "20"})
                     .code,
                 0);
        const TriangleMesh rest = read(path("rest.ply"));
        for (const auto& [frame, time] :
             {std::pair{"seq_0010.ply", "0.5"}, std::pair{"seq_0030.ply", "1.5"}}) {
            QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("one.ply"), "--time", time}).code, 0);
            QCOMPARE(bytesOf(path(frame)), bytesOf(path("one.ply")));
            QCOMPARE(read(path(frame)).triangles, rest.triangles);
            QVERIFY(read(path(frame)).positions != rest.positions);
        }
        QVERIFY(QFile::exists(path("seq_0020.ply")));
        QVERIFY(!QFile::exists(path("seq_0000.ply")) && !QFile::exists(path("seq.ply")));
    }
    void textureStaysThatOfTheRest()
    {
        for (const char* ending : {"obj", "ply"}) {
            const QString rest = path("textured.") + QLatin1String(ending);
            const QString moved = path("moving.") + QLatin1String(ending);
            QCOMPARE(runCli({"export", "preset:TinyTree", "--texture", "-o", rest}).code, 0);
            QCOMPARE(runCli({"export", "preset:TinyTree", "--texture", "-o", moved, "--time", "1"}).code, 0);
            const TriangleMesh before = read(rest), now = read(moved);
            QVERIFY(!now.uv.empty() && now.positions != before.positions);
            QVERIFY(now.uv == before.uv && now.uvTriangles == before.uvTriangles);
        }
        QCOMPARE(
            runCli({"export", "preset:TinyTree", "--texture", "-o", path("film.obj"), "--frames", "23:24"})
                .code,
            0);
        QCOMPARE(bytesOf(path("film_0024.obj")).replace("film_0024", "moving"), bytesOf(path("moving.obj")));
        const QJsonObject still = runCli({"validate", "preset:TinyTree", "--texture", "--json"}).json();
        const QJsonObject then =
            runCli({"validate", "preset:TinyTree", "--texture", "--json", "--time", "1"}).json();
        const QJsonObject a = still.value("texture").toObject(), b = then.value("texture").toObject();
        QCOMPARE(b.value("mirrored").toInt(-1), 0);
        QCOMPARE(b.value("triangles"), a.value("triangles"));
        QVERIFY(b.value("stretch95") != a.value("stretch95"));
    }
    void movedMeshesAreValid()
    {
        const CliRun checked = runCli({"validate", "preset:SmallTree", "--json", "--time", "2.5"});
        QCOMPARE(checked.code, 0);
        QVERIFY(QJsonDocument::fromJson(checked.out.toUtf8()).object().value("valid").toBool());
        QCOMPARE(runCli({"export", "preset:SmallTree", "-o", path("valid.obj"), "--time", "2.5",
                         "--require-valid", "--report", path("valid.json")})
                     .code,
                 0);
        QVERIFY(QFile::exists(path("valid.obj")) && QFile::exists(path("valid.json")));
    }
};

QTEST_GUILESS_MAIN(TestRamureCliMotion)

#include "tst_ramure_cli_motion.moc"
