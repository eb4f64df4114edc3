#include "core/base/file_writer.h"
#include "tests/support/failing_disk.h"
#include "tests/support/waits.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include <QSignalSpy>

namespace tst_preferences {

using namespace ramure;

/// Preferences and the disk; what they are is tested where they are set.
class TestPreferences : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

    static QString file() { return QSettings().fileName(); }
    /// To write what was set.
    static bool hasTried(const Preferences& preferences)
    {
        return !preferences.findChild<QTimer*>()->isActive();
    }
    static QString folder() { return QFileInfo(file()).path(); }
    static Error errorOf(const QSignalSpy& failures) { return failures.last().first().value<Error>(); }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        QSettings().sync();
    }

    void unwritableFoldersAreTold()
    {
        QVERIFY(QDir(folder()).removeRecursively());
        QFile blocker(folder());
        QVERIFY(blocker.open(QIODevice::WriteOnly)); // not even the administrator writes below a file
        Preferences preferences;
        QSignalSpy failures(&preferences, &Preferences::failed);
        preferences.welcomeAtStart.set(false);
        QTRY_COMPARE(failures.count(), 1);
        QCOMPARE(errorOf(failures).message(), file().toStdString() + ": cannot be written: Not a directory");
        preferences.setAutosaveMinutes(7);
        QTRY_VERIFY(hasTried(preferences));
        QCOMPARE(failures.count(), 1); // told once
        QVERIFY(!preferences.welcomeAtStart());
        QVERIFY(blocker.remove());
        preferences.groundVisible.set(false);
        QTRY_VERIFY(QFile::exists(file()));
        const QSettings stored(file(), QSettings::IniFormat);
        QCOMPARE(stored.value(QStringLiteral("files/autosaveMinutes")).toInt(), 7); // nothing was lost
        QCOMPARE(failures.count(), 1);
    }

    void fullDisksLeaveTheOldFile()
    {
        {
            Preferences before;
            before.setAutosaveMinutes(3);
        }
        const auto files = test::filesIn(folder());
        QCOMPARE(files.size(), 1);
        Preferences preferences;
        QSignalSpy failures(&preferences, &Preferences::failed);
        {
            const test::SmallDisk disk(10);
            preferences.setAutosaveMinutes(4);
            QTRY_COMPARE(failures.count(), 1);
            QCOMPARE(errorOf(failures).code, ErrorCode::Io);
            QCOMPARE(errorOf(failures).file, file().toStdString());
            QVERIFY(test::filesIn(folder()) == files);
        }
        preferences.setAutosaveMinutes(5);
        QTRY_VERIFY(hasTried(preferences));
        QVERIFY(test::filesIn(folder()) != files);
        const test::SmallDisk disk(10);
        preferences.setAutosaveMinutes(6);
        QTRY_COMPARE(failures.count(), 2); // another time, told again
    }

    void disksThatDoNotSyncAreTold()
    {
        for (const int call : {2, 4}) { // file and folder
            Preferences preferences;
            QSignalSpy failures(&preferences, &Preferences::failed);
            const test::FailingDisk disk(call, EIO);
            preferences.setAutosaveMinutes(call);
            QTRY_COMPARE(failures.count(), 1);
            QCOMPARE(errorOf(failures).message(),
                     file().toStdString() + ": cannot be written: Input/output error");
        }
    }

    void whatIsSetLastIsWrittenAtTheEnd()
    {
        {
            Preferences preferences;
            preferences.windowGeometry.set("geometry"); // as a window that closes does
            preferences.windowState.set("state");
        }
        QVERIFY(test::filesIn(folder()).value(QFileInfo(file()).fileName()).contains("geometry"));
        Preferences nothing;
        QSignalSpy failures(&nothing, &Preferences::failed);
        QVERIFY(QFile::remove(file()));
        nothing.restoreDefaults(); // there is nothing to write
        QTRY_VERIFY(hasTried(nothing));
        QCOMPARE(failures.count(), 0);
    }
};

RAMURE_SUITE(TestPreferences)

} // namespace tst_preferences

#include "tst_preferences.moc"
