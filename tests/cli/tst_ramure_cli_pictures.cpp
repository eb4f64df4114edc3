#include "tests/cli/cli_support.h"
#include "tests/support/cannot_run.h"
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QRegularExpression>
#include <QStandardPaths>
#include <csignal>

namespace tst_ramure_cli_pictures {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// Render and textures: what is drawn, and what is made for surfaces.
class TestRamureCliPictures : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

    /// Of a picture, how many pixels are so.
    static int countOf(const QImage& image, bool (*isSo)(const QColor&))
    {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += isSo(image.pixelColor(x, y)) ? 1 : 0;
        return count;
    }
    static bool isBlue(const QColor& c) { return c.blue() > 90 && c.red() < 60 && c.green() < 70; }
    static bool isMagenta(const QColor& c) { return c.blue() > 110 && c.red() > 110 && c.green() < 60; }
    QImage rendered(const QStringList& input, const char* name)
    {
        const test::CliRun run =
            runCli(QStringList{"render"} + input + QStringList{"-o", path(name), "--size", "200x200"});
        if (run.code != 0)
            qWarning("%s", qPrintable(run.err));
        return QImage(path(name));
    }

private slots:
    void init() { test::failOnAnyWarning(); }
    void initTestCase() { QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("pics"))); }

    void badPicturesAreNamedAndDrawnAsChecks()
    {
        const QString missing = path("pics/gone.png"), broken = path("pics/broken.png"),
                      wide = path("pics/wide.png");
        QImage blue(64, 64, QImage::Format_RGB32);
        blue.fill(Qt::blue);
        QVERIFY(blue.save(path("pics/whole.png")));
        test::write(broken, test::bytesOf(path("pics/whole.png")).left(20));
        QVERIFY(QImage(30'000, 1, QImage::Format_Grayscale8).save(wide));
        for (const QString& file : {missing, broken, wide}) {
            const QStringList tree = {"preset:TinyTree", "--set", "bark.colourPicture=" + file};
            const test::CliRun run = runCli(QStringList{"info", "--json"} + tree);
            QCOMPARE(run.code, 0);
            const QJsonObject bad = run.json().value("badPictures").toArray().at(0).toObject();
            QCOMPARE(bad.value("file").toString(), file);
            QVERIFY(!bad.value("problem").toString().isEmpty());
            if (file == wide)
                QVERIFY(bad.value("problem").toString().contains("30000"));
            QVERIFY(countOf(rendered(tree, "pics/checks.png"), isMagenta) > 100);
        }
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "--set", "bark.colourPicture=" + missing, "-o",
                                  path("pics/gone.obj")}),
                          missing));
        QVERIFY(!QFile::exists(path("pics/gone.obj")));
        QVERIFY(!runCli({"info", "--json", "preset:TinyTree"}).keys().contains("badPictures"));
    }
    void picturesOfFilesAreDrawnAndExported()
    {
        QImage blue(64, 32, QImage::Format_RGB32);
        blue.fill(Qt::blue);
        const QString file = path("pics/deep blue.jpg");
        QVERIFY(blue.save(file));
        const QStringList bark = {"preset:TinyTree", "--set", "bark.colourPicture=" + file};
        const QStringList bare = {"preset:TinyTree"};
        QCOMPARE(countOf(rendered(bare, "pics/bare.png"), isBlue), 0);
        const int barkPixels = countOf(rendered(bark, "pics/bark.png"), isBlue);
        QVERIFY2(barkPixels > 300, qPrintable(QString::number(barkPixels)));
        const int leafPixels = countOf(
            rendered({"preset:TinyTree", "--set", "foliage.leafColourPicture=" + file}, "pics/leaf.png"),
            isBlue);
        QVERIFY2(leafPixels > 100, qPrintable(QString::number(leafPixels)));

        QVERIFY(runCli(QStringList{"export"} + bark +
                       QStringList{"-o", path("pics/blue.obj"), "--map-size", "64"})
                    .code == 0);
        const QByteArray materials = test::bytesOf(path("pics/blue.mtl"));
        const auto line = QRegularExpression(QStringLiteral("map_Kd (deep_blue_[0-9a-f]{8}\\.jpg)"))
                              .match(QString::fromUtf8(materials));
        QVERIFY2(line.hasMatch(), materials.constData());
        QCOMPARE(test::bytesOf(path("pics/") + line.captured(1)), test::bytesOf(file));
    }

    void texturesRefusesBadInput()
    {
        const QString folder = path("maps");
        QVERIFY(isRefused(runCli({"textures", "preset:TinyTree"}), "missing -o FOLDER"));
        QVERIFY(isRefused(runCli({"textures", "preset:TinyTree", "--set", "bark.family=plain", "--set",
                                  "foliage.leaf=faithful", "-o", folder}),
                          "bark.family"));
        const QStringList birch = {"textures", "preset:TinyTree", "--set", "bark.family=ringed", "-o"};
        for (const char* size : {"0", "15", "8193", "much"})
            QVERIFY(
                isRefused(runCli(birch + QStringList{folder, "--size", size}), "16 to 8192 pixels expected"));
        QVERIFY(!QFile::exists(folder));
        test::write(path("file"), "no folder");
        QVERIFY(isRefused(runCli(birch + QStringList{path("file") + "/maps"}), "the folder cannot be made"));
        QVERIFY(runCli({"export", "preset:TinyTree", "-o", path("mesh.obj"), "--map-size", "0"}).code == 0);
        QVERIFY(isRefused(runCli({"textures", path("mesh.obj"), "-o", folder}), "only trees have a bark"));
    }
    void texturesAndExportWriteTheSamePictures()
    {
        const QStringList tree = {"preset:TinyTree", "--set", "bark.family=ringed"};
        const auto files = [](const QString& folder) {
            return QDir(folder).entryList({QStringLiteral("*.png")}, QDir::Files);
        };
        const QString maps = path("bark/maps");
        const test::CliRun run =
            runCli(QStringList{"textures"} + tree + QStringList{"-o", maps, "--size", "64", "--json"});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const QJsonObject said = run.json();
        QCOMPARE(said.value("files").toArray().size(), 8);
        QCOMPARE(said.value("written").toArray(), said.value("files").toArray());
        QCOMPARE(files(maps).size(), 8);
        QVERIFY(QDir().mkpath(path("export")));
        QCOMPARE(runCli(QStringList{"export"} + tree +
                        QStringList{"-o", path("export/birch.obj"), "--map-size", "64", "--frames", "0:2"})
                     .code,
                 0);
        QCOMPARE(files(path("export")), files(maps)); // once for all frames
        for (const QString& file : files(maps))
            QCOMPARE(test::bytesOf(path("export/") + file), test::bytesOf(maps + u'/' + file));
        QCOMPARE(
            runCli(QStringList{"export"} + tree + QStringList{"-o", path("plain.obj"), "--map-size", "0"})
                .code,
            0);
        QCOMPARE(files(m_folder.path()), QStringList());
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("x.obj"), "--map-size", "9"}),
                          "--map-size"));
    }
    void texturesAreThoseOfTheTime()
    {
        QVERIFY(isRefused(runCli({"textures", "preset:TinyTree", "-o", path("keyed"), "--time", "soon"}),
                          "--time"));
        const QString project = path("keyed.ramure");
        test::write(project, R"({"format": "ramure", "version": 1, "nodes": [{"id": 1, "kind": "tree",
            "name": "Oak", "params": {"bark.family": "plain", "foliage.leaf": "maple"},
            "tracks": {"foliage.season": {"keys": [{"time": 0, "value": 0, "mode": "LINEAR"},
                                              {"time": 2, "value": 1}]}}}]})");
        const auto names = [&](const QStringList& more) {
            const test::CliRun run = runCli(
                QStringList{"textures", project, "-o", path("keyed"), "--size", "16", "--json"} + more);
            if (run.code != 0)
                qWarning("%s", qPrintable(run.err));
            return run.json().value("files").toArray();
        };
        const QJsonArray first = names({}), middle = names({"--time", "1"});
        QCOMPARE(first.size(), 3);
        QVERIFY(middle != first && middle[0].toString().contains("_season50_"));
        QCOMPARE(middle[1], first[1]); // relief is that of summer
        const auto red = [&](const QJsonArray& files) {
            return QImage(path("keyed/") + files[0].toString())
                .scaled(1, 1, {}, Qt::SmoothTransformation)
                .pixelColor(0, 0)
                .red();
        };
        QVERIFY(red(middle) > red(first) + 40);
        QCOMPARE(names({"--time", "0"}), first);
        QCOMPARE(names({"--time", "9"}), names({"--time", "2"}));
    }
    void renderNeedsADisplayAndFindsOne()
    {
        QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
        bare.remove("DISPLAY");
        bare.remove("WAYLAND_DISPLAY");
        QProcessEnvironment without = bare;
        without.insert("PATH", m_folder.path());
        QVERIFY(isRefused(runCli({"render", "preset:TinyTree", "-o", path("x.png")}, without), "Xvfb"));
        QVERIFY(
            isRefused(runCli({"render", "preset:TinyTree", "--turntable", "3", "-o", path("x.mp4")}, without),
                      "ffmpeg"));
        QVERIFY(!QFile::exists(path("x.png")));
        if (QStandardPaths::findExecutable("Xvfb").isEmpty())
            RAMURE_CANNOT_RUN("Xvfb is not installed");
        QByteArray before;
        for (const char* mode : {"skeleton", "simplified", "rough", "sections", "mesh"}) {
            const test::CliRun run = runCli({"render", "preset:TinyTree", "-o", path("x.png"), "--size",
                                             "200x150", "--mode", QLatin1String(mode)},
                                            bare);
            QVERIFY2(run.code == 0 && run.err.isEmpty(), qPrintable(run.err));
            QCOMPARE(QImage(path("x.png")).size(), QSize(200, 150));
            QVERIFY(test::bytesOf(path("x.png")) != before);
            before = test::bytesOf(path("x.png"));
        }
        test::write(path("cone.obj"),
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        QCOMPARE(runCli({"render", path("cone.obj"), "-o", path("cone.png"), "--size", "64x64"}, bare).code,
                 0);
        QVERIFY(isRefused(runCli({"render", path("cone.obj"), "-o", path("c.png"), "--mode", "rough"}, bare),
                          "needs a tree"));
        QVERIFY(
            isRefused(runCli({"render", "preset:TinyTree", "-o", path("none/x.png")}, bare), "none/x.png"));
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path("full.png")));
        QVERIFY(
            isRefused(runCli({"render", "preset:TinyTree", "-o", path("full.png"), "--size", "64x64"}, bare),
                      "No space left on device", 5));
    }
    /// What a desktop or a login shell has left in the environment does not matter to pictures.
    void renderDoesNotDependOnTheDesktop_data()
    {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("display");
        for (const char* platform : {"wayland", "eglfs", "nonsense", "xcb", "minimal"})
            QTest::newRow(platform) << QString(platform) << QString();
        for (const char* display : {":4711", "nonsense", "127.0.0.1:4711", "no.such.machine.invalid:0"})
            QTest::newRow(display) << QString() << QString(display);
        QTest::newRow("both") << QStringLiteral("wayland") << QStringLiteral(":4711");
    }
    void renderDoesNotDependOnTheDesktop()
    {
        QFETCH(QString, platform);
        QFETCH(QString, display);
        QProcessEnvironment odd = QProcessEnvironment::systemEnvironment();
        odd.remove("DISPLAY");
        odd.insert("QT_QPA_PLATFORM", platform);
        if (!display.isEmpty())
            odd.insert("DISPLAY", display);
        QProcessEnvironment without = odd;
        without.insert("PATH", m_folder.path());
        QVERIFY(isRefused(runCli({"render", "preset:TinyTree", "-o", path("odd.png")}, without),
                          display.isEmpty() ? QString("there is no display, and Xvfb")
                                            : "that answers at DISPLAY=" + display + ", and Xvfb"));
        if (QStandardPaths::findExecutable("Xvfb").isEmpty())
            RAMURE_CANNOT_RUN("Xvfb is not installed");
        const auto run = runCli({"render", "preset:TinyTree", "-o", path("odd.png"), "--size", "64x64"}, odd);
        QVERIFY2(run.code == 0 && run.err.isEmpty(), qPrintable(run.err));
        QCOMPARE(QImage(path("odd.png")).size(), QSize(64, 64));
        QVERIFY(QFile::remove(path("odd.png")));
    }
    void camerasOfTheSceneTakePictures()
    {
        const QString file = path("film.ramure");
        test::write(file, R"({"format": "ramure", "version": 1, "nodes": [
            {"id": 1, "kind": "primitive", "name": "Box", "params": {"primitive.shape": "box"}},
            {"id": 2, "kind": "camera", "name": "Front", "params": {"tree.translation": [0, 1, 5],
             "camera.angle": 0.5235987755982988}},
            {"id": 3, "kind": "camera", "name": "Near", "params": {"tree.translation": [0, 1, 3],
             "camera.angle": 0.6981317007977318, "camera.fStop": 0.1, "camera.focus": 9}}]})");
        const auto drawn = [&](const QStringList& more) {
            const test::CliRun run = runCli(
                QStringList{"render", file, "-o", path("seen.png"), "--size", "96x64", "--quality", "draft"} +
                more);
            if (run.code != 0)
                qWarning("%s", qPrintable(run.err));
            return QImage(path("seen.png"));
        };
        const QImage front = drawn({"--camera", "Front"});
        QCOMPARE(front, drawn({"--camera", "0,1,5,0,1,0,30"}));
        QCOMPARE(front, drawn({"--camera", "Front", "--node", "Box"}));
        const QImage near = drawn({"--camera", "Near"});
        QCOMPARE(near, drawn({"--camera", "0,1,3,0,1,-6,40", "--f-stop", "0.1"}));
        QVERIFY(near != drawn({"--camera", "0,1,3,0,1,-6,40"}));
        const auto why = runCli({"render", file, "-o", path("no.png"), "--camera", "Back"});
        QVERIFY(isRefused(why, "no camera has this name"));
        QVERIFY(why.err.contains("Front") && why.err.contains("Near"));
    }
    void renderRefusesBadLightAndCameras()
    {
        const auto refused = [&](const char* option, const char* value, const char* why) {
            return isRefused(runCli({"render", "preset:TinyTree", "-o", path("no.png"), option, value}), why);
        };
        QVERIFY(refused("--camera", "Front", "there is no camera"));
        for (const char* camera :
             {"", "1,2,3", "1,2,3,4,5,6,7,8", "1,2,3,4,5,x", "1,2,3,4,5,nan", "1,2,3,4,5,1e9"})
            QVERIFY(refused("--camera", camera, "EX,EY,EZ,TX,TY,TZ[,ANGLE]"));
        QVERIFY(refused("--camera", "1,2,3,1,2,3", "millimetre"));
        QVERIFY(refused("--camera", "0,2,3,0,0,0,180", "1 to 150"));
        for (const char* sun : {"", "90", "90,10,1", "east,10"})
            QVERIFY(refused("--sun", sun, "DIRECTION,HEIGHT"));
        for (const char* sun : {"90,1", "90,91"})
            QVERIFY(refused("--sun", sun, "2 to 90 degrees"));
        QVERIFY(refused("--background", "white", "landscape, sky, light, dark or none"));
        for (const char* moment : {"", "2026-06-21T12:00,48.9", "noon,48.9,2.3", "2026-06-21T12:00,91,0",
                                   "2026-02-30T12:00,48.9,2.3", "2026-06-21T12:00,48.9,nan"})
            QVERIFY(refused("--sun-at", moment, "TIME,LATITUDE,LONGITUDE"));
        QVERIFY(refused("--sun-at", "2026-06-21T00:00,48.9,2.3", "degrees high then"));
        QVERIFY(refused("--haze", "1.9", "from 2 to 8"));
        QVERIFY(refused("--exposure", "nan", "from -5 to 5"));
        QVERIFY(refused("--white-balance", "2000", "from 3000 to 12000"));
        QVERIFY(refused("--f-stop", "0", "from 0.1 to 64"));
        QVERIFY(refused("--focus", "3", "needs --f-stop"));
        QVERIFY(refused("--sky-picture", "sky.png", ".hdr"));
        QVERIFY(refused("--background-turn", "10", "needs --background-picture"));
        QVERIFY(refused("--background-picture", "missing.hdr", "missing.hdr"));
        QVERIFY(isRefused(runCli({"render", "preset:TinyTree", "-o", path("no.png"), "--sky-sun"}), "needs"));
        for (const QStringList& other : {QStringList{"--sun", "90,10"}, QStringList{"--background", "sky"}})
            QVERIFY(isRefused(runCli(QStringList{"render", "preset:TinyTree", "-o", path("no.png"),
                                                 "--background-picture", "missing.hdr"} +
                                     other),
                              "goes without"));
        QVERIFY(isRefused(runCli({"render", "preset:TinyTree", "-o", path("no.png"), "--turntable", "4",
                                  "--camera", "0,1,5,0,1,0"}),
                          "neither"));
        QVERIFY(!QFile::exists(path("no.png")));
    }
    void renderTakesCameraSunAndBackground()
    {
        const auto drawn = [&](const QStringList& options) {
            const test::CliRun run =
                runCli(QStringList{"render", "preset:TinyTree", "-o", path("look.png"), "--size", "160x120"} +
                       options);
            if (run.code != 0)
                qFatal("%s", qPrintable(run.err));
            return QImage(path("look.png"));
        };
        const QImage none = drawn({"--background", "none"}), light = drawn({"--background", "light"}),
                     dark = drawn({"--background", "dark"});
        QCOMPARE(none.pixelColor(1, 1).alpha(), 0);
        QVERIFY(light.pixelColor(1, 1).lightness() > 200);
        QVERIFY(dark.pixelColor(1, 1).lightness() < 60);
        QVERIFY(drawn({"--sun", "270,10"}) != drawn({}));
        QVERIFY(drawn({"--sun", "136,46"}) == drawn({})); // as it is without it
        QVERIFY(drawn({"--background", "sky", "--sun-at", "2026-06-21T14:00+02:00,48.9,2.3"}) ==
                drawn({"--background", "sky", "--sun-at", "2026-06-21T12:00,48.9,2.3"}));
        QVERIFY(drawn({"--background", "sky", "--haze", "6"}) != drawn({"--background", "sky"}));
        QVERIFY(drawn({"--exposure", "1"}) != drawn({}));
        QVERIFY(drawn({"--white-balance", "6500"}) == drawn({}));
        const QColor warm = drawn({"--white-balance", "9000"}).pixelColor(1, 110),
                     cold = drawn({"--white-balance", "4000"}).pixelColor(1, 110);
        QVERIFY(warm.red() > cold.red() + 10 && warm.blue() < cold.blue() - 10);
        QVERIFY(drawn({"--f-stop", "0.5", "--focus", "1", "--sky-picture", path("sky.hdr")}) != drawn({}));
        QVERIFY(test::bytesOf(path("sky.hdr")).startsWith("#?RADIANCE"));
        // The sky as a picture of its own is nearly that sky: what stands in the ground's colour is the same.
        const QImage natural =
            drawn({"--background", "sky", "--sun", "250,20", "--sky-picture", path("sky.hdr"), "--sky-sun"});
        const QImage own = drawn({"--background-picture", path("sky.hdr")});
        const QImage turned = drawn({"--background-picture", path("sky.hdr"), "--background-turn", "180"});
        const auto apart = [](const QImage& a, const QImage& b) {
            double sum = 0.0;
            for (int y = a.height() / 2; y < a.height(); ++y)
                for (int x = 0; x < a.width(); ++x)
                    sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
            return 2.0 * sum / (a.width() * a.height());
        };
        QVERIFY2(apart(natural, own) < 4.0, qPrintable(QString::number(apart(natural, own))));
        QVERIFY(apart(natural, turned) > 2.0 * apart(natural, own));
        // From straight above, the trunk stands in the middle; from behind, everything is out of sight.
        const QImage above = drawn({"--background", "none", "--camera", "0,20,0,0,0,0,20"});
        QVERIFY(above.pixelColor(80, 60).alpha() > 0);
        const QImage away = drawn({"--background", "none", "--camera", "0,1,9,0,1,20"});
        QCOMPARE(away.pixelColor(80, 60).alpha(), 0);
    }
    /// It blocked the signal that ends it: every picture took five seconds more, and a killed program left it
    /// behind.
    void displayEndsWithTheProgram()
    {
        if (QStandardPaths::findExecutable("Xvfb").isEmpty())
            RAMURE_CANNOT_RUN("Xvfb is not installed");
        QProcess process;
        QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
        bare.remove("DISPLAY");
        bare.remove("WAYLAND_DISPLAY");
        process.setProcessEnvironment(bare);
        process.start(QStringLiteral(RAMURE_CLI), {"render", "preset:TinyTree", "-o", path("turn.png"),
                                                   "--size", "16x16", "--turntable", "10000"});
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(m_folder.path()).entryList({"turn*.png"}).isEmpty(),
                                 test::patience(60'000));
        const QByteArray server =
            test::bytesOf(QStringLiteral("/proc/%1/task/%1/children").arg(process.processId())).trimmed();
        const QString command = QStringLiteral("/proc/%1/cmdline").arg(QString::fromLatin1(server));
        QVERIFY(test::bytesOf(command).contains("Xvfb"));
        process.kill();
        QVERIFY(process.waitForFinished());
        QTRY_VERIFY_WITH_TIMEOUT(test::bytesOf(command).isEmpty(), test::patience(30'000));
    }
    /// Not only between two of them: one with so many samples takes minutes here.
    void stopsWithinAPicture()
    {
        QProcess process;
        process.start(QStringLiteral(RAMURE_CLI), {"render", "preset:SmallTree", "-o", path("stopped.png"),
                                                   "--size", "4000x3000", "--samples", "256"});
        const auto isDrawing = [&process] { // the driver's threads
            const auto children = QDir(QStringLiteral("/proc/%1/task").arg(process.processId()));
            for (const QString& task : children.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
                if (test::bytesOf(children.filePath(task + QStringLiteral("/comm"))).startsWith("llvmpipe"))
                    return true;
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isDrawing(), test::patience(60'000));
        QCOMPARE(::kill(pid_t(process.processId()), SIGINT), 0);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 2);
        QVERIFY(process.readAllStandardError().endsWith("ancelled\n"));
        QVERIFY(!QFile::exists(path("stopped.png")));
    }
};

RAMURE_SUITE(TestRamureCliPictures)

} // namespace tst_ramure_cli_pictures

#include "tst_ramure_cli_pictures.moc"
