#include "core/io/mesh_file.h"
#include "tests/cli/cli_support.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtEndian>
#include <cmath>

namespace tst_ramure_cli_motion {

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
        row({"--wind-loop", "0"}, "--wind-loop");
        row({"--wind-loop", "x"}, "--wind-loop");
        row({"--wind-loop", "2", "--frames", "0:1"}, "no --frames");
        row({"--wind-loop", "2", "--seamless"}, "no --seamless");
        row({"--wind-loop", "3600", "--fps", "240"}, "more than");
        row({"--wind-loop", "2"}, "cannot move");
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
    /// Of each joint the last key is the first, and the speed changes there no more than it does elsewhere.
    void aWindLoopHasNoSeam()
    {
        const CliRun run = runCli({"export", "preset:TinyTree", "-o", path("loop.glb"), "--wind-loop", "3",
                                   "--fps", "24", "--joints", "all", "--map-size", "0"});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QFile file(path("loop.glb"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        const auto word = [&](qsizetype at) { return qFromLittleEndian<quint32>(bytes.constData() + at); };
        const qsizetype textLength = word(12), bin = 20 + textLength + 8;
        const QJsonObject json = QJsonDocument::fromJson(bytes.mid(20, textLength)).object();
        const QJsonObject animation = json["animations"].toArray().first().toObject();
        int seen = 0;
        double most = 0.0;
        for (const QJsonValue& sampler : animation["samplers"].toArray()) {
            const QJsonObject accessor = json["accessors"].toArray().at(sampler["output"].toInt()).toObject();
            const QJsonObject view =
                json["bufferViews"].toArray().at(accessor["bufferView"].toInt()).toObject();
            QCOMPARE(accessor["count"].toInt(), 3 * 24 + 1);
            const int width = accessor["type"].toString() == "VEC4" ? 4 : 3;
            const char* from = bytes.constData() + bin + view["byteOffset"].toInteger();
            const auto key = [&](int k, int c) {
                return qFromLittleEndian<float>(from + 4 * (k * width + c));
            };
            for (int c = 0; c < width; ++c) {
                const double start = key(0, c), end = key(72, c);
                QVERIFY(std::abs(start - end) < 1e-6);
                double bend = 1e-4; // how fast the speed changes elsewhere
                for (int k = 1; k < 72; ++k)
                    bend = std::max(bend, std::abs(double(key(k + 1, c)) - 2.0 * key(k, c) + key(k - 1, c)));
                QVERIFY(std::abs(key(1, c) - start - end + key(71, c)) <= 1.5 * bend);
                most = std::max(most, std::abs(double(key(36, c)) - start));
            }
            ++seen;
        }
        QVERIFY(seen > 5);
        QVERIFY(most > 1e-3); // it does move
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

RAMURE_SUITE(TestRamureCliMotion)

} // namespace tst_ramure_cli_motion

#include "tst_ramure_cli_motion.moc"
