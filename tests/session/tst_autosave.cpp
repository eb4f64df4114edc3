#include "core/qt/session/jobs/autosave.h"
#include "tests/support/failing_disk.h"
#include "tests/support/seeded_tree.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace tst_autosave {

using namespace ramure;
using test::oneTree;
using test::seedOf;
using test::setSeed;

static int filesIn(const QString& folder)
{
    return static_cast<int>(QDir(folder).entryList(QDir::Files | QDir::Hidden).size());
}

class TestAutosave : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void unwritableFoldersAreTold();
    void itIsToldOnceAndWhenItWorksAgain();
    void foldersThatGoAreMadeAgain();
    void brokenFilesAreNotOffered();
    void whatAKillLeavesWithoutARecoveryFileGoes();
    void nothingUnsavedNoFile();
    void runningProgramsAreNotOffered();
    void aProjectThatWasSavedLaterIsTold();
    void timerSavesInTheBackground();
    void savingAndClosingRemoveTheFile();
};

void TestAutosave::unwritableFoldersAreTold()
{
    QTemporaryDir folder;
    QFile file(folder.filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.filePath("file/below"));
    QSignalSpy failures(&autosave, &Autosave::failed);
    setSeed(document, 5);
    QCOMPARE(autosave.saveNow().error().code, ErrorCode::Io);
    autosave.setInterval(1);
    QTRY_COMPARE(failures.count(), 1);
    test::letHappen(20);
    QCOMPARE(failures.count(), 1); // said once
    QVERIFY(recoverableProjects(folder.filePath("none")).empty());
    QVERIFY(recoverableProjects(folder.filePath("file")).empty());
}

void TestAutosave::itIsToldOnceAndWhenItWorksAgain()
{
    QTemporaryDir folder;
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.path());
    QSignalSpy failures(&autosave, &Autosave::failed), again(&autosave, &Autosave::worksAgain);
    setSeed(document, 5);
    QVERIFY(autosave.saveNow());
    QCOMPARE(again.count(), 0); // it never failed
    for (int time = 1; time <= 2; ++time) {
        {
            const test::SmallDisk disk(0);
            setSeed(document, 5 + time);
            QVERIFY(!autosave.saveNow());
            QVERIFY(!autosave.saveNow());
            QCOMPARE(failures.count(), time);
            QCOMPARE(seedOf(*loadProjectFile(autosave.recoveryPath())), 4 + time); // what was kept before
        }
        QVERIFY(autosave.saveNow());
        QCOMPARE(again.count(), time);
        QCOMPARE(seedOf(*loadProjectFile(autosave.recoveryPath())), 5 + time);
    }
}

void TestAutosave::foldersThatGoAreMadeAgain()
{
    QTemporaryDir folder;
    QFile file(folder.filePath("kept"));
    QVERIFY(file.open(QIODevice::WriteOnly)); // first it cannot be made
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.filePath("kept"));
    setSeed(document, 5);
    QVERIFY(!autosave.saveNow());
    QVERIFY(file.remove());
    for (const int seed : {6, 7}) {
        setSeed(document, seed);
        QVERIFY(autosave.saveNow());
        QVERIFY(QFile::exists(autosave.recoveryPath()));
        QVERIFY(recoverableProjects(folder.filePath("kept")).empty()); // locked again as well
        if (seed == 7)
            break;
        QVERIFY(QDir(folder.filePath("kept")).removeRecursively());
        QTest::ignoreMessage(QtWarningMsg, // Qt's, of the lock that went with the folder
                             QRegularExpression("^Could not remove our own lock file"));
    }
}

void TestAutosave::brokenFilesAreNotOffered()
{
    QTemporaryDir folder;
    QFile file(folder.filePath("broken.ramure"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\":");
    file.close();
    QVERIFY(recoverableProjects(folder.path()).empty());
    QVERIFY(file.exists()); // somebody may still make sense of it
    QVERIFY(!loadRecoverable({file.fileName(), {}, {}, {}}));
}

void TestAutosave::whatAKillLeavesWithoutARecoveryFileGoes()
{
    QTemporaryDir folder;
    const auto make = [&folder](const char* name, const QByteArray& bytes) {
        QFile file(folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
    };
    // As QLockFile writes it: process, program, machine.
    const QByteArray dead = "2147483646\nramure\n" + QSysInfo::machineHostName().toLocal8Bit() + "\n";
    QVERIFY(make("one.ramure.lock", dead));
    QVERIFY(make("one.ramure.new-2147483646-0", "{\"format\":"));
    QVERIFY(make("notes.txt", "mine"));
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.path()); // a program that runs and has saved nothing yet
    QVERIFY(recoverableProjects(folder.path()).empty());
    const QStringList left = QDir(folder.path()).entryList(QDir::Files);
    QVERIFY2(left.size() == 2 && left.contains("notes.txt"), qPrintable(left.join(u' ')));
    QVERIFY(left.contains(QFileInfo(autosave.recoveryPath()).fileName() + ".lock"));
}

void TestAutosave::nothingUnsavedNoFile()
{
    QTemporaryDir folder;
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.filePath("deep/folder"));
    QVERIFY(autosave.saveNow());
    QVERIFY(!QFile::exists(autosave.recoveryPath()));
    QVERIFY(Autosave::defaultFolder().startsWith(
        QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)));
}

void TestAutosave::runningProgramsAreNotOffered()
{
    QTemporaryDir folder;
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.path());
    setSeed(document, 5);
    QVERIFY(autosave.saveNow());
    QVERIFY(QFile::exists(autosave.recoveryPath()));
    QVERIFY(recoverableProjects(folder.path()).empty());
}

void TestAutosave::aProjectThatWasSavedLaterIsTold()
{
    QTemporaryDir folder;
    const QString project = folder.filePath("oak.ramure");
    QVERIFY(saveProjectFile({oneTree(), {}}, project));
    Document document;
    document.reset(oneTree(), project);
    Autosave autosave(&document, folder.filePath("running"));
    setSeed(document, 5);
    QVERIFY(autosave.saveNow());
    const QString left = folder.filePath("left");
    QVERIFY(QDir().mkpath(left) &&
            QFile::copy(autosave.recoveryPath(), left + "/one.ramure")); // as a kill does
    const auto savedAt = [&](int secondsFromNow) {
        QFile file(project);
        return file.open(QIODevice::ReadWrite) &&
               file.setFileTime(QDateTime::currentDateTime().addSecs(secondsFromNow),
                                QFileDevice::FileModificationTime);
    };
    QVERIFY(savedAt(-60));
    QVERIFY(!recoverableProjects(left).front().savedLater.isValid());
    QVERIFY(savedAt(60));
    QVERIFY(recoverableProjects(left).front().savedLater.isValid());
    QVERIFY(QFile::remove(project));
    QVERIFY(!recoverableProjects(left).front().savedLater.isValid());
}

void TestAutosave::timerSavesInTheBackground()
{
    QTemporaryDir folder;
    Document document;
    document.reset(oneTree(), {});
    Autosave autosave(&document, folder.path());
    QSignalSpy saved(&autosave, &Autosave::saved);
    autosave.setInterval(1);
    setSeed(document, 5);
    QTRY_COMPARE(saved.count(), 1);
    test::letHappen(20);
    QCOMPARE(saved.count(), 1); // nothing new, nothing written
    setSeed(document, 6);
    QTRY_COMPARE(saved.count(), 2);
    const auto project = loadProjectFile(autosave.recoveryPath());
    QVERIFY2(project, test::why(project));
    QCOMPARE(seedOf(*project), 6);
    autosave.setInterval(0);
    setSeed(document, 7);
    test::letHappen(20);
    QCOMPARE(saved.count(), 2);
}

void TestAutosave::savingAndClosingRemoveTheFile()
{
    QTemporaryDir folder;
    Document document;
    document.reset(oneTree(), {});
    {
        Autosave autosave(&document, folder.path());
        setSeed(document, 5);
        QVERIFY(autosave.saveNow());
        QVERIFY(QFile::exists(autosave.recoveryPath()));
        document.markSaved(); // saved
        QVERIFY(!QFile::exists(autosave.recoveryPath()));
        setSeed(document, 6);
        QVERIFY(autosave.saveNow());
        document.reset(oneTree(), {});
        QVERIFY(!QFile::exists(autosave.recoveryPath()));
        document.markModified(); // as after a recovery
        QVERIFY(autosave.saveNow());
        QVERIFY(QFile::exists(autosave.recoveryPath()));
    }
    QCOMPARE(filesIn(folder.path()), 0);
}

RAMURE_SUITE(TestAutosave)

} // namespace tst_autosave

#include "tst_autosave.moc"
