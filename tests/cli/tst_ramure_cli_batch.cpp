#include "tests/cli/batch_support.h"
#include <QCryptographicHash>
#include <QImage>

namespace tst_ramure_cli_batch {

using namespace ramure;
using test::batchOf;
using test::bytesOf;
using test::filesBelow;
using test::isRefused;
using test::linesOf;
using test::runCli;

/// Tables that become trees: what is refused, what a bad row costs, and that however the work is cut, the
/// manifest is the same.
class TestRamureCliBatch : public test::FolderSuite
{
    Q_OBJECT

private slots:
    void init() { begin(); }

    void badUsage_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* options, const char* part) {
            QTest::newRow(options) << QString::fromUtf8(options).split(' ', Qt::SkipEmptyParts)
                                   << QString::fromUtf8(part);
        };
        row("", "missing -o FOLDER");
        row("-o out --levels 9", "levels");
        row("-o out --compress zip", "compress");
        row("-o out --levels 2 --budget 100,200", "budget");
        row("-o", "Missing value");
        row("-o out --shard 3", "--shard \"3\": I/N expected");
        row("-o out --shard 0/3", "--shard \"0/3\"");
        row("-o out --shard 4/3", "--shard \"4/3\"");
        row("-o out --shard 1/2/3", "--shard \"1/2/3\"");
        row("-o out --jobs 0", "--jobs \"0\": 1 to 1024 expected");
        row("-o out --jobs many", "--jobs \"many\"");
        row("-o out --memory 0", "--memory \"0\"");
        row("-o out --memory 2T", "--memory \"2T\"");
        row("-o out --progress loud", "--progress \"loud\": json, openjd, text expected");
        row("-o out --map-size 3", "--map-size \"3\"");
        row("-o out --size 3", "--size \"3\"");
        row("-o out --file {preset}", "a folder of maps that ends in / expected");
        row("-o out --file {row}.dae", "a folder of maps that ends in / expected");
        row("-o out --file {height}.glb", "there is no column \"height\"");
        row("-o out --file /tmp/{row}.glb", "a name below the folder expected");
        row("-o out --file ../{row}.glb", "a name below the folder expected");
        row("-o out --file a/../../{row}.glb", "a name below the folder expected");
        row("-o out --file {preset}.glb", "line 2 writes it too");
        row("-o out --file {row}.glb --file {row}.glb", "line 2 writes it too");
        row("-o out --file {block}.glb", ":3: file \"000000.glb\": line 2 writes it too");
    }
    void badUsage()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, part);
        options.replaceInStrings("out", path("out"));
        QVERIFY(isRefused(runCli(QStringList{"batch", table(test::smallTrees(2))} + options), part));
        QVERIFY(!QFile::exists(path("out"))); // nothing was begun
    }

    void badTables_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QByteArray& text, const char* part) {
            QTest::newRow(name) << text << QString::fromUtf8(part);
        };
        row("empty", "", "no columns");
        row("no rows", "preset,seed\n", "no rows: the first line only names the columns");
        row("neither input nor preset", "seed\n1\n", "one column expected of input and preset");
        row("both", "input,preset\n1,2\n", "one column expected of input and preset");
        row("unknown column", "preset,turtle.beta\nTinyTree,1\n", "t.csv:1: unknown column \"turtle.beta\"");
        row("ragged", "preset,seed\nTinyTree\n", "t.csv:2: 1 cells, and there are 2 columns");
        row("quote", "preset,seed\n\"TinyTree,1\n", "t.csv:2: a quote that is not closed");
        row("own files of two rows", "preset,files\nTinyTree,a.obj\nTinyTree,a.obj\n",
            "t.csv:3: file \"a.obj\": line 2 writes it too");
    }
    void badTables()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, part);
        QVERIFY(isRefused(runCli({"batch", table(text), "-o", path("out")}), part));
        QVERIFY(!QFile::exists(path("out")));
    }

    void noTable()
    {
        QVERIFY(isRefused(runCli({"batch", path("none.csv"), "-o", path("out")}), "none.csv"));
        QVERIFY(isRefused(runCli({"batch"}), "missing VARIATIONS.csv"));
    }

    /// Exit code 3; the others are there.
    void badRowsAreErrorsAndTheOthersGoOn()
    {
        const QByteArray text = "input,seed,turtle.alpha\n"
                                "preset:TinyTree,1,\n"
                                "preset:NoTree,2,\n"
                                "none.ramure,3,\n"
                                "preset:TinyTree,soon,\n"
                                "preset:TinyTree,-5,\n"
                                "preset:TinyTree,6,long\n"
                                "preset:TinyTree,7,\n";
        const auto run = runCli(batchOf(table(text), path("out"), {"--file", "{row}.obj"}));
        QCOMPARE(run.code, 3);
        QVERIFY(run.err.contains("5 of 7 rows failed"));
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QCOMPARE(lines.size(), std::size_t(7));
        const char* parts[] = {nullptr,
                               "NoTree",
                               "none.ramure",
                               "\"soon\" is no whole number",
                               "\"-5\" is no whole number",
                               "turtle.alpha",
                               nullptr};
        for (std::size_t i = 0; i < lines.size(); ++i) {
            QCOMPARE(lines[i]["row"].toInt(), int(i) + 1);
            QCOMPARE(lines[i]["line"].toInt(), int(i) + 2);
            QCOMPARE(lines[i].contains("error"), parts[i] != nullptr);
            if (!parts[i]) {
                QCOMPARE(lines[i]["files"].toArray().size(), 4); // two meshes, their materials
                continue;
            }
            QVERIFY(!lines[i].contains("files"));
            QCOMPARE(lines[i]["error"]["kind"].toString(), QString("input"));
            const QString why = lines[i]["error"]["text"].toString();
            QVERIFY2(why.contains(QLatin1String(parts[i])), qPrintable(why));
            QVERIFY(why.startsWith(QStringLiteral("t.csv:%1: ").arg(i + 2)));
            QVERIFY(run.err.contains(why));
        }
        QVERIFY(!bytesOf(path("out/manifest.jsonl")).contains(folder().toUtf8()));
    }

    /// Whoever looks into the folder takes what is there for what the manifest says.
    void aRowThatFailsTakesItsOldFilesAway()
    {
        const QByteArray head = "preset,seed,turtle.alpha\n";
        const auto run = [&](const QByteArray& rows) {
            return runCli(batchOf(table(head + rows), path("out"), {"--file", "{row}/{seed}.ply"})).code;
        };
        QCOMPARE(run("TinyTree,1,\nTinyTree,2,\n"), 0);
        test::write(path("out/TinyTree_3.obj"), "mine");
        const auto before = test::filesBelow(path("out"));
        QVERIFY(before.contains("TinyTree_1.mtl") && before.contains("000001/1.ply"));
        QCOMPARE(run("TinyTree,1,long\nTinyTree,2,\n"), 3);
        auto expected = before;
        for (const char* gone : {"TinyTree_1.obj", "TinyTree_1.mtl", "000001/1.ply"})
            expected.erase(QLatin1String(gone));
        auto after = test::filesBelow(path("out"));
        after.erase("manifest.jsonl");
        expected.erase("manifest.jsonl");
        QVERIFY(after == expected);
    }

    void linesSayWhatTheFilesAre()
    {
        QCOMPARE(runCli(batchOf(table(test::smallTrees(2)), path("out"), {"--file", "{row}.ply"})).code, 0);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QCOMPARE(lines.size(), std::size_t(2));
        const QJsonObject file = lines[0]["files"].toArray()[2].toObject();
        QCOMPARE(file["name"].toString(), QString("TinyTree_1.obj"));
        const QByteArray bytes = bytesOf(path("out/TinyTree_1.obj"));
        QCOMPARE(file["bytes"].toInteger(), bytes.size());
        QCOMPARE(file["sha256"].toString().toLatin1(),
                 QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
        QVERIFY(lines[0]["proof"]["valid"].toBool() && lines[0]["proof"]["openMesh"].toBool());
        QCOMPARE(lines[0]["seed"].toInt(), 1);
        QCOMPARE(lines[0]["set"].toArray(), QJsonArray{"sections.radialDivisions=4"});
        QVERIFY(lines[0]["inputs"].toString() != lines[1]["inputs"].toString());
        QVERIFY(lines[0]["proof"]["mesh"].toString() != lines[1]["proof"]["mesh"].toString());
        // The same as `validate` says of the same tree.
        const auto checked = runCli({"validate", path("out/000001.ply"), "--json"}).json();
        QVERIFY(checked["valid"].toBool());
        QCOMPARE(checked["hash"].toString(), lines[0]["proof"]["mesh"].toString());
        QCOMPARE(checked["faces"].toInt(), lines[0]["counts"]["faces"].toInt());
        QVERIFY(lines[0]["counts"]["faces"].toInt() > 100);
    }

    void shardsPutTogetherAreOneRun()
    {
        const QString csv = table(test::smallTrees(11));
        QCOMPARE(runCli(batchOf(csv, path("one"), {"--jobs", "1"})).code, 0);
        const auto whole = filesBelow(path("one"));
        QCOMPARE(whole.size(), std::size_t(12 + 11)); // meshes, their materials, the manifest
        QCOMPARE(runCli(batchOf(csv, path("two"))).code, 0);
        QVERIFY(filesBelow(path("two")) == whole);
        // 13: some have no row.
        for (const int count : {2, 7, 13}) {
            const QString folder = path(QString::number(count));
            for (int i = count; i >= 1; --i)
                QCOMPARE(
                    runCli(batchOf(csv, folder, {"--shard", QStringLiteral("%1/%2").arg(i).arg(count)})).code,
                    0);
            QByteArray merged;
            for (const QString& name : QDir(folder).entryList({"manifest-*.jsonl"}, QDir::Files, QDir::Name))
                merged += bytesOf(folder + '/' + name);
            QCOMPARE(merged, whole.at("manifest.jsonl"));
            for (const auto& [name, bytes] : whole)
                if (name != "manifest.jsonl")
                    QVERIFY2(bytesOf(folder + '/' + name) == bytes, qPrintable(name));
        }
    }

    void resumeDoesWhatIsMissingOrAltered()
    {
        const QString csv = table(test::smallTrees(5));
        const auto run = [&](const QByteArray& text) {
            return runCli(batchOf(table(text), path("out"), {"--resume", "--timings", path("seconds")})).code;
        };
        QCOMPARE(run(test::smallTrees(5)), 0); // nothing to go on from
        QCOMPARE(bytesOf(path("seconds")).count('\n'), 5);
        const auto whole = filesBelow(path("out"));
        QCOMPARE(run(test::smallTrees(5)), 0);
        QCOMPARE(bytesOf(path("seconds")).count('\n'), 0);
        QVERIFY(filesBelow(path("out")) == whole);
        QVERIFY(QFile::remove(path("out/TinyTree_2.obj")));
        test::write(path("out/TinyTree_4.obj"), whole.at("TinyTree_4.obj") + " ");
        QCOMPARE(run(test::smallTrees(5)), 0);
        QCOMPARE(linesOf(path("seconds")).size(), std::size_t(2));
        QVERIFY(filesBelow(path("out")) == whole);
        // Another value is another tree; a row more is a row more.
        QByteArray text = test::smallTrees(6);
        text.replace("TinyTree,3,4", "TinyTree,3,6");
        QCOMPARE(run(text), 0);
        std::set<int> rows;
        for (const QJsonObject& line : linesOf(path("seconds")))
            rows.insert(line["row"].toInt());
        QCOMPARE(rows, (std::set{3, 6}));
        QVERIFY(bytesOf(path("out/TinyTree_3.obj")) != whole.at("TinyTree_3.obj"));
        // Errors are tried again.
        QCOMPARE(run(text + "NoTree,9,4\n"), 3);
        QCOMPARE(run(text + "NoTree,9,4\n"), 3);
        QCOMPARE(linesOf(path("seconds")).size(), std::size_t(1));
    }

    /// A project's bytes are among what its rows depend on.
    void projectsAreInputs()
    {
        const auto project = [&](int iterations) {
            test::write(path("oak.ramure"), R"({"format": "ramure", "version": 1, "nodes": [{"id": 1, "kind":
                "tree", "name": "Oak", "params": {"grammar.iterations": )" +
                                                QByteArray::number(iterations) + "}}]}");
        };
        project(2);
        const QByteArray text = "input,seed\noak.ramure,1\noak.ramure,2\n";
        const auto run = [&](const QStringList& more) {
            return runCli(
                batchOf(table(text), path("out"), more + QStringList{"--timings", path("seconds")}));
        };
        const auto first = run({});
        QVERIFY2(first.code == 0, qPrintable(first.err));
        QCOMPARE(linesOf(path("out/manifest.jsonl"))[0]["input"].toString(), QString("oak.ramure"));
        QVERIFY(QFile::exists(path("out/oak_1.obj")));
        QCOMPARE(run({"--resume"}).code, 0);
        QVERIFY(bytesOf(path("seconds")).isEmpty());
        project(3);
        QCOMPARE(run({"--resume"}).code, 0);
        QCOMPARE(bytesOf(path("seconds")).count('\n'), 2);
    }

    void meshesAreNoRows()
    {
        QCOMPARE(runCli({"export", "preset:TinyTree", "-o", path("a.obj")}).code, 0);
        const QString rows = table("input,seed\na.obj,\na.obj,1\n");
        QCOMPARE(runCli({"batch", rows, "-o", path("out"), "--file", "{row}.ply"}).code, 3);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QVERIFY(lines[0]["error"]["text"].toString().contains("a mesh"));
        QVERIFY(lines[1]["error"]["text"].toString().contains("neither a seed nor parameters"));
    }

    void templatesName()
    {
        const QByteArray text = "preset,seed,name,files\n"
                                "TinyTree,1,a/b,\n"
                                "TinyTree,2,..,x/{name}{row}.ply;{block}/y.obj\n";
        QCOMPARE(runCli({"batch", table(text), "-o", path("out"), "--file", "{name}_{preset}_{seed}.ply",
                         "--jobs", "1"})
                     .code,
                 0);
        QVERIFY(QFile::exists(path("out/a_b_TinyTree_1.ply"))); // no folder by chance
        QVERIFY(QFile::exists(path("out/x/..000002.ply")));
        QVERIFY(QFile::exists(path("out/000000/y.obj")));
        QVERIFY(!QFile::exists(path("out/TinyTree_000001.glb")));
    }

    void picturesAndMaps()
    {
        const QByteArray text = "preset,seed\nSilverBirch1995,1\nSilverBirch1995,2\n";
        const auto run = [&](const QString& folder, const char* jobs) {
            return runCli({"batch", table(text), "-o", folder, "--file", "{row}.png", "--file", "{row}/",
                           "--map-size", "64", "--size", "96x64", "--jobs", QLatin1String(jobs)});
        };
        const auto one = run(path("one"), "1");
        QVERIFY2(one.code == 0, qPrintable(one.err));
        const QImage picture(path("one/000001.png"));
        QCOMPARE(picture.size(), QSize(96, 64));
        const QStringList maps = QDir(path("one/000001")).entryList({"*.png"}, QDir::Files);
        QVERIFY(maps.size() >= 3);
        for (const QString& map : maps)
            QVERIFY(!QImage(path("one/000001/") + map).isNull());
        QVERIFY(bytesOf(path("one/000001.png")) != bytesOf(path("one/000002.png")));
        QCOMPARE(run(path("two"), "2").code, 0);
        QVERIFY(filesBelow(path("two")) == filesBelow(path("one")));
    }

    /// Of GLB files; another number of them is another input, so that --resume makes them anew.
    void levelsOfDetail()
    {
        const QByteArray text = "preset,seed,mesh.targetTriangles\nTinyTree,1,4000\n";
        const auto run = [&](const QStringList& options) {
            return runCli(batchOf(table(text), path("out"),
                                  QStringList{"--file", "{row}.glb", "--file", "{row}.ply"} + options));
        };
        const auto plain = run({});
        QVERIFY2(plain.code == 0, qPrintable(plain.err));
        QVERIFY(!bytesOf(path("out/000001.glb")).contains("branches_LOD1"));
        const QByteArray tree = bytesOf(path("out/000001.ply"));
        QCOMPARE(run({"--levels", "2", "--budget", "4000,900", "--resume"}).code, 0);
        const QByteArray levels = bytesOf(path("out/000001.glb"));
        QVERIFY(levels.contains("branches_LOD1") && !levels.contains("branches_LOD2"));
        QVERIFY(bytesOf(path("out/000001.ply")) == tree);
        QCOMPARE(linesOf(path("out/manifest.jsonl"))[0]["files"].toArray().size(), 4); // with OBJ and MTL
    }

    /// They are what is proved and counted; a picture beside them is no mesh.
    void levelsAloneAreProved()
    {
        const auto ended = runCli({"batch", table("preset,seed\nSilverBirch1995,1\n"), "-o", path("out"),
                                   "--file", "{row}.glb", "--file", "{row}.png", "--levels", "2", "--budget",
                                   "4000,900", "--map-size", "0"});
        QVERIFY2(ended.code == 0, qPrintable(ended.err));
        const QJsonObject line = linesOf(path("out/manifest.jsonl"))[0];
        const QJsonObject counts = line["counts"].toObject();
        QVERIFY(line["proof"]["valid"].toBool() && line["proof"]["openMesh"].toBool());
        QVERIFY(line["measures"]["height"].toDouble() > 5.0);
        const QJsonArray levels = counts["levels"].toArray();
        QCOMPARE(levels.size(), 2);
        for (const auto& [level, budget] : {std::pair(0, 4000), std::pair(1, 900)})
            QVERIFY(std::abs(levels[level]["triangles"].toInt() - budget) <= budget / 50);
        QCOMPARE(counts["leaves"], levels[0]["leaves"]);
        QVERIFY(levels[0]["leaves"].toInt() > levels[1]["leaves"].toInt() && levels[1]["leaves"].toInt() > 0);
        QVERIFY(counts["faces"].toInt() > 100 && counts["faces"].toInt() < 4000);
        QVERIFY(counts["volume"].toDouble() > 0.0);
    }

    void progressInThreeDialects()
    {
        QByteArray text = test::smallTrees(3) + "NoTree,4,4\n";
        const auto run = [&](const char* dialect) {
            const auto ended =
                runCli(batchOf(table(text), path("out"), {"--progress", QLatin1String(dialect)}));
            QTest::qVerify(ended.code == 3 && ended.out.isEmpty(), "ended", dialect, __FILE__, __LINE__);
            return ended.err.split('\n', Qt::SkipEmptyParts);
        };
        const QStringList words = run("text"); // no terminal: no percentages
        QCOMPARE(words.size(), 2);
        QVERIFY(words[0].contains("NoTree"));
        QCOMPARE(words[1], QString("ramure-cli: 1 of 4 rows failed: the manifest says why"));
        int done = 0;
        for (const QString& line : run("json")) {
            QJsonParseError error;
            const QJsonObject object = QJsonDocument::fromJson(line.toUtf8(), &error).object();
            QVERIFY2(error.error == QJsonParseError::NoError && !object.isEmpty(), qPrintable(line));
            if (!object.contains("done"))
                continue;
            QCOMPARE(object["done"].toInt(), ++done);
            QCOMPARE(object["rows"].toInt(), 4);
        }
        QCOMPARE(done, 4);
        const QStringList told = run("openjd");
        static const QRegularExpression form("^openjd_(progress: \\d+|status: .+|fail: .+)$");
        for (const QString& line : told)
            QVERIFY2(form.match(line).hasMatch(), qPrintable(line));
        QVERIFY(told.contains("openjd_progress: 25") && told.contains("openjd_progress: 100"));
        QCOMPARE(told.back(), QString("openjd_fail: 1 of 4 rows failed: the manifest says why"));
        text = test::smallTrees(3);
        QVERIFY(!runCli(batchOf(table(text), path("out"), {"--progress", "openjd"})).err.contains("fail"));
        QVERIFY(runCli(batchOf(table(text), path("out"))).err.isEmpty());
    }

    void manifestElsewhere()
    {
        QCOMPARE(
            runCli(batchOf(table(test::smallTrees(1)), path("out"), {"--manifest", path("mine.jsonl")})).code,
            0);
        QCOMPARE(linesOf(path("mine.jsonl")).size(), std::size_t(1));
        QVERIFY(!QFile::exists(path("out/manifest.jsonl")));
        QVERIFY(isRefused(
            runCli(batchOf(table(test::smallTrees(1)), path("out"), {"--manifest", path("none/mine.jsonl")})),
            "none/mine.jsonl"));
        QVERIFY(isRefused(
            runCli(batchOf(table(test::smallTrees(1)), path("out"), {"--timings", path("none/seconds")})),
            "none/seconds"));
        QVERIFY(isRefused(runCli(batchOf(table(test::smallTrees(1)), path("t.csv"))), "cannot be made"));
    }

    void timingsWithoutRoomAreTold()
    {
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path("full.jsonl")));
        const QStringList toFull{"--timings", path("full.jsonl")};
        QVERIFY(isRefused(runCli(batchOf(table(test::smallTrees(2)), path("out"), toFull)), "full.jsonl", 5));
        // The row whose seconds could not be written is kept.
        QVERIFY(!linesOf(path("out/manifest.jsonl")).empty());
    }
};

RAMURE_SUITE(TestRamureCliBatch)

} // namespace tst_ramure_cli_batch

#include "tst_ramure_cli_batch.moc"
