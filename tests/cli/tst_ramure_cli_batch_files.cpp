#include "app/cli/commands/commands.h"
#include "core/base/file_writer.h"
#include "tests/cli/batch_support.h"
#include <cerrno>
#include <cstring>

namespace tst_ramure_cli_batch_files {

using namespace ramure;
using test::filesBelow;
using test::linesOf;
using test::runCli;

/// What stands in the folder is what the manifest says: rows that fail leave nothing, whatever they wrote
/// before, and a full disk is no row's fault.
class TestRamureCliBatchFiles : public test::FolderSuite
{
    Q_OBJECT

    test::CliRun run(const QByteArray& text, const QStringList& more)
    {
        return runCli(QStringList{"batch", table(text), "-o", path("out"), "--jobs", "2"} + more);
    }
    /// Files below the folder but for the manifests; those that no line names are told as a problem.
    [[nodiscard]] QStringList unnamed() const
    {
        QStringList found;
        for (const auto& [name, bytes] : filesBelow(path("out")))
            if (!name.endsWith(".jsonl"))
                found << name;
        for (const QString& manifest : QDir(path("out")).entryList({"*.jsonl"}))
            for (const QJsonObject& line : linesOf(path("out/" + manifest)))
                for (const QJsonValue file : line["files"].toArray())
                    found.removeAll(file["name"].toString());
        return found;
    }
    [[nodiscard]] QStringList namesOf(int row) const
    {
        QStringList names;
        for (const QJsonValue file :
             linesOf(path("out/manifest.jsonl")).at(std::size_t(row - 1))["files"].toArray())
            names << file["name"].toString();
        return names;
    }
    static inline const char* refusedName = nullptr; ///< part of the path that has no room
    static inline FileCalls realCalls;

private slots:
    void init() { begin(); }

    /// Pivots, pictures of a mesh and folders of maps: all that the row wrote goes, all of the others stays.
    void rowsThatFailLeaveNothing_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("part"); ///< of a name that the row has besides what the template says
        QTest::newRow("pivots") << QStringList{"--file", "{row}.glb", "--wind", "pivot-painter"}
                                << "_pivots.exr";
        QTest::newRow("pictures of a mesh")
            << QStringList{"--file", "{row}.obj", "--map-size", "64"} << "_colour.png";
        QTest::newRow("folder of maps") << QStringList{"--file", "{row}/"} << "_colour.png";
        QTest::newRow("one folder of maps")
            << QStringList{"--file", "{row}.ply", "--file", "maps/"} << "_colour.png";
        QTest::newRow("a picture and a mesh")
            << QStringList{"--file", "{row}/a.png", "--file", "{row}/b/a.obj", "--size", "32x32"} << ".mtl";
    }
    void rowsThatFailLeaveNothing()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, part);
        const QByteArray head = "preset,bark.family,bark.seed,foliage.leaf,turtle.alpha\n";
        const QByteArray other = "TinyTree,furrowed,2,oak,\n";
        const auto first =
            run(head + "TinyTree,ringed,1,birch,\n" + other + "TinyTree,furrowed,2,birch,\n", options);
        QVERIFY2(first.code == 0, qPrintable(first.err));
        test::write(path("out/mine.png"), "mine");
        const auto before = filesBelow(path("out"));
        const QStringList mine = namesOf(1), theirs = namesOf(2) + namesOf(3);
        QVERIFY2(!mine.filter(part).isEmpty(), qPrintable(mine.join(' ')));
        for (const QStringList& more : {QStringList(), QStringList{"--resume"}}) {
            QCOMPARE(run(head + "TinyTree,ringed,1,birch,long\n" + other + "TinyTree,furrowed,2,birch,\n",
                         options + more)
                         .code,
                     3);
            QCOMPARE(unnamed(), QStringList{"mine.png"});
            auto expected = before, after = filesBelow(path("out"));
            for (const QString& name : mine)
                if (!theirs.contains(name))
                    expected.erase(name);
            expected.erase("manifest.jsonl");
            after.erase("manifest.jsonl");
            QVERIFY(after == expected);
            QVERIFY(!QFileInfo::exists(path("out/000001"))); // nor an empty folder
        }
    }

    /// Rows of another shard may have the same pictures, which only their manifest would tell.
    void shardsLeaveEachOthersPictures()
    {
        const QStringList options{"--file", "{row}.obj", "--map-size", "64"};
        const QByteArray head = "preset,bark.family,turtle.alpha\n", row = "TinyTree,ringed,\n";
        for (const char* shard : {"1/2", "2/2"})
            QCOMPARE(run(head + row + row, options + QStringList{"--shard", shard}).code, 0);
        const auto before = filesBelow(path("out"));
        QCOMPARE(run(head + "TinyTree,ringed,long\n" + row, options + QStringList{"--shard", "1/2"}).code, 3);
        auto expected = before, after = filesBelow(path("out"));
        for (const char* gone : {"000001.obj", "000001.mtl"})
            QCOMPARE(expected.erase(gone), std::size_t(1));
        after.erase("manifest-1-of-2.jsonl");
        expected.erase("manifest-1-of-2.jsonl");
        QVERIFY(after == expected);
    }

    /// A manifest that somebody altered takes nothing away outside.
    void nothingOutsideOfTheFolderGoes()
    {
        QCOMPARE(run("preset,turtle.alpha\nTinyTree,\n", {"--file", "{row}.ply"}).code, 0);
        QByteArray manifest = test::bytesOf(path("out/manifest.jsonl"));
        manifest.replace("000001.ply", "../mine.ply");
        test::write(path("out/manifest.jsonl"), manifest);
        test::write(path("mine.ply"), "mine");
        QCOMPARE(run("preset,turtle.alpha\nTinyTree,long\n", {"--file", "{row}.ply"}).code, 3);
        QCOMPARE(test::bytesOf(path("mine.ply")), QByteArray("mine"));
        QVERIFY(!QFile::exists(path("out/000001.ply")));
    }

    /// A name that the system refuses is the row's error; the others go on.
    void filesThatCannotBeWritten()
    {
        QVERIFY(QDir().mkpath(path("out/000002.ply/full")));
        const auto ended = run(test::smallTrees(3), {"--file", "{row}.ply"});
        QCOMPARE(ended.code, 3);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QVERIFY(!lines[0].contains("error") && !lines[2].contains("error"));
        QCOMPARE(lines[1]["error"]["kind"].toString(), QString("output"));
        QVERIFY(lines[1]["error"]["text"].toString().startsWith("t.csv:3: 000002.ply: cannot be written"));
        QVERIFY(QFileInfo(path("out/000002.ply/full")).isDir());
    }

    /// The batch stops: every row after it would be grown for nothing. What is done stays, and goes on later.
    void aFullDiskStopsTheBatch()
    {
        refusedName = "000003";
        realCalls = fileCalls();
        fileCalls().open = [](const char* file, int flags, mode_t mode) {
            if (!std::strstr(file, refusedName))
                return realCalls.open(file, flags, mode);
            errno = ENOSPC;
            return -1;
        };
        const QStringList arguments{table(test::smallTrees(6)),
                                    "-o",
                                    path("out"),
                                    "--file",
                                    "{row}.ply",
                                    "--jobs",
                                    "1",
                                    "--progress",
                                    "json"};
        cli::CommandLine line(cli::batchCommand.text);
        cli::batchCommand.addOptions(line);
        QVERIFY(line.parse(arguments));
        const auto code = cli::batchCommand.run(line);
        fileCalls() = realCalls;
        QVERIFY2(code.has_value(), test::why(code));
        QCOMPARE(*code, 5);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        QCOMPARE(lines.size(), std::size_t(3));
        QVERIFY(!lines[0].contains("error") && !lines[1].contains("error"));
        QCOMPARE(lines[2]["error"]["kind"].toString(), QString("disk"));
        QCOMPARE(lines[2]["error"]["text"].toString(),
                 QString("t.csv:4: 000003.ply: cannot be written: No space left on device"));
        QCOMPARE(unnamed(), QStringList());
        QCOMPARE(QDir(path("out")).entryList({"*.ply"}).size(), 2);
        QCOMPARE(runCli(QStringList{"batch"} + arguments + QStringList{"--resume"}).code, 0);
        QCOMPARE(linesOf(path("out/manifest.jsonl")).size(), std::size_t(6));
    }
};

RAMURE_SUITE(TestRamureCliBatchFiles)

} // namespace tst_ramure_cli_batch_files

#include "tst_ramure_cli_batch_files.moc"
