#include "tests/cli/batch_support.h"
#include <QDateTime>
#include <QFileInfo>

namespace tst_ramure_cli_job {

using namespace ramure;
using test::batchOf;
using test::bytesOf;
using test::isRefused;
using test::runCli;
using test::runProgram;

/// Batches as jobs of many machines: what the scripts say, and that they do it.
class TestRamureCliJob : public test::FolderSuite
{
    Q_OBJECT

    test::CliRun job(const char* kind, const QStringList& more = {}) const
    {
        return runCli(QStringList{"job", QLatin1String(kind), table(test::smallTrees(7)), "-o", path("out"),
                                  "--file", "{preset}_{seed}.obj"} +
                      more);
    }
    [[nodiscard]] QByteArray wholeManifest() const
    {
        if (runCli(batchOf(table(test::smallTrees(7)), path("whole"))).code != 0)
            qFatal("the batch failed");
        return bytesOf(path("whole/manifest.jsonl"));
    }
    /// In the folder of the trees, with this program.
    test::CliRun inFolder(const QStringList& words, const QStringList& variables = {}) const
    {
        QStringList all{"-C", path("out"), QStringLiteral("RAMURE_CLI=%1").arg(QLatin1String(RAMURE_CLI))};
        return runProgram("env", all + variables + words);
    }

private slots:
    void init() { begin(); }

    void badUsage_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* arguments, const char* part) {
            QTest::newRow(arguments) << QString::fromUtf8(arguments).split(' ') << QString::fromUtf8(part);
        };
        row("job", "missing VARIATIONS.csv");
        row("job TABLE -o OUT", "one of --slurm, --openjd, --flamenco and --make expected");
        row("job TABLE -o OUT --slurm --make", "--slurm and --make exclude each other");
        row("job TABLE --make", "missing -o FOLDER");
        row("job none.csv --make -o OUT", "none.csv");
        row("job TABLE --make -o OUT --shards 1", "--shards \"1\": 2 to 100000 expected");
        row("job TABLE --make -o OUT --shards 100001", "--shards");
        row("job TABLE --make -o OUT --shards many", "--shards \"many\"");
        row("job TABLE --make -o OUT --file {preset}.obj", "line 2 writes it too");
        row("job TABLE --make -o OUT --memory 2T", "--memory \"2T\"");
        row("job TABLE --make -o OUT --size 3", "--size \"3\"");
        row("job TABLE --make -o TABLE", "cannot be made");
    }
    void badUsage()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, part);
        arguments.replaceInStrings("TABLE", table(test::smallTrees(2)));
        arguments.replaceInStrings("OUT", path("out"));
        QVERIFY(isRefused(runCli(arguments), part));
        QVERIFY(!QFile::exists(path("out")));
    }

    void scriptsAreTheSameEverywhere_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("--slurm") << "job.sbatch";
        QTest::newRow("--openjd") << "job.openjd.json";
        QTest::newRow("--flamenco") << "job.flamenco.js";
        QTest::newRow("--make") << "Makefile";
    }
    void scriptsAreTheSameEverywhere()
    {
        QFETCH(QString, file);
        QCOMPARE(job(QTest::currentDataTag()).code, 0);
        const QByteArray first = bytesOf(path("out/") + file);
        QVERIFY(!first.isEmpty() && first.endsWith('\n'));
        QVERIFY(!first.contains(folder().toUtf8()));
        begin();
        QCOMPARE(job(QTest::currentDataTag()).code, 0);
        QCOMPARE(bytesOf(path("out/") + file), first);
    }

    void makeDoesItAll()
    {
        const QByteArray whole = wholeManifest();
        QCOMPARE(job("--make", {"--shards", "3"}).code, 0);
        const auto run = inFolder({"make", "-j2"});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QCOMPARE(bytesOf(path("out/manifest.jsonl")), whole);
        QVERIFY(QFile::exists(path("out/TinyTree_7.obj")));
        // Again: the parts are there. Without one of them, that one is done.
        const auto begun = [&](const char* part) {
            return QFileInfo(path(QLatin1String(part))).lastModified();
        };
        const QDateTime first = begun("out/.part-1");
        QVERIFY(QFile::remove(path("out/.part-2")));
        QVERIFY(QFile::remove(path("out/TinyTree_4.obj")));
        QCOMPARE(inFolder({"make"}).code, 0);
        QVERIFY(QFile::exists(path("out/.part-2")) && QFile::exists(path("out/TinyTree_4.obj")));
        QCOMPARE(begun("out/.part-1"), first);
        QCOMPARE(bytesOf(path("out/manifest.jsonl")), whole);
    }

    void makeSaysWhatFailed()
    {
        const QString csv = table(test::smallTrees(3) + "NoTree,4,4\n");
        QCOMPARE(
            runCli({"job", "--make", csv, "-o", path("out"), "--shards", "2", "--file", "{row}.obj"}).code,
            0);
        const auto run = inFolder({"make", "-j2"});
        QVERIFY(run.code != 0);
        QVERIFY2(run.err.contains("1 of 4 rows failed: manifest.jsonl says why"), qPrintable(run.err));
        QCOMPARE(test::linesOf(path("out/manifest.jsonl")).size(), std::size_t(4));
    }

    /// Each task as Slurm starts it; Slurm itself is among the clients.
    void slurmsTasksAndTheMerge()
    {
        const QByteArray whole = wholeManifest();
        QStringList options{"--shards", "3"};
        if (!test::isSanitized) // AddressSanitizer's own memory is more
            options += {"--memory", "1G"};
        QCOMPARE(job("--slurm", options).code, 0);
        QCOMPARE(runProgram("bash", {"-n", path("out/job.sbatch")}).code, 0);
        const QByteArray script = bytesOf(path("out/job.sbatch"));
        QVERIFY(script.contains("#SBATCH --requeue\n") && script.contains("--array=1-3 "));
        QVERIFY(test::isSanitized || script.contains("#SBATCH --mem=1280M\n"));
        const auto task = [&](const char* index) {
            return inFolder(
                {"bash", "job.sbatch"},
                {"SLURM_JOB_ID=9", QStringLiteral("SLURM_ARRAY_TASK_ID=") + QLatin1String(index)});
        };
        QCOMPARE(task("3").code, 0);
        QCOMPARE(task("1").code, 0);
        const auto early = inFolder({"bash", "job.sbatch", "merge"}, {"SLURM_JOB_ID=9"});
        QCOMPARE(early.code, 1);
        QVERIFY2(early.err.contains("5 of 7 rows are there"), qPrintable(early.err));
        QVERIFY(!QFile::exists(path("out/manifest.jsonl")));
        QCOMPARE(task("2").code, 0);
        QCOMPARE(task("2").code, 0); // requeued: nothing left to do
        QCOMPARE(inFolder({"bash", "job.sbatch", "merge"}, {"SLURM_JOB_ID=9"}).code, 0);
        QCOMPARE(bytesOf(path("out/manifest.jsonl")), whole);
    }

    void openJdsTemplate()
    {
        const QByteArray whole = wholeManifest();
        QCOMPARE(job("--openjd", {"--shards", "3"}).code, 0);
        QJsonParseError error;
        const QJsonObject all =
            QJsonDocument::fromJson(bytesOf(path("out/job.openjd.json")), &error).object();
        QCOMPARE(error.error, QJsonParseError::NoError);
        QCOMPARE(all["specificationVersion"].toString(), QString("jobtemplate-2023-09"));
        const QJsonObject trees = all["steps"].toArray()[0].toObject();
        QCOMPARE(trees["parameterSpace"]["taskParameterDefinitions"][0]["range"].toString(), QString("1-3"));
        const QJsonObject action = trees["script"]["actions"]["onRun"].toObject();
        for (const char* shard : {"1", "2", "3"}) {
            QStringList arguments;
            for (const QJsonValue word : action["args"].toArray())
                arguments << word.toString()
                                 .replace("{{Param.Table}}", path("t.csv"))
                                 .replace("{{Param.Folder}}", path("out"))
                                 .replace("{{Task.Param.Shard}}", shard);
            const auto run = runCli(arguments);
            QCOMPARE(run.code, 0);
            QVERIFY(run.err.contains("openjd_progress: 100\n"));
        }
        const QJsonObject merge = all["steps"].toArray()[1].toObject();
        QCOMPARE(merge["dependencies"][0]["dependsOn"].toString(), trees["name"].toString());
        const QString text = merge["script"]["embeddedFiles"][0]["data"].toString();
        QCOMPARE(runProgram("bash", {"-c", text, "merge", path("out")}).code, 0);
        QCOMPARE(bytesOf(path("out/manifest.jsonl")), whole);
    }

    void wordsAreQuoted()
    {
        QVERIFY(QDir(folder()).mkpath("it's $HOME"));
        const QString csv = path("it's $HOME/a b.csv");
        test::write(csv, "preset,seed,#it's\nTinyTree,1,a\nTinyTree,2,b\n");
        QCOMPARE(
            runCli({"job", "--make", csv, "-o", path("out"), "--shards", "2", "--file", "{#it's} $x.obj"})
                .code,
            0);
        const auto run = inFolder({"make"});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QVERIFY(QFile::exists(path("out/a $x.obj")) && QFile::exists(path("out/b $x.obj")));
    }
};

RAMURE_SUITE(TestRamureCliJob)

} // namespace tst_ramure_cli_job

#include "tst_ramure_cli_job.moc"
