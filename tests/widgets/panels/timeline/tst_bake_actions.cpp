#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/baker.h"
#include "core/qt/session/motion/player.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include "widgets/window/main_window.h"
#include <QToolButton>

namespace tst_bake_actions {

using namespace ramure;

/// Baking from the window, and what the preferences say about motion.
class TestBakeActions : public QObject
{
    Q_OBJECT
private:
    static constexpr int patienceMs = test::patience(60'000);
    test::OwnSettings m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    test::FakeChooser m_chooser;
    std::unique_ptr<MainWindow> m_window;

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    QString path(const char* name) { return m_folder->filePath(QString::fromLatin1(name)); }
    bool settled(BakeState state)
    {
        return QTest::qWaitFor(
            [&] { return m_window->player()->bakeState() == state && !m_window->player()->isBusy(); },
            patienceMs);
    }
    void openWindow()
    {
        m_window.reset();
        m_recompute.reset();
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_recompute->setRest(0);
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        m_window->show();
    }
    void bakeOak()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("TinyTree")));
        QVERIFY(m_recompute->waitForFull(patienceMs));
        m_chooser.answer = path("oak.ramure");
        action("play.bake")->trigger();
        QVERIFY(settled(BakeState::Good));
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_chooser = {};
        m_folder = std::make_unique<QTemporaryDir>();
        m_preferences = std::make_unique<Preferences>();
        openWindow();
    }
    void cleanup()
    {
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
    }

    void withoutAFileNothingIsBaked()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("TinyTree")));
        QVERIFY(m_recompute->waitForFull(patienceMs));
        m_chooser.agreed = false;
        action("play.bake")->trigger(); // says why it has to be saved first; no
        QCOMPARE(m_chooser.saves, 0);
        QCOMPARE(m_chooser.reasons.size(), 1);
        m_chooser.agreed = true;
        action("play.bake")->trigger(); // asks where to save, and gets no answer
        QCOMPARE(m_chooser.saves, 1);
        QVERIFY(m_chooser.reports.isEmpty());
        QVERIFY(!action("play.freeBake")->isEnabled());
        m_chooser.answer = path("oak.ramure");
        QVERIFY(m_window->files()->save());
        QFile foreign(path("oak.motion-1.bake"));
        QVERIFY(foreign.open(QIODevice::WriteOnly) && foreign.write("a poem") == 6);
        foreign.close();
        action("play.bake")->trigger();
        QCOMPARE(m_chooser.reports.size(), 1);
        QVERIFY(m_chooser.reports[0].contains(QStringLiteral("oak.motion-1.bake")));
    }

    void bakedOpenedAndFreed()
    {
        bakeOak();
        auto* button = m_window->findChild<QToolButton*>(QStringLiteral("bakeButton"));
        QVERIFY(button->toolTip().startsWith(QStringLiteral("Baked")));
        QVERIFY(!m_document->isModified());
        QCOMPARE(bakeFiles(path("oak.ramure")), QStringList{path("oak.motion-1.bake")});
        openWindow();
        QVERIFY(m_window->files()->openFile(path("oak.ramure")));
        QVERIFY(settled(BakeState::Good));
        QCOMPARE(m_window->player()->band(), (std::vector<FrameRange>{{0, 250, FrameState::Cached}}));
        QVERIFY(m_chooser.reports.isEmpty());
        QVERIFY(action("play.freeBake")->isEnabled());
        action("play.freeBake")->trigger();
        QVERIFY(settled(BakeState::None));
        QVERIFY(!action("play.freeBake")->isEnabled());
        QVERIFY(bakeFiles(path("oak.ramure")).isEmpty());
    }

    void aDamagedFileIsNamed()
    {
        bakeOak();
        QFile file(path("oak.motion-1.bake"));
        QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(file.size() / 2) && file.write("XXXX") == 4);
        file.close();
        openWindow();
        QVERIFY(m_window->files()->openFile(path("oak.ramure")));
        QVERIFY(settled(BakeState::Stale));
        QTRY_COMPARE(m_chooser.reports.size(), 1);
        QVERIFY(m_chooser.reports[0].contains(QStringLiteral("oak.motion-1.bake")));
        QVERIFY(m_chooser.reports[0].contains(QStringLiteral("damaged")));
    }

    void preferencesActAtOnce()
    {
        m_preferences->setMotionMemoryMb(128);
        QCOMPARE(m_window->player()->memoryLimit(), std::size_t(128) << 20);
        m_preferences->timeDisplay.set(TimeDisplay::Timecode);
        QCOMPARE(m_window->timeline()->display(), TimeDisplay::Timecode);
        m_window->timeline()->setDisplay(TimeDisplay::Seconds);
        QCOMPARE(m_preferences->timeDisplay(), TimeDisplay::Seconds);
        openWindow();
        QCOMPARE(m_window->timeline()->display(), TimeDisplay::Seconds);
        QCOMPARE(m_window->player()->memoryLimit(), std::size_t(128) << 20);
    }
};

RAMURE_SUITE(TestBakeActions)

} // namespace tst_bake_actions

#include "tst_bake_actions.moc"
