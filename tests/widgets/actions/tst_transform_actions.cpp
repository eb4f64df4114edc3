#include "tests/widgets/base/fixture.h"
#include "widgets/actions/tool_settings_dialog.h"
#include "widgets/actions/transform_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/viewport_host.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>

namespace tst_transform_actions {

using namespace ramure;

/// The tools' buttons, menus and settings. Without OpenGL they are there and cannot be used.
class TestTransformActions : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        open();
    }
    void cleanup() { m_window.reset(); }

    void withoutAViewNothingCanBeUsed()
    {
        for (const char* id : {"tool.move", "transform.rotate", "view.path", "tool.local", "tool.snap"})
            QVERIFY(!action(id)->isEnabled());
        QVERIFY(action("tool.settings")->isEnabled());
    }
    void keysAreNobodyElses()
    {
        QMap<QString, QString> owners;
        for (const QAction* each : m_set->actions())
            for (const QKeySequence& keys : each->shortcuts()) {
                QVERIFY2(!owners.contains(keys.toString()), qPrintable(keys.toString()));
                owners.insert(keys.toString(), each->objectName());
            }
        QCOMPARE(owners.value(QStringLiteral("G")), QStringLiteral("transform.move"));
        QCOMPARE(owners.value(QStringLiteral("E")), QStringLiteral("tool.rotate"));
    }
    void buttonsFollowTheSettings()
    {
        gizmo()->tool.set(TransformTool::Rotate);
        QVERIFY(action("tool.rotate")->isChecked());
        QVERIFY(!action("tool.select")->isChecked());
        action("tool.scale")->setEnabled(true);
        action("tool.scale")->trigger();
        QCOMPARE(gizmo()->tool(), TransformTool::Scale);
        gizmo()->space.set(TransformSpace::Local);
        QVERIFY(action("tool.local")->isChecked());
        auto* box = m_window->findChild<QComboBox*>(QStringLiteral("transformSpace"));
        QCOMPARE(box->currentText(), QStringLiteral("Local"));
        emit box->activated(1);
        QCOMPARE(gizmo()->space(), TransformSpace::Parent);
        QCOMPARE(box->currentText(), QStringLiteral("Parent"));
    }
    /// Sizes are the user's, what is switched on belongs to the document.
    void stepsAreRememberedAndSwitchesAreNot()
    {
        gizmo()->setSteps({0.5, 30.0, 0.25});
        gizmo()->setGhostFrames({3, 4, 2});
        gizmo()->showsGhosts.set(true);
        gizmo()->space.set(TransformSpace::Local);
        open();
        QCOMPARE(gizmo()->steps(), (SnapSteps{0.5, 30.0, 0.25}));
        QVERIFY(gizmo()->ghostFrames() == (GhostFrames{3, 4, 2}));
        QVERIFY(!gizmo()->showsGhosts());
        QVERIFY(!action("view.ghosts")->isChecked());
        QCOMPARE(gizmo()->space(), TransformSpace::World);
    }
    void anglesAreThoseOfThePreferences()
    {
        QVERIFY(!gizmo()->radians());
        m_preferences->angleUnit.set(AngleUnit::Radians);
        QVERIFY(gizmo()->radians());
    }
    void theDialogAppliesAtOnce()
    {
        action("tool.settings")->trigger();
        auto* dialog = m_window->findChild<ToolSettingsDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        dialog->findChild<QDoubleSpinBox*>(QStringLiteral("turnStep"))->setValue(15.0);
        dialog->findChild<QSpinBox*>(QStringLiteral("ghostsBefore"))->setValue(1);
        QCOMPARE(gizmo()->steps(), (SnapSteps{0.1, 15.0, 0.1}));
        QCOMPARE(gizmo()->ghostFrames().before, 1);
        gizmo()->setSteps({2.0, 15.0, 0.1});
        QCOMPARE(dialog->findChild<QDoubleSpinBox*>(QStringLiteral("moveStep"))->value(), 2.0);
        for (QWidget* field : dialog->findChildren<QAbstractSpinBox*>())
            QVERIFY(!field->toolTip().isEmpty());
        action("tool.settings")->trigger(); // one is enough
        QCOMPARE(m_window->findChildren<ToolSettingsDialog*>().size(), 1);
    }

private:
    void open()
    {
        m_window.reset();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_window = std::make_unique<QMainWindow>();
        m_host = new ViewportHost(m_document.get(), m_window.get());
        m_set = new ActionSet(m_window.get());
        auto* actions = new TransformActions(m_host, m_preferences.get(), m_set, m_window.get());
        actions->fillMenu(new QMenu(m_window.get()));
        actions->fillToolBar(m_window->addToolBar(QString()));
        m_window->show();
    }
    [[nodiscard]] QAction* action(const char* id) const { return m_set->find(QLatin1String(id)); }
    [[nodiscard]] GizmoSettings* gizmo() const { return m_host->settings()->gizmo(); }

    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<QMainWindow> m_window;
    ViewportHost* m_host = nullptr;
    ActionSet* m_set = nullptr;
};

RAMURE_SUITE(TestTransformActions)

} // namespace tst_transform_actions

#include "tst_transform_actions.moc"
