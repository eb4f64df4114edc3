#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/gallery/text_fit.h"
#include "widgets/actions/help_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/help/callout.h"
#include "widgets/help/tour.h"
#include "widgets/window/main_window.h"

namespace tst_tour {

using namespace ramure;

class TestTour : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<MainWindow> m_window;

    Tour* tour() { return m_window->help()->tour(); }
    Callout* callout() { return m_window->findChild<Callout*>(QString(), Qt::FindDirectChildrenOnly); }
    bool isDone() { return callout()->findChild<QLabel*>(QStringLiteral("badge"))->isVisible(); }

private slots:
    void init() { open("en"); }
    void open(const char* language)
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_preferences->language.set(QLatin1String(language));
        m_language = std::make_unique<Language>(*m_preferences);
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        test::openNodes(*m_document, {test::treeNode(1, "oak")});
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    void cleanup()
    {
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_language.reset();
    }

    void itBeginsOnce()
    {
        QVERIFY(m_window->help()->startTourOnce());
        QVERIFY(tour()->isRunning());
        tour()->leave();
        QVERIFY(!m_window->help()->startTourOnce());
        QVERIFY(Preferences().tourSeen()); // also at the next start
        m_window->actionSet()->find(QStringLiteral("help.tour"))->trigger();
        QVERIFY(tour()->isRunning());
    }

    void returnGoesOnToTheEnd()
    {
        QSignalSpy finished(tour(), &Tour::finished);
        tour()->start();
        QTRY_VERIFY(callout()->hasFocus());
        for (int step = 0; step < Tour::stepCount(); ++step) {
            QCOMPARE(tour()->step(), step);
            QVERIFY(m_window->rect().contains(callout()->geometry()));
            QTest::keyClick(callout(), Qt::Key_Return);
        }
        QCOMPARE(Tour::stepCount(), 5);
        QVERIFY(!tour()->isRunning());
        QCOMPARE(finished.size(), 1);
    }

    void escapeAndSkipLeaveFromEverywhere()
    {
        tour()->start();
        QTest::keyClick(callout(), Qt::Key_Escape);
        QTRY_VERIFY(!tour()->isRunning());
        tour()->start();
        m_window->showParam(QStringLiteral("turtle.theta"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY(!tour()->isRunning());
        tour()->start();
        callout()->findChild<QPushButton*>(QStringLiteral("calloutLeave"))->click();
        QVERIFY(!tour()->isRunning());
    }

    /// The keys it speaks of work while it speaks, and are noticed.
    void whatItAsksForIsNoticed()
    {
        tour()->start();
        QTest::keyClick(callout(), Qt::Key_Return);
        QCOMPARE(tour()->step(), 1);
        QVERIFY(!isDone());
        QSignalSpy grown(m_window->actionSet()->find(QStringLiteral("edit.newTree")), &QAction::triggered);
        QTest::keyClick(callout(), Qt::Key_Space);
        QCOMPARE(grown.size(), 1);
        QVERIFY(isDone());
        QTest::keyClick(callout(), Qt::Key_Return);
        QVERIFY(!isDone());
        QVERIFY(edit::setParam(*m_document, {1}, *findParam("turtle.theta"), 0.2, 0));
        QVERIFY(isDone());
    }

    void textsFitInBothLanguagesAndThemes()
    {
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark})
            for (const char* code : {"en", "fr"}) {
                cleanup();
                open(code);
                const Theme theme(qApp, m_preferences.get());
                m_preferences->theme.set(choice);
                tour()->start();
                for (int step = 0; step < Tour::stepCount(); ++step) {
                    QCoreApplication::processEvents();
                    const QStringList wrong = test::misfits(callout());
                    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
                    QTest::keyClick(callout(), Qt::Key_Return);
                }
            }
    }
};

RAMURE_SUITE(TestTour)

} // namespace tst_tour

#include "tst_tour.moc"
