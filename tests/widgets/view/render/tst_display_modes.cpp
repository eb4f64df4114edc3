#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/render/display_mode.h"
#include "widgets/view/view_settings.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"

using namespace ramure;

static constexpr auto fakeMode = DisplayMode(7);
static constexpr auto fakeShading = ShadingMode(3);

/// In the place of the program's own tables: with a row that nothing else knows.
std::span<const DisplayModeRow> ramure::displayModes()
{
    static constexpr DisplayModeRow rows[] = {
        {{DisplayMode::Mesh, "view.mesh", "mode-mesh", "&Mesh", "The surface"},
         Shown::Surface,
         Stage::Foliage},
        {{fakeMode, "view.fake", "mode-rough", "&Fake", "Nothing at all"}, Shown::Lines, Stage::Simplified},
    };
    return rows;
}

std::span<const ModeRow<ShadingMode>> ramure::shadingModes()
{
    static constexpr ModeRow<ShadingMode> rows[] = {
        {ShadingMode::Solid, "view.solid", "solid", "S&olid", nullptr},
        {fakeShading, "view.fakeShading", "wire", "Fake shading", nullptr},
    };
    return rows;
}

std::span<const ModeRow<Quality>> ramure::qualities()
{
    static constexpr ModeRow<Quality> rows[] = {{Quality::Good, "view.good", nullptr, "Good", nullptr}};
    return rows;
}

/// A row of the tables is a name, an action with its key, and a choice of the view: nothing else is told of
/// it.
class TestDisplayModes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnWidgetWarning(); }

    void unknownNames()
    {
        QVERIFY(!displayModeFromName(""));
        QVERIFY(!displayModeFromName("Fake"));
        QVERIFY(!displayModeFromName("view.fake"));
    }
    void aRowHasItsName()
    {
        QCOMPARE(displayModeFromName("fake"), fakeMode);
        QCOMPARE(rowOf(fakeMode).stage, Stage::Simplified);
        QCOMPARE(shadingModes()[1].name(), "fakeShading");
    }
    void aRowIsAnActionOfTheWindow()
    {
        test::OwnSettings own;
        Preferences preferences;
        Document document;
        Recompute recompute(&document);
        test::FakeChooser chooser;
        MainWindow window(&document, &recompute, &preferences, &chooser);
        ViewSettings* settings = window.viewportHost()->settings();
        QAction* mode = window.actionSet()->find(QStringLiteral("view.fake"));
        QVERIFY(mode);
        QCOMPARE(mode->shortcut(), QKeySequence(Qt::ALT | Qt::Key_2));
        QVERIFY(mode->toolTip().contains(QStringLiteral("Nothing at all")));
        QVERIFY(!mode->isChecked());
        settings->displayMode.set(fakeMode);
        QVERIFY(mode->isChecked());
        QAction* mesh = window.actionSet()->find(QStringLiteral("view.mesh"));
        mesh->setEnabled(true); // off where there is no OpenGL
        mesh->trigger();
        QCOMPARE(settings->displayMode(), DisplayMode::Mesh);
        QAction* shading = window.actionSet()->find(QStringLiteral("view.fakeShading"));
        QVERIFY(shading);
        shading->setEnabled(true);
        shading->trigger();
        QCOMPARE(settings->shadingMode(), fakeShading);
        for (QAction* action : {mode, shading})
            QVERIFY2(!action->associatedObjects().isEmpty(), "it stands in a menu");
    }
};

QTEST_MAIN(TestDisplayModes)
#include "tst_display_modes.moc"
