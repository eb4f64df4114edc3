#include <QtGlobal>
// The program's table, to which the test gives a row more.
#define panels programPanels
#include "widgets/window/panels.cpp"
#undef panels

#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/help/help_places.h"
#include "widgets/window/main_window.h"
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <vector>

namespace ramure {

static QWidget* makeFake(const PanelServices& services, QWidget* parent)
{
    return services.document && services.player ? new QLabel(parent) : nullptr;
}

std::span<const PanelRow> panels();
std::span<const PanelRow> panels()
{
    static const std::vector<PanelRow> rows = [] {
        std::vector<PanelRow> made(programPanels().begin(), programPanels().end());
        made.push_back({"fakeDock", "Fake", PanelPlace::Bottom, "window#fake", &makeFake});
        return made;
    }();
    return rows;
}

} // namespace ramure

using namespace ramure;

/// A row of the table is a dock with its title, tab, action, menu and help: nothing else is told of it.
class TestPanels : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    test::FakeChooser m_chooser;
    MainWindow m_window{&m_document, &m_recompute, &m_preferences, &m_chooser};

    QDockWidget* dock(const char* name)
    {
        return m_window.findChild<QDockWidget*>(QString::fromLatin1(name));
    }

private slots:
    void init() { test::failOnWidgetWarning(); }

    void everyRowIsADock()
    {
        for (const PanelRow& row : panels()) {
            QVERIFY2(dock(row.dock), row.dock);
            QCOMPARE(dock(row.dock)->windowTitle(), QString::fromLatin1(row.title));
            QCOMPARE(helpPlace(dock(row.dock)->widget()), QString::fromLatin1(row.help));
            const QAction* action =
                m_window.actionSet()->find(QStringLiteral("view.panel.") + QLatin1String(row.dock));
            QVERIFY2(action && !action->associatedObjects().isEmpty(), row.dock);
        }
        QCOMPARE(m_window.findChildren<QDockWidget*>().size(), qsizetype(panels().size()));
    }
    void itStandsInItsPlace()
    {
        QVERIFY(qobject_cast<QLabel*>(dock("fakeDock")->widget()));
        QCOMPARE(m_window.dockWidgetArea(dock("fakeDock")), Qt::BottomDockWidgetArea);
        QVERIFY(m_window.tabifiedDockWidgets(dock("fakeDock")).contains(dock("keysDock")));
        QVERIFY(m_window.tabifiedDockWidgets(dock("armDock")).contains(dock("propertiesDock")));
        QVERIFY(m_window.tabifiedDockWidgets(dock("historyDock")).contains(dock("sceneDock")));
    }
    /// Panels stand behind each other: however many there are, the window is no higher.
    void theWindowFitsTheScreen()
    {
        m_window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&m_window));
        const int high = m_window.screen()->availableSize().height() * 19 / 20; // with room for a title bar
        QCOMPARE(m_window.height(), high);
        m_window.resetLayout();
        QCoreApplication::processEvents();
        QCOMPARE(m_window.height(), high);
        m_window.hide();
    }
    /// 1366 x 768, less a taskbar of 40 pixels and a title bar of 28.
    void theWindowFitsALaptopWhateverIsInFront()
    {
        const Theme theme(qApp, &m_preferences); // its style sheet has the margins
        Node tree = test::treeNode(1, "oak");
        tree.params.grammar.iterations = 8; // its limbs cross: the validation panel has much to tell
        test::openNodes(m_document, {tree});
        m_window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&m_window));
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
        QTRY_COMPARE_WITH_TIMEOUT(m_window.findChild<Analysis*>()->state(1), Analysis::State::Done,
                                  test::patience(20'000));
        for (const PanelRow& row : panels()) {
            dock(row.dock)->raise();
            QTRY_VERIFY(dock(row.dock)->x() >= 0);
            QCoreApplication::processEvents();
            m_window.resize(1366, 700);
            QVERIFY2(m_window.size() == QSize(1366, 700), row.dock);
        }
        m_window.hide();
        qApp->setStyleSheet({});
    }
    void theLayoutBringsItBack()
    {
        dock("fakeDock")->setFloating(true);
        dock("fakeDock")->hide();
        m_window.resetLayout();
        QVERIFY(!dock("fakeDock")->isFloating() && !dock("fakeDock")->isHidden());
    }
};

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
