#include "tests/support/failing_disk.h"
#include "tests/support/waits.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/recovery.h"
#include "widgets/dialogs/recovery_dialog.h"

namespace tst_recovery {

using namespace ramure;

namespace {

/// Answers the questions about recovery one after the other.
class RecoveryChooser : public test::FakeChooser
{
public:
    RecoveryAnswer recovery(const QList<RecoveryEntry>& entries) override
    {
        asked += entries;
        return answers.isEmpty() ? RecoveryAnswer{} : answers.takeFirst();
    }
    QList<RecoveryAnswer> answers;
    QList<QList<RecoveryEntry>> asked;
};

using Action = RecoveryAnswer::Action;

} // namespace

class TestRecovery : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    Preferences m_preferences;
    RecoveryChooser m_chooser;

    [[nodiscard]] QStringList files() const
    {
        return QDir(m_folder->path()).entryList({QStringLiteral("*.ramure")}, QDir::Files);
    }
    /// What a killed program leaves: the file without its lock.
    void leaveBehind(const QString& file, const std::string& tree)
    {
        Document document;
        test::openNodes(document, {test::treeNode(1, tree)});
        document.setFilePath(file);
        document.markModified();
        Autosave autosave(&document, m_folder->path());
        const auto done = autosave.saveNow();
        QVERIFY2(done, test::why(done).constData());
        const QString kept = m_folder->filePath(QString::fromStdString(tree) + QStringLiteral(".ramure"));
        QVERIFY(QFile::copy(autosave.recoveryPath(), kept));
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_folder = std::make_unique<QTemporaryDir>();
        m_chooser.answers.clear();
        m_chooser.asked.clear();
        m_chooser.reports.clear();
    }

    void nothingLeftNothingAsked()
    {
        QFile broken(m_folder->filePath(QStringLiteral("broken.ramure")));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("{");
        broken.close();
        Document document;
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        QVERIFY(!recovery.offer());
        QVERIFY(m_chooser.asked.isEmpty());
    }

    void whatCannotBeWrittenIsTold()
    {
        QFile file(m_folder->filePath(QStringLiteral("file")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        Document document;
        test::openNodes(document, {test::treeNode(1, "Oak")});
        Recovery recovery(&document, &m_preferences, &m_chooser,
                          m_folder->filePath(QStringLiteral("file/x")));
        document.markModified();
        recovery.autosave()->setInterval(1);
        QTRY_COMPARE(m_chooser.reports.size(), 1);
        test::letHappen(20);
        QCOMPARE(m_chooser.reports.size(), 1); // not at every attempt
        QVERIFY(file.remove());
        QTRY_COMPARE(m_chooser.reports.size(), 2);
        QVERIFY(m_chooser.reports.last().contains(QStringLiteral("again")));
    }

    void whatIsRecoveredStaysWhereItCannotBeKeptAside()
    {
        leaveBehind({}, "Oak");
        Document document;
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        m_chooser.answers = {{Action::Recover, 0}};
        {
            const test::SmallDisk disk(0);
            QVERIFY(recovery.offer());
        }
        QCOMPARE(document.scene().nodes().front().name, std::string("Oak"));
        QVERIFY(document.isModified());
        QCOMPARE(m_chooser.reports.size(), 1);
        QCOMPARE(files(), QStringList(QStringLiteral("Oak.ramure"))); // for the next start
    }

    void wrongAnswersDoNothing()
    {
        leaveBehind({}, "Oak");
        Document document;
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        m_chooser.answers = {{Action::Discard, 5}};
        QVERIFY(!recovery.offer());
        QCOMPARE(files().size(), 1);
    }

    void recoveredDocumentsAreModifiedAndKeptAside()
    {
        leaveBehind(QStringLiteral("/home/anna/oak.ramure"), "Oak");
        Document document;
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        m_chooser.answers = {{Action::Recover, 0}};
        QVERIFY(recovery.offer());
        QCOMPARE(m_chooser.asked.size(), 1);
        QCOMPARE(m_chooser.asked.front().front().file, QStringLiteral("/home/anna/oak.ramure"));
        QVERIFY(m_chooser.asked.front().front().time.isValid());
        QCOMPARE(document.scene().nodes().front().name, std::string("Oak"));
        QCOMPARE(document.filePath(), QStringLiteral("/home/anna/oak.ramure"));
        QVERIFY(document.isModified());
        QVERIFY(document.project().extras.empty()); // the note is gone
        // A second crash would find it again, under the name of this program.
        QCOMPARE(files(), QStringList(QFileInfo(recovery.autosave()->recoveryPath()).fileName()));
        document.markSaved(); // saved
        QVERIFY(files().isEmpty());
    }

    void discardingAsksAboutTheRest()
    {
        leaveBehind({}, "Oak");
        leaveBehind({}, "Elm");
        Document document;
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        m_chooser.answers = {{Action::Discard, 0}, {Action::Later, 0}};
        QVERIFY(!recovery.offer());
        QCOMPARE(m_chooser.asked.size(), 2);
        QCOMPARE(m_chooser.asked[1].size(), 1);
        QCOMPARE(files().size(), 1);
        QVERIFY(document.scene().empty());
        // Later means: at the next start.
        m_chooser.answers = {{Action::Recover, 0}};
        QVERIFY(recovery.offer());
    }

    void theIntervalFollowsThePreferences()
    {
        Document document;
        m_preferences.setAutosaveMinutes(0);
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        QCOMPARE(recovery.autosave()->interval(), 0);
        m_preferences.setAutosaveMinutes(5);
        QCOMPARE(recovery.autosave()->interval(), 300'000);
        m_preferences.restoreDefaults();
        QCOMPARE(recovery.autosave()->interval(), Preferences::defaultAutosaveMinutes * 60'000);
    }

    void savingWhileAFileIsOnItsWayLeavesNone()
    {
        Document document;
        test::openNodes(document, {test::treeNode(1, "Oak")});
        Recovery recovery(&document, &m_preferences, &m_chooser, m_folder->path());
        recovery.autosave()->setInterval(1);
        for (int i = 0; i < 50; ++i) {
            document.markModified();
            QVERIFY(edit::setParam(document, {1}, *findParam("grammar.seed"), std::int64_t(i + 2)));
            test::anyMoment(i % 4);
            document.markSaved();
        }
        recovery.autosave()->setInterval(0);
        test::letHappen(30); // what is on its way may still arrive, but goes then
        QTRY_VERIFY(files().isEmpty());
    }

    void theDialogSaysWhatWasChosen()
    {
        const QList<RecoveryEntry> entries = {
            {QStringLiteral("/home/anna/oak.ramure"), QDateTime::currentDateTimeUtc()},
            {QString(), QDateTime::currentDateTimeUtc()}};
        auto saved = entries;
        saved.last().savedLater = QDateTime::currentDateTimeUtc();
        QVERIFY(RecoveryDialog(entries).findChild<QTreeWidget*>()->isColumnHidden(3));
        QVERIFY(!RecoveryDialog(saved).findChild<QTreeWidget*>()->isColumnHidden(3));
        const std::pair<const char*, Action> buttons[] = {
            {"recover", Action::Recover}, {"discard", Action::Discard}, {"later", Action::Later}};
        for (const auto& [name, action] : buttons) {
            RecoveryDialog dialog(entries);
            QCOMPARE(dialog.answer().action, Action::Later); // closed by the window's cross
            auto* list = dialog.findChild<QTreeWidget*>();
            QCOMPARE(list->topLevelItem(0)->text(0), QStringLiteral("oak.ramure"));
            QCOMPARE(list->topLevelItem(1)->text(0), QStringLiteral("Untitled"));
            list->setCurrentItem(list->topLevelItem(1));
            dialog.findChild<QPushButton*>(QString::fromLatin1(name))->click();
            QCOMPARE(dialog.answer().action, action);
            QCOMPARE(dialog.answer().index, 1);
        }
    }
};

RAMURE_SUITE(TestRecovery)

} // namespace tst_recovery

#include "tst_recovery.moc"
