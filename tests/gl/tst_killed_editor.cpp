// kill -9 of the real window in the middle of edits and of saving: the project always opens, what was kept
// aside is offered at the next start and comes back, and nothing stays lying about. RAMURE_KILLS says how
// many times.
#include "core/math/random.h"
#include "core/presets/presets.h"
#include "core/qt/session/jobs/autosave.h"
#include "tests/gl/desk.h"
#include "tests/support/cannot_run.h"
#include "tests/support/waits.h"
#include <QDateTime>
#include <QDir>
#include <QFile>

namespace tst_killed_editor {

using namespace ramure;
using test::Editor;
using test::eventually;

namespace {

const QString mainWindow = QStringLiteral("Ramure$");
const QString question = QStringLiteral("^Recover unsaved work");
constexpr int usualKills = 20;

std::int64_t seedOf(const Project& project)
{
    return project.scene.nodes().front().params.grammar.seed;
}

} // namespace

class TestKilledEditor : public QObject
{
    Q_OBJECT
public:
    static void initMain()
    {
        if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
            qputenv("QTEST_FUNCTION_TIMEOUT", "3600000"); // a hundred starts on a slow machine
    }

private:
    QTemporaryDir m_home;
    QTemporaryDir m_work;
    std::unique_ptr<test::Desk> m_desk;
    Random m_random{3, RandomStream::Test};
    int m_questions = 0;
    int m_parts = 0; ///< halves of files that a kill left beside the project

    [[nodiscard]] QString project() const { return m_work.filePath(QStringLiteral("oak.ramure")); }
    [[nodiscard]] QString recoveryFolder() const
    {
        return m_home.filePath(QStringLiteral("Ramure/ramure/recovery"));
    }
    /// The largest number that is safe on the disk, in the project or aside.
    std::int64_t safe()
    {
        std::int64_t best = 0;
        QStringList files{project()};
        for (const QFileInfo& file :
             QDir(recoveryFolder()).entryInfoList({QStringLiteral("*.ramure")}, QDir::Files))
            files += file.filePath();
        for (const QString& path : files) {
            const auto read = loadProjectFile(path);
            if (read) // a recovery file may just have been taken away
                best = std::max(best, seedOf(*read));
        }
        return best;
    }
    int below(int count) { return static_cast<int>(m_random.below(static_cast<std::uint32_t>(count))); }

    /// Starts the editor with the project; where the last one was killed with work kept aside it must ask,
    /// and brings that work back. Then everything is saved.
    void startAndRecover(Editor& editor)
    {
        std::size_t lost = 0;
        std::int64_t kept = safe();
        {
            const auto found = recoverableProjects(recoveryFolder()); // the claims end here
            lost = found.size();
            // A kill between saving and clearing away leaves older work aside: the question says so.
            if (lost == 1 && found.front().savedLater.isValid())
                kept = seedOf(*loadRecoverable(found.front()));
        }
        QVERIFY(lost <= 1);
        editor.start({project()});
        if (lost == 1) {
            QVERIFY(editor.waitForWindow(question));
            ++m_questions;
            QVERIFY(Editor::keysUntil({QStringLiteral("Return")},
                                      [&] { return editor.window(question).isEmpty(); }));
        }
        QVERIFY(editor.waitForWindow(QStringLiteral("^oak.ramure.*Ramure$")));
        test::stillPicture(editor.place(mainWindow)); // it listens
        // A search for windows now and then finds none: the file itself says when it is saved.
        const auto isSaved = [&] {
            const auto opened = loadProjectFile(project());
            return opened && seedOf(*opened) == kept;
        };
        if (lost == 1) {
            QVERIFY(eventually([&] { return !editor.window(QStringLiteral("\\*")).isEmpty(); })); // not saved
            QVERIFY(Editor::keysUntil({QStringLiteral("ctrl+s")}, isSaved));
        }
        QVERIFY(isSaved());
    }
    /// One number after the other, each an edit, until the machine dies.
    void workAndDie(Editor& editor, int round)
    {
        const std::int64_t first = safe();
        Editor::keys({QStringLiteral("ctrl+f")});
        Editor::type(QStringLiteral("grammar.seed"));
        Editor::keys({QStringLiteral("Return")});
        const int edits = 1 + below(6);
        std::int64_t seen = first;
        for (int i = 0; i < edits; ++i) {
            Editor::keys({QStringLiteral("Up")});
            seen = std::max(seen, safe());
        }
        if (round % 3 == 0) { // while saving
            Editor::keys({QStringLiteral("ctrl+s")});
            test::anyMoment(below(60));
        } else if (round % 3 == 1) { // between two of the files kept aside
            test::anyMoment(below(500));
        } else { // everything has been kept aside, without a hand
            QVERIFY(eventually([&] { return safe() == first + edits; }));
        }
        seen = std::max(seen, safe());
        editor.kill();
        m_parts += static_cast<int>(QDir(m_work.path()).entryList({QStringLiteral("*.new-*")}).size());
        const auto left = loadProjectFile(project());
        QVERIFY2(left, test::why(left).constData());
        QVERIFY2(safe() >= seen && safe() <= first + edits,
                 qPrintable(QStringLiteral("%1 was safe, %2 is there").arg(seen).arg(safe())));
    }

private slots:
    void initTestCase()
    {
        if (const QString missing = test::Desk::missing(); !missing.isEmpty())
            RAMURE_CANNOT_RUN(qPrintable(missing + QStringLiteral(" is not installed")));
        test::prepareHome(m_home, 0.005);
        Scene scene;
        Node tree;
        tree.id = scene.newId();
        tree.kind = NodeKind::Tree;
        tree.name = "Oak";
        tree.params = *presetParams("TinyTree");
        tree.params.grammar.stochastic = true; // its seed can be edited
        QVERIFY(scene.insert({tree}, noNode, 0));
        QVERIFY(saveProjectFile({std::move(scene), {}}, project()));
        m_desk = std::make_unique<test::Desk>();
    }
    void init() { test::failOnAnyWarning(); }
    void cleanupTestCase() { m_desk.reset(); }

    void killedAgainAndAgain()
    {
        bool given = false;
        const int asked = qEnvironmentVariableIntValue("RAMURE_KILLS", &given);
        const int kills = given ? asked : usualKills;
        for (int round = 0; round < kills; ++round) {
            Editor editor(m_home.path());
            startAndRecover(editor);
            if (QTest::currentTestFailed())
                return;
            workAndDie(editor, round);
            if (QTest::currentTestFailed())
                return;
        }
        qInfo("killed %d times: the project always opened, work was offered and came back %d times, %d "
              "halves of files",
              kills, m_questions, m_parts);
        QVERIFY(m_questions > 0 || kills < 3);
    }

    void whatTheKillsLeftIsClearedAway()
    {
        // As if some time had passed: whatever a program that is alive writes is younger.
        for (const QFileInfo& part :
             QDir(m_work.path()).entryInfoList({QStringLiteral("*.new-*")}, QDir::Files)) {
            QFile file(part.filePath());
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-60),
                                     QFileDevice::FileModificationTime));
        }
        Editor editor(m_home.path());
        startAndRecover(editor);
        if (QTest::currentTestFailed())
            return;
        QVERIFY(editor.quit());
        QCOMPARE(QDir(m_work.path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList{QStringLiteral("oak.ramure")});
        QCOMPARE(QDir(recoveryFolder()).entryList(QDir::Files | QDir::Hidden), QStringList());
    }
};

RAMURE_SUITE(TestKilledEditor)

} // namespace tst_killed_editor

#include "tst_killed_editor.moc"
