// Programs that die while they edit: what they called safe is there.
#include "core/math/random.h"
#include "core/qt/session/jobs/autosave.h"
#include "tests/support/seeded_tree.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdio>

using namespace ramure;
using test::oneTree;
using test::seedOf;
using test::setSeed;

class TestAutosaveKilled : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void crashedProgramsAreOffered();
    void killedHundredTimes();
};

/// The other program: edits without end, saves now and then, says what is safe. Ends by being killed.
static int runVictim(const QString& folder)
{
    const QString path = folder + QStringLiteral("/work.ramure");
    Document document;
    if (auto project = loadProjectFile(path))
        document.reset(std::move(project->scene), path, std::move(project->extras));
    else
        document.reset(oneTree(), path);
    Autosave autosave(&document, folder + QStringLiteral("/recovery"));
    autosave.setInterval(3);
    std::int64_t seed = document.scene().find(1)->params.grammar.seed;
    const auto say = [](std::int64_t safe) {
        std::printf("%lld\n", static_cast<long long>(safe));
        std::fflush(stdout);
    };
    std::int64_t noted = seed;
    QObject::connect(&autosave, &Autosave::saved, &autosave, [&] { say(noted); });
    QTimer edits;
    QObject::connect(&edits, &QTimer::timeout, &edits, [&] {
        setSeed(document, ++seed);
        if (seed % 10 == 0 && saveProjectFile(document.project(), path)) {
            document.markSaved();
            say(seed);
        }
        if (auto kept = seed % 7 == 0 ? autosave.saveNow() : Expected<void>{}; seed % 7 == 0 && kept)
            say(noted = seed);
    });
    edits.start(0);
    return QCoreApplication::exec();
}

/// Lets it work for a while and kills it. Returns the last number that it called safe, 0 where there was
/// none.
static std::int64_t killAfter(const QString& folder, int milliseconds)
{
    QProcess victim;
    victim.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--victim"), folder});
    if (!victim.waitForStarted(20000) || !victim.waitForReadyRead(20000))
        return 0;
    test::anyMoment(milliseconds);
    victim.kill();
    victim.waitForFinished(20000);
    const QList<QByteArray> lines = victim.readAllStandardOutput().split('\n');
    return lines.size() < 2
               ? 0
               : lines[lines.size() - 2].toLongLong(); // behind the last line end may be half a line
}

void TestAutosaveKilled::crashedProgramsAreOffered()
{
    QTemporaryDir folder;
    QVERIFY(killAfter(folder.path(), 5) > 0);
    QString path;
    for (int i = 0; i < 50 && path.isEmpty(); ++i) { // it may have died just when all was saved
        std::vector<Recoverable> found = recoverableProjects(folder.filePath("recovery"));
        if (found.empty()) {
            killAfter(folder.path(), i);
            continue;
        }
        QCOMPARE(found.front().originalPath, folder.filePath("work.ramure"));
        QVERIFY(found.front().time.isValid());
        QVERIFY(recoverableProjects(folder.filePath("recovery")).empty()); // claimed
        const auto project = loadRecoverable(found.front());
        QVERIFY2(project, test::why(project));
        QVERIFY(project->extras.empty()); // the note is gone
        path = found.front().recoveryPath;
        discardRecoverable(found.front());
        QVERIFY(!QFile::exists(path));
    }
    QVERIFY(!path.isEmpty());
}

void TestAutosaveKilled::killedHundredTimes()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("work.ramure");
    Random random(1, RandomStream::Test);
    int offered = 0;
    for (int i = 0; i < 100; ++i) {
        const std::int64_t safe = killAfter(folder.path(), static_cast<int>(random.below(12)));
        QVERIFY(safe > 0);
        std::int64_t best = 0;
        if (QFile::exists(path)) {
            const auto project = loadProjectFile(path);
            QVERIFY2(project, test::why(project));
            best = seedOf(*project);
        }
        std::vector<Recoverable> found = recoverableProjects(folder.filePath("recovery"));
        QVERIFY(found.size() <= 1);
        for (Recoverable& entry : found) {
            const auto project = loadRecoverable(entry);
            QVERIFY2(project, test::why(project));
            best = std::max(best, seedOf(*project));
            ++offered;
            discardRecoverable(entry);
        }
        QVERIFY2(best >= safe, qPrintable(QStringLiteral("%1 was safe, %2 is there").arg(safe).arg(best)));
    }
    qInfo("killed 100 times: the project always opened, %d recoveries were offered", offered);
    QVERIFY(offered > 0);
}

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (argc == 3 && qstrcmp(argv[1], "--victim") == 0)
        return runVictim(QString::fromLocal8Bit(argv[2]));
    TestAutosaveKilled suite;
    return QTest::qExec(&suite, argc, argv);
}

#include "tst_autosave_killed.moc"
