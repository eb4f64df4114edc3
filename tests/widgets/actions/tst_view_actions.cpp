#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/action_list.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/window/main_window.h"
#include <QMenu>
#include <QMenuBar>

namespace tst_view_actions {

using namespace ramure;

class TestViewActions : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    Preferences m_preferences;
    test::FakeChooser m_chooser;

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
    }

    void menusFitASmallScreen_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QStringLiteral("en");
        QTest::newRow("French") << QStringLiteral("fr");
    }
    /// Of 768 pixels, less the title and the menu bar; a higher menu gets a second column.
    void menusFitASmallScreen()
    {
        QFETCH(QString, language);
        constexpr int mostPixels = 700;
        m_preferences.language.set(language);
        const Language spoken(m_preferences);
        Document document;
        Recompute recompute(&document);
        MainWindow window(&document, &recompute, &m_preferences, &m_chooser);
        QList<QMenu*> menus;
        for (const QAction* top : window.menuBar()->actions()) {
            QMenu* menu = menus.emplace_back(top->menu());
            const QByteArray title = menu->title().toUtf8();
            menu->popup({});
            QVERIFY2(menu->height() <= mostPixels, title.constData());
            for (const QAction* action : menu->actions())
                QVERIFY2(menu->actionGeometry(const_cast<QAction*>(action)).left() < menu->width() / 2,
                         title);
            menu->close();
        }
        QStringList listed;
        for (const ListedAction& each : listedActions(*window.actionSet(), menus))
            listed += each.action->objectName();
        for (const char* id :
             {"view.mesh", "view.solid", "view.good", "view.leaves", "view.apples", "view.grid",
              "view.ground", "view.figure", "view.outline", "view.crowns", "view.orthographic", "view.path",
              "view.ghosts", "view.light", "view.skyPicture"})
            QVERIFY2(listed.contains(QLatin1String(id)), id);
    }
};

RAMURE_SUITE(TestViewActions)

} // namespace tst_view_actions

#include "tst_view_actions.moc"
