#include "core/io/mesh_file.h"
#include "tests/cli/cli_support.h"
#include <QDir>
#include <QJsonArray>
#include <csignal>
#include <unistd.h>

namespace tst_ramure_cli_files {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// Export and validate: what goes in and out as files.
class TestRamureCliFiles : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QStringList m_small = {"--set", "grammar.iterations=3",         "--set", "foliage.leavesCutoff=10",
                           "--set", "foliage.applesProbability=0.5"};

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    static ReadMesh read(const QString& file)
    {
        auto mesh = readMeshFile(file.toStdString());
        if (!mesh)
            qFatal("%s", test::why(mesh).constData());
        return *mesh;
    }
    static QStringList names(const ReadMesh& mesh)
    {
        QStringList out;
        for (const ReadObject& object : mesh.objects)
            out << QString::fromStdString(object.name);
        return out;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void unwritableFiles()
    {
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("none/x.obj")}),
                          "No such file or directory"));
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path("full.obj")));
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("full.obj")}),
                          "No space left on device", 5));
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path("full.ply")));
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("full.ply")}),
                          "No space left on device", 5));
        if (::geteuid() == 0) {
            QVERIFY(
                isRefused(runCli({"export", "preset:TinyTree", "-o", "/sys/ramure.ply"}), "/sys/ramure.ply"));
            return;
        }
        test::write(path("old.ply"), "old");
        QVERIFY(QFile::setPermissions(path("old.ply"), QFile::ReadOwner));
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("old.ply")}), "Permission denied"));
        QCOMPARE(test::bytesOf(path("old.ply")), QByteArray("old"));
    }
    /// A file that may not grow (ulimit -f, in KiB) ended the program and left half a file beside the old
    /// one.
    void limitOfFilesIsAnErrorThatKeepsTheOldOne_data()
    {
        QTest::addColumn<QString>("kibibytes");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("command"); // the file's path follows
        QTest::newRow("OBJ") << "20"
                             << "limit.obj"
                             << QStringList{"export", "preset:SmallTree", "--map-size", "0", "-o"};
        QTest::newRow("PLY") << "20"
                             << "limit.ply" << QStringList{"export", "preset:SmallTree", "-o"};
        QTest::newRow("figures") << "20"
                                 << "limit.csv"
                                 << QStringList{"simulate", "preset:TinyTree", "--steps", "1000", "--csv"};
        QTest::newRow("project") << "0"
                                 << "limit.ramure" << QStringList{"import", "cone.obj", "-o"};
    }
    void limitOfFilesIsAnErrorThatKeepsTheOldOne()
    {
        QFETCH(QString, kibibytes);
        QFETCH(QString, name);
        QFETCH(QStringList, command);
        QTemporaryDir folder;
        const QString file = folder.filePath(name), cone = folder.filePath("cone.obj");
        test::write(file, "old");
        test::write(cone, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        command.replaceInStrings("cone.obj", cone);
        const auto run = test::runProgram(
            "bash", QStringList{"-c", "ulimit -f " + kibibytes + "; exec \"$@\"", "bash", RAMURE_CLI} +
                        command + QStringList{file});
        QVERIFY(isRefused(run, file + ": cannot be written: File too large"));
        QCOMPARE(test::bytesOf(file), QByteArray("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
    }
    static QJsonObject reportAt(const QString& file)
    {
        return QJsonDocument::fromJson(test::bytesOf(file)).object();
    }
    void exportRefusesMuchBeforeItWrites()
    {
        // The second file's ending is wrong: the first is not written either.
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("a.obj"), "-o", path("b.dae")}),
                          ".dae"));
        QVERIFY(!QFile::exists(path("a.obj")));
        QVERIFY(
            isRefused(runCli({"export", "preset:TinyTree", "-o", path("a.obj"), "--set", "tree.scale=0,1,1"}),
                      "tree.scale"));
        QVERIFY(!QFile::exists(path("a.obj")));
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", path("a.ply"), "--part", "fruit",
                                  "--set", "foliage.applesProbability=0"}),
                          "nothing to export"));
    }
    void leavesAsAListOfInstances()
    {
        const auto exported = [&](const QStringList& options) {
            return runCli(QStringList{"export", "preset:TinyTree", "--map-size", "0"} + options);
        };
        QVERIFY(isRefused(exported({"-o", path("i.obj"), "--leaves", "none"}),
                          "--leaves \"none\": merged, instances expected"));
        QVERIFY(isRefused(exported({"-o", path("i.obj"), "--leaves", "instances", "--model", "skeleton"}),
                          "exclude each other"));
        QVERIFY(isRefused(exported({"-o", path("none/i.obj"), "--leaves", "instances"}),
                          "i_leaves.csv: cannot be written: No such file or directory"));
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path("i_leaves.csv")));
        QVERIFY(isRefused(exported({"-o", path("i.obj"), "--leaves", "instances"}), "No space left on device",
                          5));
        QVERIFY(QFile::remove(path("i_leaves.csv")) && !QFile::exists(path("i.obj")));
        QCOMPARE(exported({"-o", path("i.obj"), "-o", path("i.ply"), "--leaves", "instances"}).code, 0);
        QCOMPARE(names(read(path("i.obj"))), QStringList{"branches"});
        QVERIFY(test::bytesOf(path("i_leaves.csv")).startsWith("node,object,kind,mesh,material,branch,"));
        QCOMPARE(names(read(path("i_leaves_oak.obj"))), QStringList{"leaves_oak"});
        QCOMPARE(names(read(path("i_fruit_acorn.obj"))), QStringList{"fruit_acorn"});
    }
    void compressedGlb()
    {
        const auto exported = [&](const char* file, const QString& how) {
            return runCli(
                {"export", "preset:TinyTree", "--map-size", "0", "-o", path(file), "--compress", how});
        };
        QVERIFY(isRefused(exported("c.glb", "zip"), "--compress \"zip\": meshopt or none expected"));
        QVERIFY(isRefused(exported("c.obj", "meshopt"), "--compress meshopt is for .glb files"));
        QVERIFY(!QFile::exists(path("c.obj")));
        QCOMPARE(exported("plain.glb", "none").code, 0);
        QCOMPARE(exported("c.glb", "meshopt").code, 0);
        QVERIFY(QFileInfo(path("c.glb")).size() * 3 < QFileInfo(path("plain.glb")).size());
    }
    void levelsOfDetail()
    {
        const auto exported = [&](const QStringList& options) {
            return runCli(QStringList{"export", "preset:TinyTree", "--map-size", "0", "-o", path("l.obj")} +
                          options);
        };
        QVERIFY(isRefused(exported({"--levels", "0"}), "1 to 8"));
        QVERIFY(isRefused(exported({"--levels", "two"}), "--levels \"two\""));
        QVERIFY(isRefused(exported({"--budget", "4000,x"}), "--budget \"4000,x\""));
        QVERIFY(isRefused(exported({"--budget", "1000,2000"}), "must fall"));
        QVERIFY(isRefused(exported({"--budget", "1000,0"}), "budget of 0"));
        QVERIFY(isRefused(exported({"--levels", "3", "--budget", "1000,500"}), "as many budgets"));
        QVERIFY(isRefused(exported({"--levels", "2", "--model", "rough"}), "finished mesh"));
        QVERIFY(!QFile::exists(path("l_LOD0.obj")));
        const test::CliRun run = exported({"--budget", "4000,1000", "--report", path("l.json")});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QVERIFY(!QFile::exists(path("l.obj")));
        QCOMPARE(names(read(path("l_LOD0.obj"))),
                 (QStringList{"branches_LOD0", "leaves_LOD0", "fruit_LOD0"}));
        QCOMPARE(names(read(path("l_LOD1.obj"))),
                 (QStringList{"branches_LOD1", "leaves_LOD1", "fruit_LOD1"}));
        QVERIFY(test::bytesOf(path("l.json")).contains("l_LOD1.obj"));
    }
    void exportWritesWhatIsAskedFor()
    {
        const auto exported = [&](const QStringList& options, const char* file) {
            const test::CliRun run =
                runCli(QStringList{"export", "preset:SmallTree", "-o", path(file)} + m_small + options);
            if (run.code != 0 || !run.out.isEmpty() || !run.err.isEmpty())
                qFatal("%s", qPrintable(run.err));
            return read(path(file));
        };
        QCOMPARE(names(exported({}, "all.obj")), (QStringList{"branches", "leaves", "fruit"}));
        QVERIFY(QFile::exists(path("all.mtl")));
        QCOMPARE(names(exported({"--part", "leaves"}, "leaves.obj")), QStringList{"leaves"});
        const ReadMesh branches = exported({}, "branches.ply");
        const TriangleMesh& mesh = branches.objects[0].mesh;
        QCOMPARE(mesh.vertexCount(), read(path("all.obj")).objects[0].mesh.vertexCount());
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        QCOMPARE(mesh.branch.size(), mesh.positions.size());
        QCOMPARE(mesh.level.size(), mesh.positions.size());
        const TriangleMesh ascii = exported({"--ascii"}, "ascii.ply").objects[0].mesh;
        QVERIFY(test::bytesOf(path("ascii.ply")).startsWith("ply\nformat ascii"));
        QVERIFY(ascii == mesh);
        QVERIFY(exported({"--part", "all"}, "joined.ply").objects[0].mesh.vertexCount() > mesh.vertexCount());
        QCOMPARE(names(exported({"--model", "rough"}, "rough.obj")),
                 (QStringList{"branches", "leaves", "fruit"}));
        QCOMPARE(runCli(QStringList{"export", "preset:SmallTree", "--model", "skeleton", "-o",
                                    path("skeleton.obj"), "-o", path("skeleton.ply")} +
                        m_small)
                     .code,
                 0);
        const QByteArray skeleton = test::bytesOf(path("skeleton.obj"));
        QCOMPARE(skeleton.count("\nv "), 56); // 55 branches after simplification
        QCOMPARE(skeleton.count("\nl "), 55);
        QVERIFY(test::bytesOf(path("skeleton.ply")).contains("element vertex 56\n"));
        // Several files in one go are the same as one by one.
        QCOMPARE(runCli(QStringList{"export", "preset:SmallTree", "-o", path("1.obj"), "-o", path("2.ply")} +
                        m_small)
                     .code,
                 0);
        QCOMPARE(test::bytesOf(path("2.ply")), test::bytesOf(path("branches.ply")));
        QCOMPARE(test::bytesOf(path("1.obj")).replace("1.mtl", "all.mtl"), test::bytesOf(path("all.obj")));
    }
    void exportPlacesTheTree()
    {
        const QStringList base = {"export", "preset:TinyTree", "--part", "branches", "-o"};
        QCOMPARE(runCli(base + QStringList{path("plain.ply")}).code, 0);
        QCOMPARE(runCli(base + QStringList{path("moved.ply"), "--set", "tree.translation=1,2,3", "--set",
                                           "tree.scale=2,2,2"})
                     .code,
                 0);
        const TriangleMesh plain = read(path("plain.ply")).objects[0].mesh;
        const TriangleMesh moved = read(path("moved.ply")).objects[0].mesh;
        QCOMPARE(moved.vertexCount(), plain.vertexCount());
        for (std::size_t i = 0; i < plain.positions.size(); ++i) {
            const glm::vec3 expected = plain.positions[i] * 2.0f + glm::vec3(1, 2, 3);
            QVERIFY(glm::length(moved.positions[i] - expected) < 1e-5f);
            QVERIFY(glm::length(moved.normals[i] - plain.normals[i]) < 1e-4f);
        }
        const test::CliRun run = runCli({"validate", path("moved.ply"), "--json"});
        QCOMPARE(run.code, 0);
        QVERIFY(run.json()["volume"].toDouble() > 0.0);
    }
    void exportTurnsAndScales()
    {
        const QStringList base = {"export", "preset:TinyTree", "--part", "branches", "-o"};
        QCOMPARE(runCli(base + QStringList{path("own.obj")}).code, 0);
        QCOMPARE(runCli(base + QStringList{path("bare.obj"), "--no-texture"}).code, 0);
        QVERIFY(test::bytesOf(path("own.obj")).contains("\nvt "));
        QVERIFY(!test::bytesOf(path("bare.obj")).contains("\nvt "));
        const QStringList space = {"--up", "z", "--unit", "in", "--scale", "0.5"};
        QCOMPARE(runCli(base + QStringList{path("turned.obj")} + space).code, 0);
        QVERIFY(test::bytesOf(path("turned.obj")).left(200).contains("# up z, unit in, scale 0.5\n"));
        // The trunk points up along Z: 1 m is 19.7 half inches.
        const auto heights = [&](const char* file) {
            QList<float> found;
            for (const QByteArray& line : test::bytesOf(path(file)).split('\n'))
                if (line.startsWith("v "))
                    found += line.split(' ').at(file[0] == 't' ? 3 : 2).toFloat();
            return found;
        };
        const QList<float> own = heights("own.obj"), turned = heights("turned.obj");
        QCOMPARE(turned.size(), own.size());
        for (int i = 0; i < own.size(); ++i)
            QVERIFY(std::abs(turned[i] - own[i] * 0.5F / 0.0254F) < 1e-3F);
        // Read again it stands as it did, and so does what is made of it.
        QCOMPARE(runCli({"export", path("turned.obj"), "-o", path("back.ply")}).code, 0);
        QVERIFY(!test::bytesOf(path("back.ply")).left(300).contains("unit"));
        const TriangleMesh back = read(path("back.ply")).joined(), meant = read(path("own.obj")).joined();
        QCOMPARE(back.triangles, meant.triangles);
        QVERIFY(glm::length(back.positions.back() - meant.positions.back()) < 1e-5F);
        QCOMPARE(runCli({"export", path("own.obj"), "-o", path("mm.ply"), "--unit", "mm"}).code, 0);
        QVERIFY(test::bytesOf(path("mm.ply")).left(300).contains("comment up y, unit mm, scale 1\n"));
        QCOMPARE(runCli({"import", path("mm.ply"), "-o", path("mm.ramure")}).code, 0);
        QVERIFY(isRefused(runCli({"import", path("mm.ply"), "-o", path("mm.ramure"), "--up", "w"}), "--up"));
    }
    void exportOfSeveralTreesAndOfMeshes()
    {
        test::write(path("two.ramure"), R"({"format": "ramure", "version": 1, "nodes": [
            {"id": 2, "kind": "tree", "name": "Oak", "params": {"grammar.iterations": 2}},
            {"id": 4, "kind": "tree", "name": "Ghost", "visible": false},
            {"id": 3, "kind": "tree", "name": "Elm", "params": {"grammar.iterations": 1, "tree.translation": [9, 0, 0]}}]})");
        QCOMPARE(runCli({"export", path("two.ramure"), "-o", path("two.obj"), "--part", "branches"}).code, 0);
        QCOMPARE(names(read(path("two.obj"))), (QStringList{"branches_1", "branches_2"}));
        // From one mesh format to the other and back.
        QCOMPARE(runCli({"export", path("two.obj"), "-o", path("again.ply")}).code, 0);
        QCOMPARE(runCli({"validate", path("again.ply"), "--json"}).json()["components"].toInt(), 2);
        QVERIFY(isRefused(runCli({"export", path("two.obj"), "-o", path("x.ply"), "--part", "leaves"}),
                          "need a tree"));
        QVERIFY(
            isRefused(runCli({"info", path("two.obj"), "--set", "turtle.alpha=1"}), "--set needs a tree"));
    }
    void interruptedExportLeavesNothing()
    {
        QTemporaryDir folder;
        QProcess process;
        process.start(QStringLiteral(RAMURE_CLI), {"export", "preset:SmallTree", "--set",
                                                   "grammar.iterations=14", "-o", folder.filePath("x.obj")});
        QVERIFY(process.waitForStarted());
        // SIGINT blocked and SIGHUP not: glibc blocks every signal for a moment while it starts a thread.
        const auto waitsForInterrupts = [&process] {
            const QString status = QStringLiteral("/proc/%1/status").arg(process.processId());
            for (const QByteArray& line : test::bytesOf(status).split('\n'))
                if (line.startsWith("SigBlk:")) {
                    const qulonglong blocked = line.mid(7).trimmed().toULongLong(nullptr, 16);
                    return (blocked >> (SIGINT - 1) & 1) != 0 && (blocked >> (SIGHUP - 1) & 1) == 0;
                }
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(waitsForInterrupts(), test::patience(60'000));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 2);
        QVERIFY(process.readAllStandardError().endsWith("ancelled\n"));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void infoOfMeshFiles()
    {
        test::write(path("two.obj"), "o a\nv 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\no b\nv 5 0 0\nTRANSFORM 1\n");
        const QJsonObject info = runCli({"info", path("two.obj"), "--json"}).json();
        QCOMPARE(info["vertices"].toInt(), 4);
        QCOMPARE(info["faces"].toInt(), 1);
        QCOMPARE(info["max"].toArray(), (QJsonArray{5, 2, 0}));
        QCOMPARE(info["objects"][1]["name"].toString(), QString("b"));
        QCOMPARE(info["notes"][0].toString(), QString("line 8: TRANSFORM skipped"));
        QVERIFY(runCli({"info", path("two.obj")}).out.contains("4"));
    }
    void validateSaysWhatIsWrong()
    {
        const QStringList keys = {"boundaryEdges",
                                  "components",
                                  "degenerateFaces",
                                  "duplicateFaces",
                                  "duplicateVertices",
                                  "eulerCharacteristic",
                                  "faces",
                                  "hash",
                                  "inconsistentEdges",
                                  "isolatedVertices",
                                  "nearVertices",
                                  "nonManifoldEdges",
                                  "nonManifoldVertices",
                                  "quality",
                                  "valid",
                                  "verdict",
                                  "vertices",
                                  "volume"};
        for (const char* preset : {"SmallTree", "FanTree", "TinyTree", "Fern2D"}) {
            const test::CliRun run = runCli({"validate", QStringLiteral("preset:") + preset, "--json"});
            QCOMPARE(run.code, 0);
            QVERIFY(run.err.isEmpty());
            QCOMPARE(run.keys(), keys);
            const QJsonObject report = run.json();
            QCOMPARE(report["valid"].toBool(), true);
            QCOMPARE(report["verdict"].toString(), QStringLiteral("closed")); // nobody looked for crossings
            QCOMPARE(report["components"].toInt(), 1);
            QCOMPARE(report["eulerCharacteristic"].toInt(), 2);
            QVERIFY(report["volume"].toDouble() > 0.0);
        }
        test::write(path("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const test::CliRun open = runCli({"validate", path("open.obj"), "--json"});
        QCOMPARE(open.code, 1);
        QVERIFY(open.err.isEmpty());
        QCOMPARE(open.keys(), keys);
        QCOMPARE(open.json()["boundaryEdges"].toInt(), 3);
        QCOMPARE(open.json()["valid"].toBool(), false);
        QCOMPARE(open.json()["verdict"].toString(), QStringLiteral("broken"));
        QCOMPARE(runCli({"validate", path("open.obj")}).code, 1);
        test::write(path("bad.obj"), "v 0 0 0\nf 1 2 3\n");
        QVERIFY(isRefused(runCli({"validate", path("bad.obj")}), "bad.obj:2: vertex"));
        test::write(path("bad.ply"),
                    "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n");
        QVERIFY(isRefused(runCli({"validate", path("bad.ply")}), "bad.ply:3: the file is too short"));
    }
    void validateFindsEveryKindOfDefect()
    {
        const QDir folder(QStringLiteral(RAMURE_TEST_DATA "/defects"));
        const QStringList files = folder.entryList(QDir::Files);
        QCOMPARE(files.size(), 9);
        for (const QString& file : files) {
            const test::CliRun run = runCli({"validate", folder.filePath(file), "--json"});
            const bool isClean = file == "clean.obj";
            QCOMPARE(run.code, isClean ? 0 : 1);
            // duplicate_face.ply: duplicateFaces
            QString key = file.section('.', 0, 0);
            for (auto at = key.indexOf('_'); at >= 0; at = key.indexOf('_'))
                key.replace(at, 2, key[at + 1].toUpper());
            key.replace("Vertex", "Vertice").append('s');
            if (!isClean)
                QVERIFY2(run.json()[key].toInt() > 0, qPrintable(key));
        }
    }
    void validateCountsSelfIntersectionsWhereAsked()
    {
        const test::CliRun tree = runCli({"validate", "preset:TinyTree", "--self-intersections", "--json"});
        QCOMPARE(tree.code, 0); // collisions are a property of the tree
        const QJsonObject found = tree.json()["selfIntersections"].toObject();
        QCOMPARE(found.keys(),
                 (QStringList{"collisions", "far", "parentChild", "same", "siblings", "total"}));
        QVERIFY(found["far"].toInt() > 0);
        QCOMPARE(found["total"].toInt(), found["far"].toInt());
        int triangles = 0;
        for (const QJsonValue& value : found["collisions"].toArray()) {
            const QJsonObject collision = value.toObject();
            QCOMPARE(collision.keys(), (QStringList{"branches", "depth", "place", "triangles"}));
            QCOMPARE(collision["place"].toArray().size(), 3);
            triangles += collision["triangles"].toInt();
        }
        QCOMPARE(triangles, found["far"].toInt());
        const QJsonObject quality = tree.json()["quality"].toObject();
        QCOMPARE(quality.keys(),
                 (QStringList{"angleHistogram", "aspectBins", "aspectHistogram", "largestAspect",
                              "largestAspectFace", "smallestAngle", "smallestAngleFace", "withoutArea"}));
        QVERIFY(quality["smallestAngle"].toDouble() > 0.0 && quality["smallestAngle"].toDouble() < 1.05);
        // A file knows no branches, and has the same hash as the tree it came from.
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("hash.ply")}).code, 0);
        const QJsonObject file =
            runCli({"validate", path("hash.ply"), "--self-intersections", "--json"}).json();
        QCOMPARE(file["selfIntersections"].toObject().keys(), QStringList{"total"});
        QCOMPARE(file["selfIntersections"]["total"], found["total"]);
        QCOMPARE(file["hash"], tree.json()["hash"]);
        QCOMPARE(file["hash"].toString().size(), 32);
        const QString text = runCli({"validate", "preset:TinyTree", "--self-intersections"}).out;
        for (const char* word : {"hash", "smallestAngle", "largestAspect", "selfIntersections", "m deep at"})
            QVERIFY2(text.contains(QLatin1String(word)), word);
    }
    void collisionsAreMovedApart()
    {
        const test::CliRun run =
            runCli({"validate", "preset:TinyTree", "--self-intersections", "--separate", "--json"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.json()["selfIntersections"].toObject()["total"].toInt(), 0);
        QVERIFY(run.err.contains("1 of 1 colliding pairs moved apart"));
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("apart.ply"), "--separate"}).code, 0);
        const QJsonObject file =
            runCli({"validate", path("apart.ply"), "--self-intersections", "--json"}).json();
        QCOMPARE(file["hash"], run.json()["hash"]);
        QCOMPARE(file["selfIntersections"].toObject()["total"].toInt(), 0);
        QVERIFY(isRefused(runCli({"export", path("apart.ply"), "-o", path("x.obj"), "--separate"}),
                          "needs a tree"));
    }
    /// Closed, with a box that runs through another: amber for all commands, red for none.
    void crossingsChangeTheVerdictNotTheExitCode()
    {
        const auto box = [](double from, int first) {
            constexpr int corners[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                            {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
            QByteArray text;
            for (int i = 0; i < 8; ++i)
                text += "v " + QByteArray::number(from + (i & 1)) + ' ' +
                        QByteArray::number(from + (i >> 1 & 1)) + ' ' + QByteArray::number(from + (i >> 2)) +
                        '\n';
            for (const auto& face : corners)
                text += "f " + QByteArray::number(face[0] + first) + ' ' +
                        QByteArray::number(face[1] + first) + ' ' + QByteArray::number(face[2] + first) +
                        '\n';
            return text;
        };
        test::write(path("one.obj"), box(0.0, 1));
        test::write(path("two.obj"), box(0.0, 1) + box(0.4, 9));
        const auto verdict = [this](const char* file, const QStringList& more) {
            return runCli(QStringList{more.front(), path(file), "--json"} + more.mid(1))
                .json()["verdict"]
                .toString();
        };
        QCOMPARE(verdict("one.obj", {"validate"}), QStringLiteral("closed"));
        QCOMPARE(verdict("one.obj", {"validate", "--self-intersections"}), QStringLiteral("clean"));
        QCOMPARE(verdict("two.obj", {"validate", "--self-intersections"}), QStringLiteral("crossing"));
        QCOMPARE(verdict("two.obj", {"info", "--verdict"}), QStringLiteral("crossing"));
        const test::CliRun told = runCli({"validate", path("two.obj"), "--self-intersections"});
        QCOMPARE(told.code, 0);
        QVERIFY(told.out.contains("closed, but"));
        QCOMPARE(runCli({"export", path("two.obj"), "-o", path("again.ply"), "--require-valid", "--report",
                         path("two.json")})
                     .code,
                 0);
        QCOMPARE(reportAt(path("two.json"))["verdict"].toString(), QStringLiteral("crossing"));
    }
    void exportInsistsOnAValidMesh()
    {
        const QString bad = QStringLiteral(RAMURE_TEST_DATA "/defects/boundary_edge.obj");
        QDir(m_folder.path()).mkdir("gate");
        const QString folder = path("gate/");
        const test::CliRun refused = runCli({"export", bad, "-o", folder + "a.obj", "-o", folder + "b.ply",
                                             "--require-valid", "--report", folder + "r.json"});
        QCOMPARE(refused.code, 1);
        QVERIFY(refused.out.isEmpty());
        QVERIFY(refused.err.contains("boundary edges") && refused.err.count('\n') == 1);
        QVERIFY(QDir(folder).isEmpty());
        QCOMPARE(runCli({"export", bad, "-o", folder + "a.obj", "--report", folder + "r.json"}).code, 0);
        QCOMPARE(reportAt(folder + "r.json")["valid"].toBool(), false);
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", folder + "t.ply", "--require-valid"}).code, 0);
        QVERIFY(QFile::exists(folder + "t.ply"));
        for (const QStringList& more :
             {QStringList{"--report", "x.txt"}, QStringList{"--require-valid", "--model", "rough"},
              QStringList{"--report", folder + "none/r.json"}})
            QVERIFY(isRefused(runCli(QStringList{"export", "preset:TinyTree", "-o", folder + "x.ply"} + more),
                              ""));
    }
    void exportChecksTheMeshWhereItStands()
    {
        // So far from the origin many vertices fall together in single precision: the file is not valid.
        const QStringList far{"export",   "preset:TinyTree", "--part",
                              "branches", "--set",           "tree.translation=1000000,1000000,1000000",
                              "-o",       path("far.obj")};
        const test::CliRun refused = runCli(far + QStringList{"--require-valid"});
        QCOMPARE(refused.code, 1);
        QVERIFY(refused.err.contains("duplicate vertices") && refused.err.contains("far from the origin"));
        QVERIFY(!QFile::exists(path("far.obj")));
        QCOMPARE(runCli(far + QStringList{"--report", path("far.json")}).code, 0);
        const QJsonObject told = reportAt(path("far.json"));
        const QJsonObject read = runCli({"validate", path("far.obj"), "--json"}).json();
        for (const char* key : {"valid", "vertices", "faces", "duplicateVertices",
                                "degenerateFaces"}) // read nearer to the origin
            QCOMPARE(told[key], read[key]);
        QCOMPARE(told["program"].toString(), told["program"].toString().trimmed());

        // A placed tree has the hash of its file, and collisions are told where they are in the file.
        const auto reported = [&](const QString& place) {
            const test::CliRun run =
                runCli({"export", "preset:TinyTree", "--set", "tree.translation=" + place, "-o",
                        path("near.ply"), "--require-valid", "--report", path("near.json")});
            return run.code == 0 ? reportAt(path("near.json")) : QJsonObject();
        };
        const auto heightOf = [](const QJsonObject& report) {
            return report["selfIntersections"]["collisions"][0]["place"][1].toDouble();
        };
        const QJsonObject home = reported("0,0,0");
        const QJsonObject lifted = reported("0,3,0");
        QCOMPARE(lifted["hash"], runCli({"validate", path("near.ply"), "--json"}).json()["hash"]);
        QVERIFY(lifted["hash"] != home["hash"]);
        QCOMPARE(heightOf(lifted), heightOf(home) + 3.0);
    }
    void exportTellsAReportThatCannotBeWrittenFirst()
    {
        const QString mesh = path("first.ply");
        QVERIFY(
            isRefused(runCli({"export", "preset:TinyTree", "-o", mesh, "--report", path("none/first.json")}),
                      "none/first.json: cannot be written: No such file or directory"));
        QVERIFY(!QFile::exists(mesh));
        // A device is written, not replaced.
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path("full.json")));
        QVERIFY(isRefused(runCli({"export", "preset:TinyTree", "-o", mesh, "--report", path("full.json")}),
                          "No space left on device", 5));
        QVERIFY(QFileInfo(QStringLiteral("/dev/full")).size() == 0);
    }
    void exportWritesAReport()
    {
        test::write(path("pair.ramure"), R"({"format": "ramure", "version": 1, "nodes": [
            {"id": 2, "kind": "tree", "name": "Oak", "params": {"grammar.iterations": 2}},
            {"id": 4, "kind": "tree", "name": "Ghost", "visible": false},
            {"id": 3, "kind": "tree", "name": "Elm", "params": {"grammar.iterations": 1}}]})");
        const auto exported = [&](const QString& report) {
            return runCli({"export", path("pair.ramure"), "-o", path("pair.obj"), "-o", path("pair.ply"),
                           "--report", report});
        };
        QCOMPARE(exported(path("pair.json")).code, 0);
        const QJsonObject report = reportAt(path("pair.json"));
        QCOMPARE(report["format"].toString(), QString("ramure-report"));
        QCOMPARE(report["version"].toInt(), 1);
        QCOMPARE(report["files"].toArray(), (QJsonArray{"pair.obj", "pair.ply"}));
        QCOMPARE(report["valid"].toBool(), true);
        QCOMPARE(report["trees"].toArray().size(), 2); // what is not shown is not exported
        for (const QJsonValue& tree : report["trees"].toArray())
            QVERIFY(tree["selfIntersections"].isObject() && tree["hash"].isString());
        QCOMPARE(exported(path("again.json")).code, 0);
        QCOMPARE(test::bytesOf(path("again.json")), test::bytesOf(path("pair.json")));
    }
    void validateSumsSeveralTrees()
    {
        test::write(path("grove.ramure"), R"({"format": "ramure", "version": 1, "nodes": [
            {"id": 2, "kind": "tree", "name": "Oak", "params": {"grammar.iterations": 2}},
            {"id": 3, "kind": "tree", "name": "Elm", "params": {"grammar.iterations": 2}}]})");
        const test::CliRun run = runCli({"validate", path("grove.ramure"), "--json"});
        QCOMPARE(run.code, 0);
        const QJsonObject all = run.json();
        QCOMPARE(all["components"].toInt(), 2);
        QCOMPARE(all["eulerCharacteristic"].toInt(), 4);
        QCOMPARE(all["trees"].toArray().size(), 2);
        QCOMPARE(all["duplicateVertices"].toInt(), 0); // the trees stand in one place, and are two meshes
        QVERIFY(runCli({"validate", path("grove.ramure")}).out.contains("2 trees"));
    }
};

RAMURE_SUITE(TestRamureCliFiles)

} // namespace tst_ramure_cli_files

#include "tst_ramure_cli_files.moc"
