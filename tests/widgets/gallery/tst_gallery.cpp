// Every panel and dialog in both languages, light and dark, at 1x and 2x: no text is cut off or faint, and
// every control has a name and is reached by Tab. With RAMURE_PICTURES set to a folder the pictures are
// written there, to be looked at.
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/kinds/node_kinds.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/gallery/access.h"
#include "widgets/actions/dialog_chooser.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/help_actions.h"
#include "widgets/actions/tool_settings_dialog.h"
#include "widgets/base/action_set.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/dialogs/about_dialog.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/palette/palette.h"
#include "widgets/dialogs/preferences_dialog.h"
#include "widgets/dialogs/recovery_dialog.h"
#include "widgets/dialogs/shortcuts_dialog.h"
#include "widgets/help/handbook_window.h"
#include "widgets/panels/arm/arm_panel.h"
#include "widgets/panels/inspector/branch_inspector.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/properties/group_section.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/panels/scene/isolation.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/scene/scene_search.h"
#include "widgets/panels/scene/scene_tree.h"
#include "widgets/window/main_window.h"
#include <QHeaderView>
#include <functional>

namespace tst_gallery {

using namespace ramure;

constexpr int patienceMs = test::patience(60'000);

class TestGallery : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language;
    std::unique_ptr<Theme> m_theme;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<MainWindow> m_window;
    QString m_look; ///< "fr-dark": part of the pictures' names
    QStringList m_wrong;

    QAction* action(const char* id) { return m_window->actionSet()->find(QString::fromLatin1(id)); }
    template <class T> T* dock(const char* name)
    {
        return m_window->findChild<QDockWidget*>(QString::fromLatin1(name))->findChild<T*>();
    }
    void selectBranches(const std::vector<Index>& branches)
    {
        Selection selection;
        selection.branchNode = m_document->scene().nodes().front().id;
        selection.branches = branches;
        selection.activeBranch = branches.back();
        m_document->setSelection(selection);
    }
    /// Checks what is shown and, where pictures are wanted, keeps one.
    void look(QWidget* window, const char* name)
    {
        QCoreApplication::processEvents(); // layouts that wait for the event loop
        QCoreApplication::sendPostedEvents();
        for (const QString& wrong : test::misfits(window) + test::inaccessible(window))
            m_wrong += QStringLiteral("%1 %2: %3").arg(m_look, QLatin1String(name), wrong);
        const QString folder = qEnvironmentVariable("RAMURE_PICTURES");
        if (folder.isEmpty())
            return;
        const QString scale = QString::number(qRound(window->devicePixelRatioF()));
        const QString path =
            QStringLiteral("%1/%2-%3-%4x.png").arg(folder, QLatin1String(name), m_look, scale);
        QVERIFY2(window->grab().save(path), qPrintable(path));
    }
    void show(QWidget& dialog, const char* name)
    {
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, patienceMs));
        look(&dialog, name);
    }
    /// A menu or dialog with an event loop of its own: looked at from within, then closed.
    void lookInto(const char* name, const std::function<void()>& open)
    {
        bool seen = false;
        QTimer closer;
        connect(&closer, &QTimer::timeout, this, [&] {
            QWidget* shown = QApplication::activePopupWidget();
            if (!shown)
                shown = QApplication::activeModalWidget();
            if (!shown || seen)
                return;
            seen = true;
            look(shown, name);
            shown->close();
        });
        closer.start(10);
        open();
        QVERIFY2(seen, name);
    }
    void raise(const char* name)
    {
        auto* panel = m_window->findChild<QDockWidget*>(QString::fromLatin1(name));
        panel->show();
        panel->raise();
    }
    void openMenus(const QList<QAction*>& actions, const QString& path)
    {
        for (QAction* each : actions) {
            QMenu* menu = each->menu();
            if (!menu)
                continue;
            menu->popup(QPoint(0, 0));
            const QString name =
                path + QString(each->text()).remove(QRegularExpression(QStringLiteral("\\W")));
            look(menu, name.toLatin1().constData());
            menu->close();
            openMenus(menu->actions(), name + u'-');
        }
    }
    void panels()
    {
        look(m_window.get(), "window");
        raise("historyDock");
        look(m_window.get(), "history");
        raise("sceneDock");
        auto* scene = m_window->scenePanel();
        for (const auto column : {SceneModel::RadiusColumn, SceneModel::OrderColumn})
            scene->chooseColumn(column, true);
        scene->view()->expandAll();
        selectBranches({1, 2});
        raise("inspectorDock");
        look(m_window.get(), "inspector");
        lookInto("scene-menu", [&] { emit scene->view()->customContextMenuRequested(QPoint(20, 20)); });
        lookInto("scene-columns",
                 [&] { emit scene->view()->header()->customContextMenuRequested(QPoint(20, 5)); });
        m_window->isolation()->toggleSelected();
        look(m_window.get(), "isolated");
        m_window->isolation()->clear();
        raise("validationDock");
        raise("levelsDock");
        auto* levels = dock<LevelsPanel>("levelsDock")->watch();
        QTRY_VERIFY_WITH_TIMEOUT(levels->state() == LevelWatch::State::Done, patienceMs);
        look(m_window.get(), "levels");
        raise("validationDock");
        scene->search()->field()->setText(QStringLiteral("length > 0.1"));
        look(m_window.get(), "validation-found");
        scene->search()->field()->setText(QStringLiteral("length >"));
        look(m_window.get(), "search-wrong");
        scene->search()->clear();
        for (const auto column : {SceneModel::RadiusColumn, SceneModel::OrderColumn})
            scene->chooseColumn(column, false);
        raise("inspectorDock");
        m_document->setSelection({});
        look(m_window.get(), "inspector-empty");
        raise("propertiesDock");
        m_window->banner()->showMessage(
            Severity::Warning, QStringLiteral("“/home/someone/trees/a file with a long name.ramure”"));
        look(m_window.get(), "properties-nothing");
        m_window->banner()->hide();
        arm();
    }
    /// The panel of joints, one with limits and keys.
    void arm()
    {
        raise("armDock");
        look(m_window.get(), "arm-none");
        action("edit.addArm")->trigger();
        const NodeId id = m_document->selection().activeNode();
        auto* panel = dock<ArmPanel>("armDock");
        panel->addJoint();
        std::vector<ArmJoint> joints = m_document->scene().find(id)->params.joints;
        joints[1].theta = {0.4, true, -1.0, 1.0, 2.0};
        QVERIFY(edit::setJoints(*m_document, id, joints, QStringLiteral("x")));
        QVERIFY(edit::insertKeys(*m_document, {id}, jointChannels(1), 0));
        panel->chooseJoint(1);
        look(m_window.get(), "arm");
        ArmPanel whole(m_document.get());
        whole.resize(380, 760);
        show(whole, "arm-panel");
        whole.resize(whole.minimumSizeHint().width(), 760);
        look(&whole, "arm-panel-narrow");
        m_document->history().goToStep(0);
        m_document->setSelection({});
    }
    /// All groups unfolded, advanced rows too, a wrong grammar with its message: as long as the panel gets.
    void properties()
    {
        PropertiesPanel panel(m_document.get(), m_preferences.get());
        Selection selection;
        selection.nodes = {m_document->scene().nodes().front().id};
        m_document->setSelection(selection);
        for (GroupSection* section : panel.findChildren<GroupSection*>()) {
            section->setFolded(false);
            if (auto* more = section->findChild<QToolButton*>(QStringLiteral("advanced"));
                more && !more->isHidden())
                more->click();
        }
        panel.resize(380, 2200);
        show(panel, "properties");
        panel.resize(panel.minimumSizeHint().width(), 2600);
        look(&panel, "properties-narrow");
        BranchInspector inspector(m_document.get());
        selectBranches({1, 2});
        inspector.resize(inspector.minimumSizeHint().width(), 900);
        show(inspector, "inspector-narrow");
        m_document->setSelection(selection);
    }
    void dialogs()
    {
        PreferencesDialog preferences(m_preferences.get());
        show(preferences, "preferences");
        QList<QMenu*> menus;
        for (const QAction* top : m_window->menuBar()->actions())
            menus += top->menu();
        ShortcutsDialog shortcuts(m_window->actionSet(), menus, m_preferences.get());
        shortcuts.select(QStringLiteral("view.frameAll"));
        show(shortcuts, "shortcuts");
        m_window->actionSet()->find(QStringLiteral("tool.settings"))->trigger();
        auto* steps = m_window->findChild<ToolSettingsDialog*>();
        look(steps, "steps");
        steps->close();
        AboutDialog about;
        show(about, "about");
        ExportDialog exporting(m_document.get(), m_recompute.get(), m_preferences.get(), &m_chooser);
        show(exporting, "export");
        exporting.moments()->setMoment(ExportMoment::Sequence);
        look(&exporting, "export-sequence");
        exporting.setUse(ExportUse::Game);
        look(&exporting, "export-game");
        exporting.setUse(ExportUse::Print);
        look(&exporting, "export-print");
        exporting.setUse(ExportUse::Web);
        look(&exporting, "export-web");
        exporting.setPictureLook({});
        exporting.setFormat(QStringLiteral("png"));
        exporting.moments()->setMoment(ExportMoment::Turntable);
        look(&exporting, "export-pictures");
        HandbookWindow handbook;
        handbook.showPlace(QStringLiteral("parameters#turtle.theta"));
        handbook.findChild<QLineEdit*>()->setText(QStringLiteral("angle"));
        show(handbook, "handbook");
        m_window->help()->showPalette();
        look(m_window->help()->palette(), "palette");
        m_window->help()->palette()->close();
        const QDateTime then(QDate(2024, 12, 31), QTime(23, 59));
        RecoveryDialog recovery(
            {{QStringLiteral("/home/someone/trees/oak.ramure"), then}, {QString(), then}});
        show(recovery, "recovery");
        DialogChooser asking;
        asking.setWindow(m_window.get(), m_window->banner());
        lookInto("unsaved",
                 [&] { QVERIFY(asking.unsavedChanges(QStringLiteral("oak")) == Chooser::Unsaved::Cancel); });
        lookInto("save-as", [&] {
            QCOMPARE(asking.saveFile(QStringLiteral("x"), QStringLiteral("oak.ramure"),
                                     QStringLiteral("Ramure (*.ramure)"), QStringLiteral("ramure")),
                     QString());
        });
        lookInto("open", [&] {
            QCOMPARE(asking.openFile(QStringLiteral("x"), QString(), QStringLiteral("Ramure (*.ramure)")),
                     QString());
        });
    }

private slots:
    void looks_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("dark");
        for (const char* language : {"en", "fr"})
            for (const bool dark : {false, true})
                QTest::addRow("%s-%s", language, dark ? "dark" : "light")
                    << QString::fromLatin1(language) << dark;
    }
    void looks()
    {
        QFETCH(const QString, language);
        QFETCH(const bool, dark);
        test::failOnWidgetWarning();
        m_look = QString::fromLatin1(QTest::currentDataTag());
        m_wrong.clear();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_preferences->language.set(language);
        m_preferences->theme.set(dark ? ThemeChoice::Dark : ThemeChoice::Light);
        m_preferences->addRecentFile(QStringLiteral("/home/someone/trees/oak.ramure"));
        m_language = std::make_unique<Language>(*m_preferences);
        m_theme = std::make_unique<Theme>(qApp, m_preferences.get());
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("TinyTree")));
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patienceMs));
        QVERIFY(m_recompute->waitForFull(patienceMs));
        m_window->showWelcome();
        look(m_window.get(), "welcome");
        m_window->showWelcome();
        for (auto* welcome : m_window->findChildren<QFrame*>(QStringLiteral("welcome")))
            welcome->hide();
        m_window->edits()->addKind(kindRow(NodeKind::Group));
        m_document->undo();
        panels();
        openMenus(m_window->menuBar()->actions(), QStringLiteral("menu-"));
        properties();
        dialogs();
        for (const QString& wrong : m_wrong)
            qInfo("%s", qPrintable(wrong));
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_theme.reset();
        m_language.reset();
        QCOMPARE(m_wrong.size(), 0);
    }

    /// The same on a display with twice as many pixels: another program, because the scale is set at its
    /// start.
    void atTwoPixelsForOne()
    {
        if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
            return; // this is it
        QProcess again;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2"));
        again.setProcessEnvironment(environment);
        again.setProcessChannelMode(QProcess::MergedChannels);
        again.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("tst_gallery"), QStringLiteral("looks")});
        QVERIFY(again.waitForFinished(600'000));
        QByteArray wrong; // alone: a message has room for few lines
        for (const QByteArray& line : again.readAllStandardOutput().split('\n'))
            if (line.startsWith("QINFO") || line.startsWith("FAIL"))
                wrong += line + '\n';
        QVERIFY2(again.exitCode() == 0, wrong.constData());
    }
};

RAMURE_SUITE(TestGallery)

} // namespace tst_gallery

#include "tst_gallery.moc"
